// SPDX-License-Identifier: BSD-3-Clause
// A problem of the MPC as `sidestep solve` reads it. One that is read is written as the same, and
// the structured back end answers it.

#include <nlohmann/json.hpp>
#include <string>

#include "controller/mpc/problem/ocp_json.h"
#include "controller/mpc/problem/solution_shape.h"
#include "controller/mpc/structured/structured_solver.h"
#include "models/support/json_text.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::fuzz {
namespace {

constexpr int kMostIterations = 10;  // past the first few all are alike
constexpr int kMostKnots = 40;       // a solve of more is no finding, only slow

mpc::CentroidalOcp Read(const nlohmann::json& json) {
  try {
    return mpc::OcpFromJson(json);
  } catch (const ConfigError& error) {
    throw ConfigError(std::string("problem.json: error: ") + error.what());
  }
}

void Solve(const mpc::CentroidalOcp& ocp, const mpc::MpcSolution* guess) {
  const auto solver = mpc::MakeStructuredSolver({1e-8, kMostIterations});
  const mpc::MpcSolution& answer = solver->Solve(ocp, guess);
  Require(!IsUsable(answer.status) || mpc::IsFinite(answer), "an answer that is not finite");
  mpc::SolutionToJson(ocp, answer);
}

void ReadAndSolve(nlohmann::json json) {
  nlohmann::json block;
  if (json.is_object() && json.contains("solution")) block = json["solution"];
  if (json.is_object()) json.erase("solution");
  const mpc::CentroidalOcp ocp = Read(json);
  const nlohmann::json written = mpc::ToJson(ocp);
  RequireRead(
      [&] { Require(mpc::ToJson(mpc::OcpFromJson(written)) == written, "is written as another"); });
  if (ocp.knots > kMostKnots) return;
  Solve(ocp, nullptr);
  if (block.is_null()) return;
  try {
    const mpc::MpcSolution guess = mpc::SolutionFromJson(ocp, block);
    Solve(ocp, &guess);
  } catch (const ConfigError& error) {
    throw ConfigError(std::string("problem.json: error: ") + error.what());
  }
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
