// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace sidestep::plot {
namespace {

using Values = std::vector<double>;

// m or rad: what moves less, such as a planar robot to its side, has no portrait.
constexpr double kStill = 1e-4;

// Columns that are drawn over time as they are. Reading checks that each is there.
std::vector<std::string> TimeColumns(const std::vector<std::string>& feet) {
  std::vector<std::string> columns{"truth_tilt_rad"};
  const auto add_vector = [&](const std::string& stem, const std::string& unit) {
    for (const char* axis : {"_x_", "_y_", "_z_"}) columns.push_back(stem + axis + unit);
  };
  for (const char* who : {"truth", "belief", "reference", "mpc"}) {
    add_vector(std::string(who) + "_p_WC", "m");
    add_vector(std::string(who) + "_v_WC", "mps");
  }
  add_vector("truth_h_C_W", "kgm2ps");
  for (const char* push : {"push", "belief_push"}) {
    add_vector(std::string(push) + "_force_W", "N");
    add_vector(std::string(push) + "_torque_C_W", "Nm");
  }
  for (const std::string& foot : feet) {
    add_vector("truth_f_F_W_" + foot, "N");
    add_vector("mpc_f_F_W_" + foot, "N");
    columns.push_back("truth_p_WF_" + foot + "_z_m");
    columns.push_back("swing_p_WF_" + foot + "_z_m");
  }
  return columns;
}

std::vector<Sample> Samples(const Values& x, const Values& y) {
  std::vector<Sample> samples(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) samples[i] = {x[i], y[i]};
  return samples;
}

// Where the controller wants each foothold, against where the gait has it.
void AddAdjustments(const TimedRows& rows, PlotData* data) {
  for (const std::string& foot : data->feet) {
    for (const char* axis : {"_x_m", "_y_m"}) {
      Values moved_m = rows.Numbers("adjusted_p_WF_" + foot + axis);
      const Values nominal_m = rows.Numbers("nominal_p_WF_" + foot + axis);
      for (std::size_t i = 0; i < moved_m.size(); ++i) moved_m[i] -= nominal_m[i];
      data->curves.Add("adjustment_" + foot + axis, ThinGraph(Samples(rows.time_s(), moved_m)));
    }
  }
}

// Distance of the centre of pressure from F along the axes of W: -m_y / f_z and m_x / f_z.
void AddPressures(const TimedRows& rows, PlotData* data) {
  constexpr double kLeastLoad_N = 5.0;  // a foot that bears less has none worth a line
  for (const std::string& foot : data->feet) {
    const Values force_N = rows.Numbers("truth_f_F_W_" + foot + "_z_N");
    for (const bool is_x : {true, false}) {
      Values from_F_m = rows.Numbers("truth_m_F_W_" + foot + (is_x ? "_y_Nm" : "_x_Nm"));
      for (std::size_t i = 0; i < from_F_m.size(); ++i) {
        from_F_m[i] = force_N[i] > kLeastLoad_N ? (is_x ? -1.0 : 1.0) * from_F_m[i] / force_N[i]
                                                : std::numeric_limits<double>::quiet_NaN();
      }
      data->curves.Add("pressure_" + foot + (is_x ? "_x_m" : "_y_m"),
                       ThinGraph(Samples(rows.time_s(), from_F_m)));
    }
  }
}

// Slope at b of the parabola through three samples a, b, c: x is time, y the value. At an end of
// the samples b is that end, and a and c lie both on one side of it.
double SlopeAt(const Sample& a, const Sample& b, const Sample& c) {
  const double before = b.x - a.x, after = c.x - b.x;
  return ((b.y - a.y) / before * after + (c.y - b.y) / after * before) / (before + after);
}

// d/dt of values, to the square of the time between them also at their ends.
Values RatesOf(const Values& values, const Values& time_s) {
  const std::size_t count = values.size();
  Values rates(count, 0.0);
  if (count < 3) return rates;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i == 0 ? 2 : i - 1, after = i + 1 == count ? count - 3 : i + 1;
    const auto sample = [&](std::size_t at) { return Sample{time_s[at], values[at]}; };
    rates[i] = SlopeAt(sample(before), sample(i), sample(after));
  }
  return rates;
}

