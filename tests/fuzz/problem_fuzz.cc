// SPDX-License-Identifier: BSD-3-Clause
// A problem of the MPC as `sidestep solve` reads it, with how it was solved and from where. What is
// read is written as the same, and the structured back end answers it.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "controller/mpc/problem/ocp_json.h"
#include "controller/mpc/problem/solution_shape.h"
#include "controller/mpc/problem/solver_setup.h"
#include "controller/mpc/structured/structured_solver.h"
#include "models/support/json_text.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::fuzz {
namespace {

constexpr int kMostIterations = 10;  // past the first few all are alike
constexpr int kMostKnots = 40;       // a solve of more is no finding, only slow

// What `read` reads, with the file's name before its mistakes, as the program has it.
template <typename Read>
auto OfFile(Read&& read) {
  try {
    return read();
  } catch (const ConfigError& error) {
    throw ConfigError(std::string("problem.json: error: ") + error.what());
  }
}

void Solve(const mpc::CentroidalOcp& ocp, mpc::SolverOptions options,
           const mpc::MpcSolution* guess) {
  options.max_iterations = std::min(options.max_iterations, kMostIterations);
  const auto solver = mpc::MakeStructuredSolver(options);
  const mpc::MpcSolution& answer = solver->Solve(ocp, guess);
  Require(!IsUsable(answer.status) || mpc::IsFinite(answer), "an answer that is not finite");
  mpc::SolutionToJson(ocp, answer);
}

mpc::SolverSetup ReadSetup(const mpc::CentroidalOcp& ocp, const nlohmann::json& block) {
  const mpc::SolverSetup setup = OfFile([&] { return mpc::SolverSetupFromJson(ocp, block); });
  const nlohmann::json written = mpc::SolverSetupToJson(ocp, setup);
  RequireRead([&] {
    Require(mpc::SolverSetupToJson(ocp, mpc::SolverSetupFromJson(ocp, written)) == written,
            "its solver is written as another");
  });
  return setup;
}

void ReadAndSolve(nlohmann::json json) {
  nlohmann::json answered;
  if (json.is_object() && json.contains("solution")) answered = json["solution"];
  if (json.is_object()) json.erase("solution");
  const mpc::CentroidalOcp ocp = OfFile([&] { return mpc::OcpFromJson(json); });
  const nlohmann::json written = mpc::ToJson(ocp);
  RequireRead(
      [&] { Require(mpc::ToJson(mpc::OcpFromJson(written)) == written, "is written as another"); });
  if (ocp.knots > kMostKnots) return;
  Solve(ocp, {1e-8, kMostIterations}, nullptr);
  if (json.contains("solver")) {
    const mpc::SolverSetup setup = ReadSetup(ocp, json["solver"]);
    Solve(ocp, setup.options, setup.guess ? &*setup.guess : nullptr);
  }
  if (answered.is_null()) return;
  const mpc::MpcSolution guess = OfFile([&] { return mpc::SolutionFromJson(ocp, answered); });
  Solve(ocp, {1e-8, kMostIterations}, &guess);
}

}  // namespace
}  // namespace sidestep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  fuzz::IsRead([&] {
    fuzz::ReadAndSolve(ParseJson<nlohmann::json>(fuzz::TextOf(data, size), "problem.json"));
  });
  return 0;
}
