// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/ocp_json.h"

#include <cmath>
#include <string>

#include "controller/mpc/problem/json_node.h"
#include "controller/mpc/problem/json_write.h"

namespace sidestep::mpc {
namespace {

using nlohmann::json;

constexpr int kMaxKnots = 10000;      // Far above any horizon; bounds what a file may ask for.
constexpr int kMaxEndKnot = 1000000;  // A foot that stays "for ever".

json ToJson(const ContactPhase& phase) {
  json rotation = json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rotation.push_back(phase.R_WF(row, column));
    }
  }
  json result = {{"first_knot", phase.first_knot},
                 {"end_knot", phase.end_knot},
                 {"fixed", phase.fixed},
                 {"rotation", rotation}};
  if (phase.fixed) {
    result["position_m"] = RowOf(phase.p_WF);
  } else {
    result["nominal_position_m"] = RowOf(phase.nominal_p_WF);
    result["box_lower_m"] = RowOf(phase.box_lower_m);
    result["box_upper_m"] = RowOf(phase.box_upper_m);
  }
  return result;
}

json ToJson(const OcpContact& contact) {
  json result = {{"name", contact.name},
                 {"vertices_m", RowsOf(contact.vertices_m)},
                 {"phases", json::array()}};
  if (contact.force_shares.size() != 0) result["force_shares"] = RowOf(contact.force_shares);
  if (contact.leg.length_m > 0.0) {
    result["leg"] = {{"offset_m", RowOf(contact.leg.offset_m)}, {"length_m", contact.leg.length_m}};
  }
  if (contact.has_previous_force) {
    result["previous_force_N"] = RowsOf(contact.previous_force_N);
  }
  for (const ContactPhase& phase : contact.phases) {
    result["phases"].push_back(ToJson(phase));
  }
  return result;
}

ContactPhase PhaseFromJson(const JsonNode& node, int free_from) {
  node.RequireKeys({"first_knot", "end_knot", "fixed", "rotation"},
                   {"position_m", "nominal_position_m", "box_lower_m", "box_upper_m"});
  ContactPhase phase;
  phase.first_knot = node["first_knot"].Integer(free_from, kMaxEndKnot - 1);
  phase.end_knot = node["end_knot"].Integer(phase.first_knot + 1, kMaxEndKnot);
  phase.fixed = node["fixed"].Bool();
  phase.R_WF = node["rotation"].Rotation();
  if (phase.fixed) {
    node.RequireKeys({"first_knot", "end_knot", "fixed", "rotation", "position_m"});
    phase.p_WF = node["position_m"].Vector3();
  } else {
    node.RequireKeys({"first_knot", "end_knot", "fixed", "rotation", "nominal_position_m",
                      "box_lower_m", "box_upper_m"});
    phase.nominal_p_WF = node["nominal_position_m"].Vector3();
    phase.box_lower_m = node["box_lower_m"].Vector3();
    phase.box_upper_m = node["box_upper_m"].Vector3();
  }
  return phase;
}

Eigen::VectorXd SharesFromJson(const JsonNode& node, std::size_t count) {
  Eigen::VectorXd shares = node.Numbers(count);
  if (shares.minCoeff() < 0.0 || std::abs(shares.sum() - 1.0) > kShareTolerance) {
    node.Fail("shares of a force, at least 0 and 1 in sum");
  }
  return shares;
}

OcpContact ContactFromJson(const JsonNode& node) {
  node.RequireKeys({"name", "vertices_m", "phases"}, {"previous_force_N", "force_shares", "leg"});
  OcpContact contact;
  contact.name = node["name"].String();
  const std::size_t num_vertices = node["vertices_m"].ArraySize();
  if (num_vertices == 0) {
    node["vertices_m"].Fail("at least one vertex");
  }
  contact.vertices_m = node["vertices_m"].Columns3(num_vertices);
  if (node.Has("force_shares")) {
    contact.force_shares = SharesFromJson(node["force_shares"], num_vertices);
  }
  if (node.Has("leg")) {
    const JsonNode leg = node["leg"];
    leg.RequireKeys({"offset_m", "length_m"});
    contact.leg = {leg["offset_m"].Vector3(), leg["length_m"].PositiveNumber()};
  }
  if (node.Has("previous_force_N")) {
    contact.has_previous_force = true;
    contact.previous_force_N = node["previous_force_N"].Columns3(num_vertices);
  }
  const JsonNode phases = node["phases"];
  int free_from = 0;
  for (std::size_t q = 0; q < phases.ArraySize(); ++q) {
    contact.phases.push_back(PhaseFromJson(phases[q], free_from));
    free_from = contact.phases.back().end_knot;
  }
  return contact;
}

MpcWeights WeightsFromJson(const JsonNode& node) {
  node.RequireKeys({"com", "angular_momentum", "contact_position", "force_symmetry", "force_rate"},
                   {"foot_load", "leg_length", "new_contact_force"});
  MpcWeights weights;
  weights.com = node["com"].Weights3();
  weights.angular_momentum = node["angular_momentum"].Weights3();
  weights.contact_position = node["contact_position"].Weights3();
  weights.force_symmetry = node["force_symmetry"].Weights3();
  weights.force_rate = node["force_rate"].Weights3();
  if (node.Has("foot_load")) weights.foot_load = node["foot_load"].NonNegativeNumber();
  if (node.Has("leg_length")) weights.leg_length = node["leg_length"].NonNegativeNumber();
  if (node.Has("new_contact_force")) {
    weights.new_contact_force = node["new_contact_force"].Weights3();
  }
  return weights;
}

