// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/problem/ocp_json.h"
#include "controller/types/mpc_params.h"
#include "models/support/config_error.h"
#include "models/support/json_text.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"

namespace sidestep {
namespace {

using Json = nlohmann::json;

struct SolveArguments {
  std::filesystem::path problem;
  MpcBackend backend{MpcBackend::kIpopt};
  int repeat{1};
  std::filesystem::path out;
  mpc::SolverOptions options;
};

Json ReadProblem(const std::filesystem::path& file) {
  Json problem = ReadJsonFile<Json>(file);
  if (!problem.is_object()) throw ConfigError(file.string() + ": error: is not a JSON object");
  return problem;
}

mpc::CentroidalOcp OcpOf(Json problem, const std::filesystem::path& file) {
  // What an earlier solve added is no part of the problem.
  for (const char* key : {"solution", "solve_time_ms", "iterations"}) problem.erase(key);
  try {
    return mpc::OcpFromJson(problem);
  } catch (const ConfigError& error) {
    throw ConfigError(file.string() + ": error: " + error.what());
  }
}

std::vector<std::string> BackendNames() {
  std::vector<std::string> names;
  for (const MpcBackend backend : EnumValues<MpcBackend>()) names.emplace_back(EnumName(backend));
  return names;
}

// The back end of a name that BackendNames() has.
MpcBackend BackendCalled(const std::string& name) {
  constexpr auto kBackends = EnumValues<MpcBackend>();
  return *std::find_if(kBackends.begin(), kBackends.end(),
                       [&](MpcBackend backend) { return EnumName(backend) == name; });
}

// Value below which a share `q` of the sorted samples lies (nearest rank).
double Quantile(const std::vector<double>& sorted, double q) {
  const double rank = q * static_cast<double>(sorted.size());
  const auto index = static_cast<std::size_t>(std::max(0.0, std::ceil(rank) - 1.0));
  return sorted[std::min(index, sorted.size() - 1)];
}

int Solve(const SolveArguments& arguments) {
  Json document = ReadProblem(arguments.problem);
  const mpc::CentroidalOcp ocp = OcpOf(document, arguments.problem);
  const auto solver = mpc::MakeSolver(arguments.backend, arguments.options);
  mpc::MpcSolution solution;
  std::vector<double> times_ms;
  for (int i = 0; i < arguments.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const mpc::MpcSolution& answer = solver->Solve(ocp, nullptr);
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
    solution = answer;
  }
  std::sort(times_ms.begin(), times_ms.end());
  const Json times{{"median", Quantile(times_ms, 0.5)},
                   {"p95", Quantile(times_ms, 0.95)},
                   {"max", times_ms.back()}};
  document["solution"] = mpc::SolutionToJson(ocp, solution);
  for (Json* block : {&document, &document["solution"]}) {
    (*block)["solve_time_ms"] = times;
    (*block)["iterations"] = solution.iterations;
  }
  if (!arguments.out.empty()) WriteTextFile(arguments.out, document.dump(1) + "\n");
  std::printf("%s: %s", arguments.problem.c_str(), EnumName(solution.status).data());
  if (IsUsable(solution.status)) std::printf(", cost %.9g", solution.cost);
  std::printf(", %d iterations, median %.2f ms of %d\n", solution.iterations,
              times["median"].get<double>(), arguments.repeat);
  return IsUsable(solution.status) ? kExitPass : kExitFail;
}

}  // namespace

void AddSolveCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("solve", "Solve one MPC problem from a JSON file");
  const auto arguments = std::make_shared<SolveArguments>();
  command->add_option("PROBLEM", arguments->problem, "Problem file (JSON)")->required();
  command
      ->add_option_function<std::string>(
          "--backend",
          [arguments](const std::string& name) { arguments->backend = BackendCalled(name); },
          "Solver")
      ->check(CLI::IsMember(BackendNames()))
      ->default_str(std::string(EnumName(arguments->backend)));
  command->add_option("--repeat", arguments->repeat, "Cold solves, for the times")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("-o,--out", arguments->out, "Write the problem with its solution")
      ->type_name("FILE");
  command->add_option("--tolerance", arguments->options.tolerance, "Of the optimality conditions")
      ->check(CLI::Range(1e-14, 1e-1))
      ->capture_default_str();
  command->add_option("--max-iterations", arguments->options.max_iterations, "Limit of iterations")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->callback([arguments, &exit_code] { exit_code = Solve(*arguments); });
}

}  // namespace sidestep
