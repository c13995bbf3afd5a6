// SPDX-License-Identifier: BSD-3-Clause
#include <signal.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/progress.h"
#include "sim/apps/commands/sweep_folder.h"
#include "sim/apps/commands/sweep_options.h"
#include "sim/map/write_map.h"
#include "sim/process/interrupt.h"
#include "sim/record/output_file.h"
#include "sim/sweep/merge_rows.h"
#include "sim/sweep/shard_name.h"
#include "sim/sweep/sweep_plan.h"
#include "sim/sweep/sweep_tables.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

Keep KeepOf(const std::string& name) {
  if (const auto keep = EnumOfName<Keep>(name)) return *keep;
  throw ConfigError("--keep " + name + ": error: is none of none, failures, summary, all");
}

ShardReport RunShardOf(const SweepPlan& plan, const fs::path& folder,
                       const SweepArguments& arguments) {
  Progress progress("sweep", arguments.is_quiet);
  ShardListener listener;
  listener.progress = [&](const ShardReport& report) {
    const double rays = std::max(1.0, static_cast<double>(report.rays));
    progress.Update(static_cast<double>(report.rays_done) / rays,
                    std::to_string(report.rays_done) + "/" + std::to_string(report.rays) +
                        " rays, " + std::to_string(report.runs) + " runs");
  };
  listener.note = [&](const std::string& line) { progress.Say(line); };
  return RunShard(plan, folder, arguments.shard, listener);
}

// Writes the tables and tells what they amount to; exits with 3 if rows are missing or INVALID.
int Merge(const fs::path& folder, int shards, int evidence) {
  const SweepPlan plan = ReadPlan(folder);
  const MergedRows merged = ReadAllRows(plan, folder, PrintNote);
  const std::vector<RayResult> results = ResultsOf(plan, merged.rows);
  const int of = shards > 0 ? shards : merged.shards;
  const std::vector<std::size_t> missing = MissingShards(results, of);
  if (!missing.empty()) {
    const auto is_missing = [](const RayResult& result) { return !result.search.is_complete; };
    const auto rays = std::count_if(results.begin(), results.end(), is_missing);
    std::fprintf(stderr,
                 "%s: error: %td of %zu rays are not complete; shards of %d to run: --array=%s\n",
                 folder.c_str(), rays, results.size(), of, ArrayText(missing).c_str());
    return kExitInvalid;
  }
  WriteWholeFile(folder / "cells.csv", CellsCsv(plan, results));
  WriteWholeFile(folder / "strengths.csv", StrengthsCsv(plan, results));
  WriteWholeFile(folder / "rays.csv", RaysCsv(plan, results));
  std::printf("%s", SweepSummary(plan, results).c_str());
  WriteMap(plan, folder, {evidence, ThisProgram()}, PrintNote);
  std::printf("  tables  %s\n  map     %s\n", (folder / "rays.csv").c_str(),
              (folder / "map.html").c_str());
  const bool has_invalid = std::any_of(merged.rows.begin(), merged.rows.end(), [](const auto& row) {
    return row.second.outcome == CellOutcome::kInvalid;
  });
  return has_invalid ? kExitInvalid : kExitPass;
}

void TellIncomplete(const ShardReport& report) {
  std::fprintf(stderr, "note: %zu of %zu rays are done; the same command goes on with the rest\n",
               report.rays_done, report.rays);
}

int Sweep(SweepArguments arguments) {
  if (arguments.target.empty()) {
    throw ConfigError("sweep: error: SWEEP is missing, a sweep file or a scenario (see --help)");
  }
  arguments.shard.keep.keep = KeepOf(arguments.keep);
  const SweepSpec spec = ReadTarget(arguments);
  const fs::path folder = FolderOf(arguments, spec);
  const SweepPlan plan = PlanIn(folder, spec, arguments.is_quiet);
  const ShardReport report = RunShardOf(plan, folder, arguments);
  if (report.rays_done == report.rays) return Merge(folder, 1, arguments.evidence);
  TellIncomplete(report);
  return report.was_interrupted || report.invalid > 0 ? kExitInvalid : kExitPass;
}

