// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/solver_setup.h"

#include <string>

#include "controller/mpc/problem/json_node.h"
#include "controller/mpc/problem/ocp_json.h"

namespace sidestep::mpc {
namespace {

constexpr int kMostIterations = 1000000;

MpcBackend BackendFromJson(const JsonNode& node) {
  const std::string name = node.String();
  std::string names;
  for (const MpcBackend backend : EnumValues<MpcBackend>()) {
    if (name == EnumName(backend)) return backend;
    names += (names.empty() ? "" : ", ") + std::string(EnumName(backend));
  }
  node.Fail("one of " + names);
}

}  // namespace

nlohmann::json SolverSetupToJson(const CentroidalOcp& ocp, const SolverSetup& setup) {
  nlohmann::json block = {{"backend", EnumName(setup.backend)},
                          {"tolerance", setup.options.tolerance},
                          {"max_iterations", setup.options.max_iterations}};
  if (setup.guess) block["guess"] = TrajectoriesToJson(ocp, *setup.guess);
  return block;
}

SolverSetup SolverSetupFromJson(const CentroidalOcp& ocp, const nlohmann::json& block) {
  const JsonNode root(block, "$.solver");
  root.RequireKeys({"backend", "tolerance", "max_iterations"}, {"guess"});
  SolverSetup setup;
  setup.backend = BackendFromJson(root["backend"]);
  setup.options.tolerance = root["tolerance"].PositiveNumber();
  setup.options.max_iterations = root["max_iterations"].Integer(1, kMostIterations);
  if (root.Has("guess")) {
    setup.guess = TrajectoriesFromJson(ocp, block["guess"], "$.solver.guess");
  }
  return setup;
}

}  // namespace sidestep::mpc
