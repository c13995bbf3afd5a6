// SPDX-License-Identifier: BSD-3-Clause
// The solution block of ocp_json.h.
#include <array>
#include <string>

#include "controller/mpc/problem/json_node.h"
#include "controller/mpc/problem/json_write.h"
#include "controller/mpc/problem/ocp_json.h"
#include "controller/mpc/problem/solution_shape.h"
#include "models/support/require.h"

namespace sidestep::mpc {
namespace {

using nlohmann::json;

/// Whether a block of this status carries numbers and trajectories.
bool HasTrajectories(SolveStatus status) {
  return IsUsable(status) || status == SolveStatus::kIterationLimit;
}

json ForcesToJson(const OcpContact& contact, const ContactSolution& part) {
  json forces = json::array();
  for (std::size_t k = 0; k < part.force_N.size(); ++k) {
    if (ActivePhase(contact, static_cast<int>(k)) >= 0) {
      forces.push_back(RowsOf(part.force_N[k]));
    } else {
      forces.push_back(json(static_cast<std::size_t>(contact.vertices_m.cols()), json()));
    }
  }
  return forces;
}

SolveStatus StatusFromJson(const JsonNode& node) {
  constexpr std::array kAll = {SolveStatus::kNotSolved,      SolveStatus::kSolved,
                               SolveStatus::kAcceptable,     SolveStatus::kInfeasible,
                               SolveStatus::kIterationLimit, SolveStatus::kNumericalError};
  const std::string name = node.String();
  std::string names;
  for (const SolveStatus status : kAll) {
    if (name == EnumName(status)) {
      return status;
    }
    names += (names.empty() ? "" : ", ") + std::string(EnumName(status));
  }
  node.Fail("one of " + names);
}

void ReadForces(const JsonNode& node, const OcpContact& contact, ContactSolution* part) {
  const std::size_t num_knots = part->force_N.size();
  if (node.ArraySize() != num_knots) {
    node.Fail("an array of " + std::to_string(num_knots) + " knots");
  }
  const auto num_vertices = static_cast<std::size_t>(contact.vertices_m.cols());
  for (std::size_t k = 0; k < num_knots; ++k) {
    if (ActivePhase(contact, static_cast<int>(k)) >= 0) {
      part->force_N[k] = node[k].Columns3(num_vertices);
      continue;
    }
    if (node[k].ArraySize() != num_vertices) {
      node[k].Fail("an array of " + std::to_string(num_vertices) + " nulls");
    }
    for (std::size_t j = 0; j < num_vertices; ++j) {
      if (!node[k][j].IsNull()) {
        node[k][j].Fail("null where the contact is inactive");
      }
    }
  }
}

void ReadContact(const JsonNode& node, const OcpContact& contact, ContactSolution* part) {
  node.RequireKeys({"name", "phases", "forces_N"});
  if (node["name"].String() != contact.name) {
    node["name"].Fail("\"" + contact.name + "\"");
  }
  const JsonNode phases = node["phases"];
  if (phases.ArraySize() != contact.phases.size()) {
    phases.Fail("an array of " + std::to_string(contact.phases.size()) + " phases");
  }
  for (std::size_t q = 0; q < contact.phases.size(); ++q) {
    phases[q].RequireKeys({"position_m"});
    part->phase_p_WF[q] = phases[q]["position_m"].Vector3();
  }
  ReadForces(node["forces_N"], contact, part);
}

void ReadTrajectories(const JsonNode& root, const CentroidalOcp& ocp, MpcSolution* solution) {
  const auto num_states = static_cast<std::size_t>(ocp.knots) + 1;
  solution->p_WC = root["com_m"].Columns3(num_states);
  solution->linear_momentum = root["linear_momentum"].Columns3(num_states);
  solution->angular_momentum = root["angular_momentum"].Columns3(num_states);
  const JsonNode contacts = root["contacts"];
  if (contacts.ArraySize() != ocp.contacts.size()) {
    contacts.Fail("an array of " + std::to_string(ocp.contacts.size()) + " contacts");
  }
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    ReadContact(contacts[i], ocp.contacts[i], &solution->contacts[i]);
  }
}

}  // namespace

json SolutionToJson(const CentroidalOcp& ocp, const MpcSolution& solution) {
  json block = {{"status", EnumName(solution.status)},
                {"cost", nullptr},
                {"constraint_violation", nullptr},
                {"kkt_error", nullptr}};
  if (!HasTrajectories(solution.status)) {
    return block;
  }
  block.update(TrajectoriesToJson(ocp, solution));
  block["cost"] = solution.cost;
  block["constraint_violation"] = solution.constraint_violation;
  block["kkt_error"] = solution.kkt_error;
  block["other_minima"] = json::array();
  return block;
}

json TrajectoriesToJson(const CentroidalOcp& ocp, const MpcSolution& solution) {
  SIDESTEP_REQUIRE(HasShape(ocp, solution), "a solution of other shapes");
  json block;
  block["com_m"] = RowsOf(solution.p_WC);
  block["linear_momentum"] = RowsOf(solution.linear_momentum);
  block["angular_momentum"] = RowsOf(solution.angular_momentum);
  block["contacts"] = json::array();
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    json phases = json::array();
    for (const Eigen::Vector3d& p_WF : solution.contacts[i].phase_p_WF) {
      phases.push_back({{"position_m", RowOf(p_WF)}});
    }
    block["contacts"].push_back(
        {{"name", ocp.contacts[i].name},
         {"phases", phases},
         {"forces_N", ForcesToJson(ocp.contacts[i], solution.contacts[i])}});
  }
  return block;
}

MpcSolution SolutionFromJson(const CentroidalOcp& ocp, const json& block) {
  const JsonNode root(block, "$");
  root.RequireKeys(
      {"status", "cost", "constraint_violation", "kkt_error"},
      {"com_m", "linear_momentum", "angular_momentum", "contacts", "other_minima", "note"});
  MpcSolution solution;
  ResetToShape(ocp, &solution);
  solution.status = StatusFromJson(root["status"]);
  if (!HasTrajectories(solution.status)) {
    return solution;
  }
  root.RequireKeys({"status", "cost", "constraint_violation", "kkt_error", "com_m",
                    "linear_momentum", "angular_momentum", "contacts"},
                   {"other_minima", "note"});
  solution.cost = root["cost"].Number();
  solution.constraint_violation = root["constraint_violation"].Number();
  solution.kkt_error = root["kkt_error"].Number();
  ReadTrajectories(root, ocp, &solution);
  return solution;
}

MpcSolution TrajectoriesFromJson(const CentroidalOcp& ocp, const json& block,
                                 const std::string& path) {
  const JsonNode root(block, path);
  root.RequireKeys({"com_m", "linear_momentum", "angular_momentum", "contacts"});
  MpcSolution solution;
  ResetToShape(ocp, &solution);
  ReadTrajectories(root, ocp, &solution);
  return solution;
}

}  // namespace sidestep::mpc