int Plan(const SweepArguments& arguments) {
  const SweepSpec spec = ReadTarget(arguments);
  const fs::path folder = FolderOf(arguments, spec);
  const SweepPlan plan = PlanIn(folder, spec, arguments.is_quiet);
  std::printf("%zu rays, at most %.0f runs: %s\n", plan.rays.size(), NumCells(spec),
              (folder / "manifest.csv").c_str());
  return kExitPass;
}

// Falls are results: only INVALID runs and an interruption make it exit with 3.
int RunPlanned(SweepArguments arguments) {
  arguments.shard.keep.keep = KeepOf(arguments.keep);
  if (!arguments.shard_text.empty()) {
    const ShardName name = ParseShard(arguments.shard_text, std::getenv);
    arguments.shard.shard = name.shard;
    arguments.shard.shards = name.shards;
  }
  InterruptOn(SIGUSR1);  // schedulers send it before they kill
  const SweepPlan plan = ReadPlan(arguments.folder);
  const ShardReport report = RunShardOf(plan, arguments.folder, arguments);
  std::printf("shard %d/%d: %zu of %zu rays, %zu runs, %zu INVALID in all\n", arguments.shard.shard,
              arguments.shard.shards, report.rays_done, report.rays, report.runs, report.invalid);
  if (report.rays_done < report.rays) TellIncomplete(report);
  return report.was_interrupted || report.invalid > 0 ? kExitInvalid : kExitPass;
}

void AddPlanCommand(CLI::App& sweep, int& exit_code) {
  CLI::App* command = sweep.add_subcommand("plan", "Only write the folder with its manifest");
  const auto arguments = NewSweepArguments(*command);
  AddSweepTarget(*command, *arguments);
  command->get_option("SWEEP")->required();
  AddSweepSpecOptions(*command, *arguments);
  command->callback([arguments, &exit_code] { exit_code = Plan(*arguments); });
}

void AddRunPlannedCommand(CLI::App& sweep, int& exit_code) {
  CLI::App* command =
      sweep.add_subcommand("run", "Run a shard of a planned sweep, or go on with it");
  const auto arguments = NewSweepArguments(*command);
  command->add_option("DIR", arguments->folder, "Folder of a planned sweep")->required();
  command
      ->add_option("--shard", arguments->shard_text,
                   "Every N-th ray, beginning with number I; auto: rank and size under srun or "
                   "mpirun")
      ->type_name("I/N");
  AddSweepRunOptions(*command, *arguments);
  command->callback([arguments, &exit_code] { exit_code = RunPlanned(*arguments); });
}

void AddMergeCommand(CLI::App& sweep, int& exit_code) {
  CLI::App* command = sweep.add_subcommand("merge", "Join the shards' rows and write the tables");
  const auto folder = std::make_shared<fs::path>();
  const auto shards = std::make_shared<int>(0);
  const auto evidence = std::make_shared<int>(0);
  command->add_option("DIR", *folder, "Folder of a planned sweep")->required();
  command->add_option("--shards", *shards, "N of the shards, to tell which are missing")
      ->check(CLI::Range(1, 1000000));
  AddEvidenceOption(*command, *evidence);
  command->callback(
      [folder, shards, evidence, &exit_code] { exit_code = Merge(*folder, *shards, *evidence); });
}

}  // namespace

void AddSweepCommand(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("sweep", "Run a scenario many times and map which pushes it survives");
  command->require_subcommand(0, 1);
  const auto arguments = NewSweepArguments(*command);
  AddSweepTarget(*command, *arguments);
  AddSweepSpecOptions(*command, *arguments);
  AddSweepRunOptions(*command, *arguments);
  AddEvidenceOption(*command, arguments->evidence);
  AddPlanCommand(*command, exit_code);
  AddRunPlannedCommand(*command, exit_code);
  AddMergeCommand(*command, exit_code);
  AddSlurmCommand(*command, exit_code);
  command->footer(
      "plan, run, merge and slurm are its parts, for clusters. Killed at any moment, the same "
      "command goes on.\nFalls are results: it exits with 3 only if a run says nothing (INVALID).");
  command->callback([command, arguments, &exit_code] {
    if (command->get_subcommands().empty()) exit_code = Sweep(*arguments);
  });
}

}  // namespace sidestep
