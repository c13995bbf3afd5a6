// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/recorder.h"

#include <system_error>
#include <utility>

#include "models/support/config_error.h"
#include "sim/record/footsteps_csv.h"
#include "sim/record/make_summary.h"
#include "sim/record/output_file.h"
#include "sim/record/run_files.h"
#include "sim/record/states_row.h"
#include "sim/record/trajectory_table.h"
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

std::filesystem::path MakeFolder(const std::filesystem::path& run_dir) {
  std::error_code error;
  std::filesystem::create_directories(run_dir, error);
  if (error) throw ConfigError(run_dir.string() + ": error: can't be created");
  ListRunFiles(run_dir, {"scenario.yaml", "trajectory.csv", "states.bin", "mpc.csv",
                         "footsteps.csv", "summary.json"});
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
        std::vector<std::string> command)
      : scenario(scenario_of_run),
        run_dir(MakeFolder(folder)),
        feet(FootNames(scenario)),
        table(scenario.robot, scenario.plant, scenario.control.mode, world.joints()),
        trajectory(run_dir / "trajectory.csv"),
        states(run_dir / "states.bin"),
        mpc(run_dir / "mpc.csv") {
    facts.command = std::move(command);
    WriteWholeAtStart();
    const double tick_s = scenario.world.step_s;
    const double dt_s = SecondsAt(TickAt(1.0 / scenario.control.rate_hz, tick_s), tick_s);
    trajectory.Append(table.Header());
    states.Append(StatesHeader(feet, static_cast<int>(world.truth().qpos.size()), dt_s));
    mpc.Append(kMpcHeader);
  }

  // Begins in another folder with all that `start` holds.
  State(const State& start, const std::filesystem::path& folder)
      : scenario(start.scenario),
        run_dir(MakeFolder(folder)),
        feet(start.feet),
        table(start.table),
        trajectory(run_dir / "trajectory.csv", start.trajectory),
        states(run_dir / "states.bin", start.states),
        mpc(run_dir / "mpc.csv", start.mpc),
        facts(start.facts) {
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
    for (OutputFile* file : {&trajectory, &states, &mpc}) file->Flush();
  }

  Scenario scenario;
  std::filesystem::path run_dir;
  std::vector<std::string> feet;
  TrajectoryTable table;
  OutputFile trajectory;
  OutputFile states;
  OutputFile mpc;
  RunFacts facts;
  std::string row;  // kept for its memory
  double flush_due_s{0.0};
};

Recorder::Recorder(const Scenario& scenario, const World& world,
                   const std::filesystem::path& run_dir, std::vector<std::string> command)
    : state_(std::make_unique<State>(scenario, world, run_dir, std::move(command))) {}

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
  state.row.clear();
  state.table.AppendRow({time_s, truth, control, times}, state.row);
  state.trajectory.Append(state.row);

  state.row.clear();
  AppendStatesRow(time_s, truth, control, state.row);
  state.states.Append(state.row);

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
  state.trajectory.Close();
  state.states.Close();
  state.mpc.Close();
  state.facts.simulated_s = simulated_s;
  state.facts.took = took;
  state.WriteWholeAtEnd(outcome);
}

}  // namespace sidestep