// Roll and pitch of the base (rad), yaw first. Roll goes on beyond half a turn, of one that falls
// over: a jump back would be a line across the portrait and a rate of thousands.
std::pair<Values, Values> RollAndPitch(const CsvTable& rows) {
  const Values w = rows.Numbers("truth_q_WB_w"), x = rows.Numbers("truth_q_WB_x");
  const Values y = rows.Numbers("truth_q_WB_y"), z = rows.Numbers("truth_q_WB_z");
  Values roll_rad, pitch_rad;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double up_y = 2.0 * (w[i] * x[i] + y[i] * z[i]);
    const double up_z = 1.0 - 2.0 * (x[i] * x[i] + y[i] * y[i]);
    const double roll = std::atan2(up_y, up_z), before = roll_rad.empty() ? roll : roll_rad.back();
    roll_rad.push_back(before + std::remainder(roll - before, 2.0 * std::numbers::pi));
    pitch_rad.push_back(std::asin(std::clamp(2.0 * (w[i] * y[i] - z[i] * x[i]), -1.0, 1.0)));
  }
  return {roll_rad, pitch_rad};
}

// A value against its rate in three parts: before the first push, during pushes, after them.
void AddPhase(const std::string& name, const Values& values, const Values& rates,
              const Values& time_s, PlotData* data) {
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  if (!(*max - *min > kStill)) return;
  data->phases.push_back(name);
  double first_s = std::numeric_limits<double>::infinity();
  for (const Stretch& push : data->pushes) first_s = std::min(first_s, push.start_s);
  std::vector<Sample> before, pushed, after;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double t = time_s[i];
    const bool is_pushed =
        std::any_of(data->pushes.begin(), data->pushes.end(),
                    [t](const Stretch& push) { return t >= push.start_s && t <= push.end_s; });
    const Sample sample{values[i], rates[i]}, gap{values[i], std::nan("")};
    before.push_back(t <= first_s ? sample : gap);
    pushed.push_back(is_pushed ? sample : gap);
    after.push_back(t >= first_s && !is_pushed ? sample : gap);
  }
  data->curves.Add(name + "_before", ThinPath(before));
  data->curves.Add(name + "_pushed", ThinPath(pushed));
  data->curves.Add(name + "_after", ThinPath(after));
}

void AddPhases(const TimedRows& rows, PlotData* data) {
  for (const char* axis : {"_y_", "_z_"}) {
    const std::string value = std::string("truth_p_WC") + axis + "m";
    AddPhase(value, rows.Numbers(value), rows.Numbers(std::string("truth_v_WC") + axis + "mps"),
             rows.time_s(), data);
  }
  // Rates of the whole log: those of a stretch's first and last row ask for the rows beside it.
  const Values time_s = rows.table().Numbers("time_s");
  const auto [roll_rad, pitch_rad] = RollAndPitch(rows.table());
  AddPhase("truth_roll_rad", rows.Cut(roll_rad), rows.Cut(RatesOf(roll_rad, time_s)), rows.time_s(),
           data);
  AddPhase("truth_pitch_rad", rows.Cut(pitch_rad), rows.Cut(RatesOf(pitch_rad, time_s)),
           rows.time_s(), data);
}

// Every solve is a point: none is left out.
void AddSolves(const TimedRows& solves, PlotData* data) {
  for (const auto& [name, column] : std::initializer_list<std::pair<const char*, const char*>>{
           {"solve_wall_ms", "wall_ms"},
           {"solve_cpu_ms", "cpu_ms"},
           {"solve_iterations", "iterations"}}) {
    if (solves.is_empty() || !solves.has(column)) continue;
    data->curves.Add(name, Samples(solves.time_s(), solves.Numbers(column)));
  }
}

}  // namespace

TimedRows::TimedRows(const CsvTable& table, const std::optional<Stretch>& stretch)
    : table_(table), time_s_(table.Numbers("time_s")) {
  if (!stretch) return;
  const auto from = std::lower_bound(time_s_.begin(), time_s_.end(), stretch->start_s);
  const auto to = std::upper_bound(from, time_s_.end(), stretch->end_s);
  first_ = static_cast<std::size_t>(from - time_s_.begin());
  time_s_ = Values(from, to);
}

Values TimedRows::Cut(Values values) const {
  if (values.size() == time_s_.size()) return values;
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(first_);
  return {first, first + static_cast<std::ptrdiff_t>(time_s_.size())};
}

void AddCurves(const TimedRows& trajectory, const TimedRows& solves, PlotData* data) {
  for (const std::string& column : TimeColumns(data->feet)) {
    data->curves.Add(column, ThinGraph(Samples(trajectory.time_s(), trajectory.Numbers(column))));
  }
  for (const std::string who : {"truth", "reference"}) {
    const Values x = trajectory.Numbers(who + "_p_WC_x_m");
    data->curves.Add(who + "_path", ThinPath(Samples(x, trajectory.Numbers(who + "_p_WC_y_m"))));
  }
  AddAdjustments(trajectory, data);
  AddPressures(trajectory, data);
  AddPhases(trajectory, data);
  AddSolves(solves, data);
}

}  // namespace sidestep::plot
