// SPDX-License-Identifier: BSD-3-Clause
// What a run of the hopper costs, from the physics step to the finished video.
//   sim_bench [--benchmark_filter=Run]
// Counters: p50, p99 and max of a control tick; real_time_factor = simulated over elapsed time.
// Compare ratios within one run of this program; a machine's other work moves all of them.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "controller/make_controller.h"
#include "sim/episode/run_scenario.h"
#include "sim/plot/plot_run.h"
#include "sim/render/render_run.h"
#include "sim/scenario/read_scenario.h"
#include "sim/sensors/sensor_suite.h"
#include "sim/world/make_world.h"

namespace sidestep {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRunDuration_s = 4.0;  // holds the first push and its recovery

Scenario PushScenario() {
  return ReadScenario(
      std::string(SIDESTEP_SOURCE_DIR) + "/scenarios/hopper_push.yaml",
      {"duration_s=4.0", "expect={fall: false}",
       "pushes=[{body: trunk, force_N: [5, 0, 0], start_s: 2.0, duration_s: 0.5}]"});
}

double Elapsed_us(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

void ReportQuantiles(std::vector<double> sample_us, benchmark::State& state) {
  if (sample_us.empty()) return;
  std::sort(sample_us.begin(), sample_us.end());
  const auto quantile = [&](double q) {
    return sample_us[static_cast<std::size_t>(q * static_cast<double>(sample_us.size() - 1))];
  };
  state.counters["p50_us"] = quantile(0.50);
  state.counters["p99_us"] = quantile(0.99);
  state.counters["max_us"] = sample_us.back();
}

// One physics step with the sensors' read-out, the robot standing under its controller's torque.
void BM_PhysicsStep(benchmark::State& state) {
  const Scenario scenario = PushScenario();
  const std::unique_ptr<World> world = MakeWorld(scenario);
  StageTimer timer;
  SensorSuite sensors = MakeSensorSuite(scenario, world->mass_kg());
  const std::unique_ptr<Controller> controller = MakeController(SetupOf(scenario), &timer);
  Tick tick = 0;
  for (; tick < 200; ++tick) {  // settle on the floor: a typical contact, not a fall
    if (tick % 2 == 0) world->Apply(controller->Update(sensors.Read(world->truth(), tick)).command);
    world->Step(tick);
  }
  for (auto _ : state) world->Step(tick++);
}
BENCHMARK(BM_PhysicsStep)->Iterations(2000);

// The control chain in the closed loop: ticks without an MPC solve, or only those with one.
void BM_ControlTick(benchmark::State& state) {
  const bool with_mpc = state.range(0) != 0;
  const Scenario scenario = PushScenario();
  const Tick control_period = TickAt(1.0 / scenario.control.rate_hz, scenario.world.step_s);
  const Tick mpc_period = TickAt(1.0 / scenario.control.mpc.rate_hz, scenario.world.step_s);
  std::vector<double> sample_us;
  for (auto _ : state) {
    const std::unique_ptr<World> world = MakeWorld(scenario);
    StageTimer timer;
    SensorSuite sensors = MakeSensorSuite(scenario, world->mass_kg());
    const std::unique_ptr<Controller> controller = MakeController(SetupOf(scenario), &timer);
    double total_us = 0.0;
    for (Tick tick = 0; tick < TickAt(kRunDuration_s, scenario.world.step_s); ++tick) {
      if (tick % control_period == 0) {
        const SensorFrame frame = sensors.Read(world->truth(), tick);
        const Clock::time_point start = Clock::now();
        const ControlTick& control = controller->Update(frame);
        if ((tick % mpc_period == 0) == with_mpc) {
          sample_us.push_back(Elapsed_us(start));
          total_us += sample_us.back();
        }
        world->Apply(control.command);
      }
      world->Step(tick);
      sensors.Accumulate(world->truth());
    }
    state.SetIterationTime(1e-6 * total_us);
  }
  ReportQuantiles(std::move(sample_us), state);
}
BENCHMARK(BM_ControlTick)
    ->ArgName("with_mpc")
    ->Arg(0)
    ->Arg(1)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

// A whole run with its files; with pictures also plots and the video, drawn by one process.
void BM_Run(benchmark::State& state) {
  const bool with_pictures = state.range(0) != 0;
  const Scenario scenario = PushScenario();
  const auto folder = std::filesystem::temp_directory_path() / "sidestep_sim_bench";
  double elapsed_us = 0.0;
  for (auto _ : state) {
    std::filesystem::remove_all(folder);
    const Clock::time_point start = Clock::now();
    RunOptions options;
    options.out_dir = folder;
    RunScenario(scenario, options);
    if (with_pictures) {
      PlotRun(folder);
      RenderRun(folder, RenderOptionsOf(folder));
    }
    elapsed_us += Elapsed_us(start);
  }
  std::filesystem::remove_all(folder);
  const double runs = static_cast<double>(state.iterations());
  state.counters["real_time_factor"] = runs * kRunDuration_s / (1e-6 * elapsed_us);
}
BENCHMARK(BM_Run)
    ->ArgName("with_pictures")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

// The video of the run, by one process: draft, normal and fine.
void BM_RenderVideoFrame(benchmark::State& state) {
  const Scenario scenario = PushScenario();
  const auto folder = std::filesystem::temp_directory_path() / "sidestep_frame_bench";
  std::filesystem::remove_all(folder);
  RunOptions options;
  options.out_dir = folder;
  RunScenario(scenario, options);
  RenderOptions render = RenderOptionsOf(folder);
  render.quality = static_cast<RenderQuality>(state.range(0));
  double elapsed_us = 0.0;
  for (auto _ : state) {
    const Clock::time_point start = Clock::now();
    RenderRun(folder, render);
    elapsed_us += Elapsed_us(start);
  }
  std::filesystem::remove_all(folder);
  const double frames = static_cast<double>(state.iterations()) * kRunDuration_s * render.fps;
  state.counters["per_frame_ms"] = 1e-3 * elapsed_us / frames;
}
BENCHMARK(BM_RenderVideoFrame)
    ->ArgName("quality")
    ->DenseRange(0, 2)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sidestep
