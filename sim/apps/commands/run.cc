// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/apps/commands/progress.h"
#include "sim/episode/run_scenario.h"
#include "sim/plot/plot_run.h"
#include "sim/process/interrupt.h"
#include "sim/render/render_run.h"
#include "sim/report/write_report.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/read_scenario.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

struct RunArguments {
  fs::path scenario;
  fs::path out_dir;  ///< Empty: renders/<name>.
  bool is_forced{false};
  bool is_quiet{false};
  bool no_video{false};
  std::string plots{"always"};  ///< always, failed, never.
  bool has_asked_plots{false};  ///< On the command line, rather than by default.
  LogDetail log{LogDetail::kNormal};
  bool dump_mpc{false};
  int jobs{1};
  std::vector<std::string> overrides;
};

void Simulate(const Scenario& scenario, const fs::path& out_dir, const RunArguments& arguments,
              std::optional<RunResult>* judged) {
  Progress progress(scenario.name, arguments.is_quiet);
  RunOptions options;
  options.out_dir = out_dir;
  options.command = CommandWords();
  options.dump_every_problem = arguments.dump_mpc;
  options.log = arguments.log;
  options.progress = [&](double sim_time_s, double duration_s) {
    char detail[64];
    std::snprintf(detail, sizeof detail, "%.1f of %.1f s simulated", sim_time_s, duration_s);
    progress.Update(sim_time_s / duration_s, detail);
  };
  options.on_verdict = [judged](const RunResult& result) { *judged = result; };
  RunScenario(scenario, options);
}

void PrintVerdict(const std::string& name, const RunResult& result) {
  std::printf("%s: %s (%.1f s, %.2gx real time; %.1f s of CPU, %.2gx)\n", name.c_str(),
              std::string(EnumName(result.verdict.verdict_class)).c_str(), result.took.wall_s,
              result.simulated_s / result.took.wall_s, result.took.cpu_s,
              result.simulated_s / result.took.cpu_s);
  for (const Reason& reason : result.verdict.reasons) {
    std::printf("  %s", reason.kind.c_str());
    if (reason.time_s) std::printf(" at %.3f s", *reason.time_s);
    std::printf(": %s\n", reason.text.c_str());
  }
  std::fflush(stdout);
}

// Simulates and tells the verdict, also where the disk no longer takes the files that hold it.
RunResult Judge(const Scenario& scenario, const fs::path& out_dir, const RunArguments& arguments) {
  std::optional<RunResult> judged;
  try {
    Simulate(scenario, out_dir, arguments, &judged);
  } catch (const ConfigError&) {
    if (judged) PrintVerdict(scenario.name, *judged);
    throw;
  }
  PrintVerdict(scenario.name, *judged);
  return *judged;
}

// One step of drawing: what it made and how long it took. The verdict stands: what goes wrong is
// told, and the steps after it go on with what there is.
void DrawStep(const char* label, const fs::path& made, const std::function<void()>& draw) {
  if (InterruptRequested()) return;
  const auto start = std::chrono::steady_clock::now();
  try {
    draw();
  } catch (const Interrupted&) {
    PrintNote(std::string("sidestep: warning: interrupted, no ") + label);
    return;
  } catch (const std::exception& error) {
    PrintNote(std::string("sidestep: warning: no ") + label + ": " + error.what());
    return;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  std::printf("  %-6s  %s (%.1f s)\n", label, made.c_str(), wall.count());
  std::fflush(stdout);
}

// Plots, video, report; each only reads what the run left.
void Draw(const Scenario& scenario, const fs::path& run_dir, bool has_passed,
          const RunArguments& arguments) {
  const bool has_ticks = arguments.log != LogDetail::kNone;
  const bool has_plots =
      arguments.plots == "always" || (arguments.plots == "failed" && !has_passed);
  const bool has_video = !arguments.no_video && scenario.video.enabled;
  if (!has_ticks && (has_plots || has_video)) {
    std::printf("  no plots, no video: --log none keeps no ticks to draw\n");
  }
  if (has_ticks && has_plots) DrawStep("plots", run_dir / "plots", [&] { PlotRun(run_dir); });
  if (has_ticks && has_video) {
    DrawStep("video", run_dir / "video.mp4", [&] {
      Progress progress("video", arguments.is_quiet);
      RenderOptions options = RenderOptionsOf(run_dir);
      options.jobs = arguments.jobs;
      options.on_progress = [&](double share) { progress.Update(share, ""); };
      RenderRun(run_dir, options);
    });
  }
  DrawStep("report", run_dir / "report.html",
           [&] { WriteReport({run_dir}, run_dir / "report.html"); });
}

Scenario Read(const RunArguments& arguments) {
  const EndsAtOnce reading(kExitInvalid);
  return ReadScenario(FindScenario(arguments.scenario), arguments.overrides, PrintNote);
}

int Run(const RunArguments& arguments) {
  if (arguments.log == LogDetail::kNone && arguments.has_asked_plots) {
    throw ConfigError("run: error: --log none keeps no ticks, --plots " + arguments.plots +
                      " can't draw them; leave one of the two out");
  }
  const Scenario scenario = Read(arguments);
  const fs::path out_dir =
      (arguments.out_dir.empty() ? fs::path("renders") / scenario.name : arguments.out_dir)
          .lexically_normal();
  const OutFolderLock lock = PrepareOutFolder(out_dir, arguments.is_forced);
  const RunResult result = Judge(scenario, out_dir, arguments);
  Draw(scenario, out_dir, result.verdict.verdict_class == VerdictClass::kPass, arguments);
  std::printf("  folder  %s\n", out_dir.c_str());
  return ExitCodeOf(result.verdict.verdict_class);
}

}  // namespace

void AddRunCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("run", "Simulate a scenario, judge it and draw it");
  const auto arguments = std::make_shared<RunArguments>();
  arguments->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command
      ->add_option("SCENARIO", arguments->scenario, "Scenario file, or the name of one that ships")
      ->required();
  command->add_option("-o,--out", arguments->out_dir, "Run folder [renders/<name>]")
      ->type_name("DIR");
  command->add_flag("--force", arguments->is_forced, "Replace the run that lies in the folder");
  command->add_flag("--no-video", arguments->no_video, "Draw no video");
  AddPlotsOption(*command, "When to draw plots: always, failed, never", arguments->plots);
  const CLI::Option* plots = command->get_option("--plots");
  AddLogOption(*command, arguments->log);
  command->add_flag("--dump-mpc", arguments->dump_mpc,
                    "Write every MPC problem as JSON into DIR/problems, not only failed ones");
  command->add_option("-j,--jobs", arguments->jobs, "Processes that draw the video")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_flag("-q,--quiet", arguments->is_quiet, "No progress");
  AddOverrideOptions(*command, arguments->overrides);
  command->callback([arguments, plots, &exit_code] {
    arguments->has_asked_plots = plots->count() > 0 && arguments->plots != "never";
    exit_code = Run(*arguments);
  });
}

}  // namespace sidestep
