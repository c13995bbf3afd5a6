// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/problem/feasibility.h"
#include "controller/mpc/problem/ocp_json.h"
#include "controller/mpc/problem/solver_setup.h"
#include "controller/types/mpc_params.h"
#include "models/support/config_error.h"
#include "models/support/json_text.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/process/interrupt.h"

namespace sidestep {
namespace {

using Json = nlohmann::json;

/// What is not given is the file's, or the default.
struct SolveArguments {
  std::filesystem::path problem;
  std::optional<MpcBackend> backend;
  std::optional<double> tolerance;
  std::optional<int> max_iterations;
  bool is_cold{false};
  int repeat{1};
  std::filesystem::path out;
};

Json ReadProblem(const std::filesystem::path& file) {
  Json problem = ReadJsonFile<Json>(file);
  if (!problem.is_object()) throw ConfigError(file.string() + ": error: is not a JSON object");
  return problem;
}

/// A problem of a file and how it is to be solved.
struct Task {
  mpc::CentroidalOcp ocp;
  mpc::SolverSetup setup;
};

Task TaskOf(Json problem, const SolveArguments& arguments) {
  // What an earlier solve added is no part of the problem.
  for (const char* key : {"solution", "solve_time_ms", "iterations"}) problem.erase(key);
  Task task;
  try {
    task.ocp = mpc::OcpFromJson(problem);
    if (problem.contains("solver")) {
      task.setup = mpc::SolverSetupFromJson(task.ocp, problem["solver"]);
    }
  } catch (const ConfigError& error) {
    throw ConfigError(arguments.problem.string() + ": error: " + error.what());
  }
  mpc::SolverSetup& setup = task.setup;
  setup.backend = arguments.backend.value_or(setup.backend);
  setup.options.tolerance = arguments.tolerance.value_or(setup.options.tolerance);
  setup.options.max_iterations = arguments.max_iterations.value_or(setup.options.max_iterations);
  if (arguments.is_cold) setup.guess.reset();
  return task;
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
  const auto [ocp, setup] = TaskOf(document, arguments);
  const auto solver = mpc::MakeSolver(setup.backend, setup.options);
  const mpc::MpcSolution* guess = setup.guess ? &*setup.guess : nullptr;
  mpc::MpcSolution solution;
  std::vector<double> times_ms;
  {
    const EndsAtOnce solving(kExitInvalid);
    for (int i = 0; i < arguments.repeat; ++i) {
      const auto start = std::chrono::steady_clock::now();
      const mpc::MpcSolution& answer = solver->Solve(ocp, guess);
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - start;
      times_ms.push_back(took.count());
      solution = answer;
    }
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
  if (solution.status == SolveStatus::kInfeasible) {
    std::printf(" (%s)", mpc::Infeasibility(ocp).c_str());
  }
  std::printf(", %d iterations%s, median %.2f ms of %d (%s)\n", solution.iterations,
              guess != nullptr ? " from the file's guess" : "", times["median"].get<double>(),
              arguments.repeat, EnumName(setup.backend).data());
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
          "Solver; default: the file's, or " + std::string(EnumName(mpc::SolverSetup{}.backend)))
      ->check(CLI::IsMember(BackendNames()));
  command->add_flag("--cold", arguments->is_cold, "Don't begin from the file's guess");
  command->add_option("--repeat", arguments->repeat, "Solves, all alike, for the times")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("-o,--out", arguments->out, "Write the problem with its solution")
      ->type_name("FILE");
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "Of the optimality conditions; default: the file's, or 1e-8")
      ->check(Within(1e-14, 1e-1));
  command
      ->add_option("--max-iterations", arguments->max_iterations,
                   "Limit of iterations; default: the file's, or 200")
      ->check(CLI::Range(1, 1000000));
  command->callback([arguments, &exit_code] { exit_code = Solve(*arguments); });
}

}  // namespace sidestep