double FirstStepFromJson(const JsonNode& node, double step_s) {
  const double first_step_s = node.PositiveNumber();
  if (first_step_s > step_s) node.Fail("a step no longer than step_s");
  return first_step_s;
}

// A weight without a limit would silently mean a limit of zero.
double FootLoadLimitFromJson(const JsonNode& root, double weight) {
  constexpr const char* kKey = "foot_load_limit_N";
  if (root.Has(kKey)) return root[kKey].NonNegativeNumber();
  if (weight > 0.0) root["weights"]["foot_load"].Fail(std::string("0 without ") + kKey);
  return 0.0;
}

void ReadFriction(const JsonNode& root, CentroidalOcp* ocp) {
  const std::size_t num_rows = root["friction_A"].ArraySize();
  ocp->friction_A = root["friction_A"].Columns3(num_rows).transpose();
  ocp->friction_b = root["friction_b"].Numbers(num_rows);
}

}  // namespace

json ToJson(const CentroidalOcp& ocp) {
  CheckShapes(ocp);
  json contacts = json::array();
  for (const OcpContact& contact : ocp.contacts) {
    contacts.push_back(ToJson(contact));
  }
  const MpcWeights& weights = ocp.weights;
  json result = {{"name", ocp.name},
                 {"description", ocp.description},
                 {"step_s", ocp.step_s},
                 {"knots", ocp.knots},
                 {"mass_kg", ocp.mass_kg},
                 {"gravity_m_s2", RowOf(ocp.gravity_mps2)},
                 {"initial",
                  {{"com_m", RowOf(ocp.initial_p_WC)},
                   {"linear_momentum", RowOf(ocp.initial_linear_momentum)},
                   {"angular_momentum", RowOf(ocp.initial_angular_momentum)}}},
                 {"reference",
                  {{"com_m", RowsOf(ocp.reference_p_WC)},
                   {"angular_momentum", RowsOf(ocp.reference_angular_momentum)}}},
                 {"weights",
                  {{"com", RowOf(weights.com)},
                   {"angular_momentum", RowOf(weights.angular_momentum)},
                   {"contact_position", RowOf(weights.contact_position)},
                   {"force_symmetry", RowOf(weights.force_symmetry)},
                   {"force_rate", RowOf(weights.force_rate)},
                   {"new_contact_force", RowOf(weights.new_contact_force)}}},
                 {"external_force_N", RowsOf(ocp.external_force_N)},
                 {"external_torque_Nm", RowsOf(ocp.external_torque_Nm)},
                 {"friction_A", RowsOf(ocp.friction_A.transpose())},
                 {"friction_b", RowOf(ocp.friction_b)},
                 {"contacts", contacts}};
  if (weights.foot_load > 0.0) {
    result["weights"]["foot_load"] = weights.foot_load;
    result["foot_load_limit_N"] = ocp.foot_load_limit_N;
  }
  if (weights.leg_length > 0.0) result["weights"]["leg_length"] = weights.leg_length;
  if (ocp.first_step_s) result["first_step_s"] = *ocp.first_step_s;
  return result;
}

CentroidalOcp OcpFromJson(const json& document) {
  const JsonNode root(document, "$");
  root.RequireKeys(
      {"name", "step_s", "knots", "mass_kg", "gravity_m_s2", "initial", "reference", "weights",
       "external_force_N", "external_torque_Nm", "friction_A", "friction_b", "contacts"},
      {"description", "first_step_s", "foot_load_limit_N", "solution", "solver"});
  CentroidalOcp ocp;
  ocp.name = root["name"].String();
  if (root.Has("description")) {
    ocp.description = root["description"].String();
  }
  ocp.step_s = root["step_s"].PositiveNumber();
  if (root.Has("first_step_s")) {
    ocp.first_step_s = FirstStepFromJson(root["first_step_s"], ocp.step_s);
  }
  ocp.knots = root["knots"].Integer(1, kMaxKnots);
  ocp.mass_kg = root["mass_kg"].PositiveNumber();
  ocp.gravity_mps2 = root["gravity_m_s2"].Vector3();
  const JsonNode initial = root["initial"];
  initial.RequireKeys({"com_m", "linear_momentum", "angular_momentum"});
  ocp.initial_p_WC = initial["com_m"].Vector3();
  ocp.initial_linear_momentum = initial["linear_momentum"].Vector3();
  ocp.initial_angular_momentum = initial["angular_momentum"].Vector3();
  const auto num_inputs = static_cast<std::size_t>(ocp.knots);
  const JsonNode reference = root["reference"];
  reference.RequireKeys({"com_m", "angular_momentum"});
  ocp.reference_p_WC = reference["com_m"].Columns3(num_inputs + 1);
  ocp.reference_angular_momentum = reference["angular_momentum"].Columns3(num_inputs + 1);
  ocp.weights = WeightsFromJson(root["weights"]);
  ocp.foot_load_limit_N = FootLoadLimitFromJson(root, ocp.weights.foot_load);
  ocp.external_force_N = root["external_force_N"].Columns3(num_inputs);
  ocp.external_torque_Nm = root["external_torque_Nm"].Columns3(num_inputs);
  ReadFriction(root, &ocp);
  const JsonNode contacts = root["contacts"];
  for (std::size_t i = 0; i < contacts.ArraySize(); ++i) {
    ocp.contacts.push_back(ContactFromJson(contacts[i]));
  }
  return ocp;
}

}  // namespace sidestep::mpc
