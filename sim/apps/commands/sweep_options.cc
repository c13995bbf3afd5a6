// SPDX-License-Identifier: BSD-3-Clause
#include "sim/apps/commands/sweep_options.h"

#include <algorithm>
#include <thread>

#include "sim/apps/commands/commands.h"

namespace sidestep {

void AddSweepSpecOptions(CLI::App& command, SweepArguments& arguments) {
  SweepOptions& sweep = arguments.sweep;
  const auto add = [&](const char* name, std::vector<std::string>& values, const char* help) {
    return command.add_option(name, values, help)->take_all()->allow_extra_args(false);
  };
  add("--vary", sweep.vary,
      "An axis: KEY=a:b:n (n values), a:b:step=s, a:b:random=n, a:b:latin=n or [v, w, ...]; "
      "numbers may be in pi: 0:2pi:16")
      ->type_name("KEY=VALUES");
  add("--controller", sweep.controllers, "A set of overrides to compare: 'fixed: {a.b: c}'")
      ->type_name("'NAME: {...}'");
  command
      .add_option("--limit", sweep.limit,
                  "Look for the limit of survival along this key; its ladder is its --vary, or "
                  "follows it as KEY=VALUES")
      ->type_name("KEY");
  command.add_option("--resolution", sweep.resolution, "Narrowest bracket of the limit")
      ->check(AboveZero());
  command.add_option("--seeds", sweep.seeds, "Repeats: how many seeds from 1 on, or a list [3, 5]");
  command.add_flag("--yes", arguments.is_agreed, "Agree to more than a million runs");
  AddSetOption(command, sweep.set);
}

void AddSweepRunOptions(CLI::App& command, SweepArguments& arguments) {
  command.add_option("-j,--jobs", arguments.shard.jobs, "Processes at once")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command
      .add_option("--keep", arguments.keep,
                  "Runs that leave a folder: none, failures, summary (its summary only), all")
      ->capture_default_str();
  AddLogOption(command, arguments.shard.keep.log);
  command
      .add_option("--time-budget", arguments.shard.time_budget_s,
                  "Start no ray that would not end within so many seconds")
      ->check(AboveZero())
      ->type_name("S");
}

void AddEvidenceOption(CLI::App& command, int& evidence) {
  constexpr int kMost = 1000;
  command
      .add_option("--evidence", evidence,
                  "Run so many of each controller's worst cells again, with plots and video")
      ->check(CLI::Range(0, kMost))
      ->type_name("N");
}

std::shared_ptr<SweepArguments> NewSweepArguments(CLI::App& command) {
  auto arguments = std::make_shared<SweepArguments>();
  arguments->shard.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command.add_flag("-q,--quiet", arguments->is_quiet, "No progress");
  return arguments;
}

void AddSweepTarget(CLI::App& command, SweepArguments& arguments) {
  command.add_option("SWEEP", arguments.target,
                     "Sweep file, or a scenario (file or name of one that ships) with --vary");
  command.add_option("-o,--out", arguments.folder, "Folder of the sweep [renders/<name>]")
      ->type_name("DIR");
}

}  // namespace sidestep
