// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_data.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/convex_hull.h"
#include "sim/plot/plot_curves.h"
#include "sim/scenario/read_scenario.h"

namespace sidestep::plot {
namespace {

// Shorter is a bounce, or the first row, before the ground has pushed.
constexpr double kShortestFlight_s = 0.02;

// Outlines of the soles of `feet`; empty where the robot can't be read or has no such foot.
std::vector<std::vector<Eigen::Vector2d>> ReadSoles(const std::filesystem::path& run_dir,
                                                    const std::vector<std::string>& feet) {
  std::vector<std::vector<Eigen::Vector2d>> soles(feet.size());
  try {
    const Scenario scenario = ReadScenario(run_dir / "scenario.yaml", {});
    for (const FootDescription& foot : scenario.robot.feet) {
      const auto found = std::find(feet.begin(), feet.end(), foot.name);
      if (found == feet.end()) continue;
      std::vector<Eigen::Vector2d> vertices_m;
      for (Eigen::Index i = 0; i < foot.vertices_m.cols(); ++i) {
        vertices_m.emplace_back(foot.vertices_m.col(i).head<2>());
      }
      soles[static_cast<std::size_t>(found - feet.begin())] = ConvexHull(std::move(vertices_m));
    }
  } catch (const ConfigError&) {  // a run outlives its robot's files: its feet are points then
  }
  return soles;
}

// Where `holds` is true of a row, from its time to that of the first row after.
template <typename Holds>
std::vector<Stretch> StretchesOf(const std::vector<double>& time_s, Holds holds) {
  std::vector<Stretch> stretches;
  for (std::size_t row = 0; row < time_s.size(); ++row) {
    const bool held_before = row > 0 && holds(row - 1);
    if (held_before) stretches.back().end_s = time_s[row];
    if (holds(row) && !held_before) stretches.push_back({time_s[row], time_s[row]});
  }
  return stretches;
}

void ReadContactsInto(const TimedRows& trajectory, PlotData* data) {
  const std::vector<double>& time_s = trajectory.time_s();
  std::vector<bool> stands(time_s.size(), false);
  for (const std::string& foot : data->feet) {
    const std::vector<double> truth = trajectory.Numbers("truth_contact_" + foot);
    const std::vector<double> planned = trajectory.Numbers("planned_contact_" + foot);
    const auto is_set = [](const std::vector<double>& flags) {
      return [&flags](std::size_t row) { return flags[row] > 0.5; };  // an empty cell is NaN
    };
    data->contacts.push_back(
        {StretchesOf(time_s, is_set(truth)), StretchesOf(time_s, is_set(planned))});
    for (std::size_t row = 0; row < truth.size(); ++row) {
      if (truth[row] > 0.5) stands[row] = true;
    }
  }
  data->flights = StretchesOf(time_s, [&](std::size_t row) { return !stands[row]; });
  std::erase_if(data->flights, [](const Stretch& flight) {
    return flight.end_s - flight.start_s < kShortestFlight_s;
  });
}

void ReadPushMarksInto(const TimedRows& trajectory, PlotData* data) {
  const std::vector<double>& time_s = trajectory.time_s();
  const auto x = trajectory.Numbers("truth_p_WC_x_m"), y = trajectory.Numbers("truth_p_WC_y_m");
  const auto force_x = trajectory.Numbers("push_force_W_x_N");
  const auto force_y = trajectory.Numbers("push_force_W_y_N");
  for (const Stretch& push : data->pushes) {
    const auto at = std::lower_bound(time_s.begin(), time_s.end(), push.start_s);
    if (at == time_s.end() || push.end_s < time_s.front()) continue;
    const auto first = static_cast<std::size_t>(at - time_s.begin());
    PushMark mark{x[first], y[first], 0.0, 0.0};
    for (std::size_t row = first; row < time_s.size() && time_s[row] <= push.end_s; ++row) {
      if (std::hypot(force_x[row], force_y[row]) <= std::hypot(mark.force_x_N, mark.force_y_N)) {
        continue;
      }
      mark.force_x_N = force_x[row];
      mark.force_y_N = force_y[row];
    }
    data->push_marks.push_back(mark);
  }
}

void ReadSummaryInto(const RunSummary& summary, PlotData* data) {
  data->title = summary.name + " (" + std::string(EnumName(summary.verdict)) + ")";
  for (const PushSummary& push : summary.pushes) {
    data->pushes.push_back({push.start_s, push.start_s + push.duration_s});
  }
  for (const GaitSummary& gait : summary.gaits) {
    data->gaits.push_back({gait.start_s, std::string(EnumName(gait.type))});
  }
  const auto drawn = [](double ms) { return std::isfinite(ms) ? ms : 0.0; };
  data->deadline_ms = drawn(summary.solve_time.deadline_ms);
  data->p50_ms = drawn(summary.solve_time.p50_ms);
  data->p99_ms = drawn(summary.solve_time.p99_ms);
}

double Moved_m(const Footstep& step) {
  const double moved_m = (step.adjusted_p_WF - step.nominal_p_WF).head<2>().norm();
  return std::isfinite(moved_m) ? moved_m : 0.0;
}

void MarkFarMoved(std::vector<PlottedStep>* steps) {
  constexpr std::size_t kMost = 6;  // more boxes would be a hatch
  constexpr double kLeast_m = 0.01;
  std::vector<PlottedStep*> by_distance;
  for (PlottedStep& step : *steps) by_distance.push_back(&step);
  std::stable_sort(by_distance.begin(), by_distance.end(), [](const auto* a, const auto* b) {
    return Moved_m(a->step) > Moved_m(b->step);
  });
  for (std::size_t i = 0; i < std::min(kMost, by_distance.size()); ++i) {
    by_distance[i]->is_far_moved = Moved_m(by_distance[i]->step) > kLeast_m;
  }
}

// Contacts that the stretch of time sees, numbered in the order of all touch-downs.
void ReadStepsInto(const std::vector<Footstep>& footsteps, double run_start_s, PlotData* data) {
  std::vector<double> lift_s(data->feet.size(), run_start_s);
  int number = 0;
  for (const Footstep& footstep : footsteps) {
    const auto foot = std::find(data->feet.begin(), data->feet.end(), footstep.foot);
    if (foot == data->feet.end()) continue;
    PlottedStep step;
    step.step = footstep;
    step.foot = static_cast<std::size_t>(foot - data->feet.begin());
    step.number = footstep.start_s > run_start_s ? ++number : 0;
    step.lift_s = lift_s[step.foot];
    lift_s[step.foot] = footstep.end_s;
    const bool is_seen =
        footstep.end_s >= data->start_s && std::min(step.lift_s, footstep.start_s) <= data->end_s;
    if (is_seen) data->steps.push_back(step);
  }
  MarkFarMoved(&data->steps);
}

}  // namespace

PlottedRun ReadPlottedRun(const std::filesystem::path& run_dir) {
  PlottedRun run{ReadSummary(run_dir),
                 ReadTrajectory(run_dir),
                 ReadFootsteps(run_dir),
                 CsvTable::Read(run_dir / "mpc.csv"),
                 {}};
  if (run.trajectory.num_rows() == 0) {
    throw ConfigError((run_dir / "trajectory.csv").string() + ": error: holds no row");
  }
  run.soles = ReadSoles(run_dir, FeetOf(run.trajectory));
  return run;
}

PlotData SelectPlotData(const PlottedRun& run, std::optional<Stretch> stretch, CurveFile curves) {
  PlotData data;
  data.curves = std::move(curves);
  ReadSummaryInto(run.summary, &data);
  data.feet = FeetOf(run.trajectory);
  data.soles = run.soles;
  const TimedRows trajectory(run.trajectory, stretch);
  if (trajectory.is_empty()) {
    throw ConfigError(data.title + ": error: the run has no time from " +
                      std::to_string(stretch->start_s) + " to " + std::to_string(stretch->end_s) +
                      " s");
  }
  data.start_s = trajectory.time_s().front();
  data.end_s = std::max(trajectory.time_s().back(), data.start_s + 1e-3);  // an axis has a length
  ReadContactsInto(trajectory, &data);
  ReadPushMarksInto(trajectory, &data);
  ReadStepsInto(run.footsteps, run.trajectory.Numbers("time_s").front(), &data);
  AddCurves(trajectory, TimedRows(run.solves, stretch), &data);
  return data;
}

PlotData LoadPlotData(const std::filesystem::path& run_dir, CurveFile curves) {
  return SelectPlotData(ReadPlottedRun(run_dir), {}, std::move(curves));
}

}  // namespace sidestep::plot
