// SPDX-License-Identifier: BSD-3-Clause
// `sidestep sweep slurm`: a sweep's jobs for a cluster, printed or submitted.

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/sweep_folder.h"
#include "sim/process/process.h"
#include "sim/sweep/merge_rows.h"
#include "sim/sweep/slurm_script.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

struct SlurmArguments {
  int shards{0};  ///< 0: as the rows that are there have, or as UsualShards().
  int max_array{kUsualMaxArraySize};
  bool is_submitted{false};
  SlurmSpec slurm;
};

int ShardsFor(const SweepPlan& plan, const MergedRows& merged, const SlurmArguments& arguments) {
  const int shards = arguments.shards > 0 ? arguments.shards
                     : merged.shards > 1  ? merged.shards
                                          : UsualShards(plan.rays.size(), arguments.max_array);
  if (shards <= arguments.max_array) return shards;
  throw ConfigError("sweep slurm: error: " + std::to_string(shards) +
                    " shards are more than an array may have, " +
                    std::to_string(arguments.max_array) +
                    " (Slurm's MaxArraySize: scontrol show config); --max-array if it is another");
}

// What sbatch says of a job: its number, on some clusters with the cluster's name.
std::string Submit(const std::vector<std::string>& options, const std::string& script) {
  std::vector<std::string> words{"sbatch", "--parsable"};
  words.insert(words.end(), options.begin(), options.end());
  const std::string said = RunOrThrow(words, script).out;
  return said.substr(0, said.find_first_of(";\n"));
}

int Slurm(const SweepArguments& sweep, SlurmArguments arguments) {
  const bool is_planned = fs::is_directory(sweep.target);
  const fs::path folder = is_planned ? sweep.target : FolderOf(sweep, ReadTarget(sweep));
  const SweepPlan plan =
      is_planned ? ReadPlan(folder) : PlanIn(folder, ReadTarget(sweep), sweep.is_quiet);
  const MergedRows merged = ReadAllRows(plan, folder, PrintNote);
  SlurmSpec& slurm = arguments.slurm;
  slurm.name = plan.spec.name;
  slurm.program = ThisProgram();
  slurm.folder = fs::canonical(folder);
  slurm.shards = ShardsFor(plan, merged, arguments);
  slurm.tasks = MissingShards(ResultsOf(plan, merged.rows), slurm.shards);
  if (slurm.tasks.empty()) {
    throw ConfigError(folder.string() +
                      ": error: no shard is missing; sidestep sweep merge joins "
                      "them");
  }
  if (!arguments.is_submitted) {
    std::printf("%s", SubmitScript(slurm).c_str());
    return kExitPass;
  }
  const std::string array = Submit({}, ArrayScript(slurm));
  const std::string merge = Submit({"--dependency=afterany:" + array}, MergeScript(slurm));
  std::printf("array %s, merge %s\n", array.c_str(), merge.c_str());
  return kExitPass;
}

void AddSlurmOptions(CLI::App& command, SlurmArguments& arguments) {
  constexpr int kMost = 1'000'000;
  command
      .add_option("--shards", arguments.shards,
                  "Tasks of the array [as the rows there have, or up to 100]")
      ->check(CLI::Range(1, kMost));
  command.add_option("--max-array", arguments.max_array, "Slurm's MaxArraySize")
      ->check(CLI::Range(1, kMost))
      ->capture_default_str();
  command.add_option("--throttle", arguments.slurm.throttle, "Tasks at once, at most [no limit]")
      ->check(CLI::Range(1, kMost));
  command
      .add_option("--sbatch", arguments.slurm.options,
                  "One more option for the array's sbatch: --sbatch=--time=4:00:00")
      ->type_name("OPTION")
      ->take_all()
      ->allow_extra_args(false);
  command.add_flag("--submit", arguments.is_submitted, "Submit the jobs instead of printing them");
}

}  // namespace

void AddSlurmCommand(CLI::App& sweep, int& exit_code) {
  CLI::App* command =
      sweep.add_subcommand("slurm", "Print or submit a job array for what a sweep has not run yet");
  const auto arguments = NewSweepArguments(*command);
  const auto slurm = std::make_shared<SlurmArguments>();
  AddSweepTarget(*command, *arguments);
  command->get_option("SWEEP")->required()->description(
      "Folder of a planned sweep, or a sweep file or scenario to plan");
  AddSweepSpecOptions(*command, *arguments);
  AddSlurmOptions(*command, *slurm);
  command->footer(
      "It prints a script: sidestep sweep slurm DIR > jobs.sh; bash jobs.sh. Arguments of that go\n"
      "to sbatch. A GNU parallel line for machines without Slurm stands in it.");
  command->callback([arguments, slurm, &exit_code] { exit_code = Slurm(*arguments, *slurm); });
}

}  // namespace sidestep
