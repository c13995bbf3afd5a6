// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/recorder.h"

#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "models/support/config_error.h"
#include "sim/record/footsteps_csv.h"
#include "sim/record/make_summary.h"
#include "sim/record/output_file.h"
#include "sim/record/run_files.h"
#include "sim/record/tick_files.h"
#include "sim/scenario/write_scenario.h"

namespace sidestep {
namespace {

constexpr double kFlushPeriod_s = 0.1;  // simulated: what a run that is killed may lose

constexpr char kMpcHeader[] =
    "time_s,status,iterations,cost,constraint_violation,kkt_error,wall_ms,cpu_ms\n";

std::vector<std::string> FootNames(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const FootDescription& foot : scenario.robot.feet) {
    names.push_back(foot.name);
  }
  return names;
}

std::filesystem::path MakeFolder(const std::filesystem::path& run_dir, LogDetail detail) {
  std::error_code error;
  std::filesystem::create_directories(run_dir, error);
  if (error) throw ConfigError(run_dir.string() + ": error: can't be created");
  std::vector<std::string> names{"scenario.yaml", "mpc.csv", "footsteps.csv", "summary.json"};
  for (const char* name : TickFiles::kNames) {
    if (detail == LogDetail::kNone) {
      std::filesystem::remove(run_dir / name, error);  // of an older run: not of this one
    } else {
      names.emplace_back(name);
    }
  }
  ListRunFiles(run_dir, names);
  return run_dir;
}

// What the folder says for as long as the run has not ended, and if it never does.
RunOutcome NotEnded() {
  RunOutcome outcome;
  outcome.verdict.verdict_class = VerdictClass::kInvalid;
  outcome.verdict.reasons = {
      {reason::kInterrupted, "the run was ended before it could be judged", {}}};
  return outcome;
}

void AppendMpcRow(double time_s, const MpcReport& mpc, const StageTime& took, std::string& text) {
  AppendNumber(text, time_s);
  text.append(",").append(EnumName(mpc.status)).append(",").append(std::to_string(mpc.iterations));
  for (const double value :
       {mpc.cost, mpc.constraint_violation, mpc.kkt_error, took.wall_ms, took.cpu_ms}) {
    text.push_back(',');
    AppendNumber(text, value);
  }
  text.push_back('\n');
}

}  // namespace

struct Recorder::State {
  State(const Scenario& scenario_of_run, const World& world, const std::filesystem::path& folder,
        std::vector<std::string> command, LogDetail detail)
      : scenario(scenario_of_run),
        run_dir(MakeFolder(folder, detail)),
        feet(FootNames(scenario)),
        mpc(run_dir / "mpc.csv") {
    facts.command = std::move(command);
    facts.log = detail;
    WriteWholeAtStart();
    mpc.Append(kMpcHeader);
    if (detail != LogDetail::kNone) ticks.emplace(scenario, world, run_dir, detail);
  }

  // Begins in another folder with all that `start` holds.
  State(const State& start, const std::filesystem::path& folder)
      : scenario(start.scenario),
        run_dir(MakeFolder(folder, start.facts.log)),
        feet(start.feet),
        mpc(run_dir / "mpc.csv", start.mpc),
        facts(start.facts) {
    if (start.ticks) ticks.emplace(*start.ticks, run_dir);
    WriteWholeAtStart();
  }

  // The files that are written in one go, so that the folder can be read whenever the run ends.
  void WriteWholeAtStart() const {
    WriteWholeFile(run_dir / "scenario.yaml", ResolvedYaml(scenario));
    WriteWholeAtEnd(NotEnded());
  }

  void WriteWholeAtEnd(const RunOutcome& outcome) const {
    WriteWholeFile(run_dir / "footsteps.csv",
                   FootstepsCsv(outcome.footsteps, feet, scenario.world.step_s));
    WriteWholeFile(run_dir / "summary.json", SummaryJson(MakeSummary(scenario, outcome, facts)));
  }

  void FlushOnceDue(double time_s) {
    if (time_s < flush_due_s) return;
    flush_due_s = time_s + kFlushPeriod_s;
    mpc.Flush();
    if (ticks) ticks->Flush();
  }

  Scenario scenario;
  std::filesystem::path run_dir;
  std::vector<std::string> feet;
  OutputFile mpc;
  std::optional<TickFiles> ticks;  // none if the log has none
  RunFacts facts;
  std::string row;  // kept for its memory
  double flush_due_s{0.0};
};

Recorder::Recorder(const Scenario& scenario, const World& world,
                   const std::filesystem::path& run_dir, std::vector<std::string> command,
                   LogDetail detail)
    : state_(std::make_unique<State>(scenario, world, run_dir, std::move(command), detail)) {}

Recorder::Recorder(std::unique_ptr<State> state) : state_(std::move(state)) {}

Recorder::~Recorder() = default;

std::unique_ptr<Recorder> Recorder::ForkTo(const std::filesystem::path& run_dir) const {
  RequireOtherFolder(state_->run_dir, run_dir);
  return std::unique_ptr<Recorder>(new Recorder(std::make_unique<State>(*state_, run_dir)));
}

void Recorder::Add(Tick tick, const WorldTruth& truth, const ControlTick& control,
                   const TickTimes& times) {
  State& state = *state_;
  const double time_s = SecondsAt(tick, state.scenario.world.step_s);
  if (state.ticks) state.ticks->Add({time_s, truth, control, times});
  if (times.whole_body.wall_ms > 0.0) state.facts.whole_body.push_back(times.whole_body);
  if (control.mpc.ran) {
    state.row.clear();
    AppendMpcRow(time_s, control.mpc, times.mpc, state.row);
    state.mpc.Append(state.row);
    state.facts.solves.push_back(times.mpc);
  }
  state.FlushOnceDue(time_s);
}

void Recorder::Finish(const RunOutcome& outcome, double simulated_s, const RunTime& took) {
  State& state = *state_;
  if (state.ticks) state.ticks->Close();
  state.mpc.Close();
  state.facts.simulated_s = simulated_s;
  state.facts.took = took;
  state.WriteWholeAtEnd(outcome);
}

}  // namespace sidestep
