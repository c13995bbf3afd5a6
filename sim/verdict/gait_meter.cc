// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/gait_meter.h"

#include <algorithm>
#include <limits>

#include "controller/types/gravity.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

// Per stride. A robot on the spot goes nowhere, and what it costs to get there means nothing.
constexpr double kLeastAdvance_m = 0.01;

double RatioOrNaN(double part_s, double whole_s) {
  return whole_s > 0.0 ? part_s / whole_s : std::numeric_limits<double>::quiet_NaN();
}

double PositivePower_W(const WorldTruth& truth) {
  double power_W = 0.0;
  for (Eigen::Index i = 0; i < truth.joint_torque_Nm.size(); ++i) {
    power_W += std::max(0.0, truth.joint_torque_Nm[i] * truth.joint_velocity[i]);
  }
  return power_W;
}

}  // namespace

GaitMeter::GaitMeter(const std::vector<GaitParams>& segments, const GaitPlant& plant, double tick_s)
    : plant_(plant), tick_s_(tick_s), max_force_N_(plant.num_feet, 0.0) {
  SIDESTEP_REQUIRE(!segments.empty(), segments.size());
  for (const GaitParams& gait : segments) segments_.emplace_back().gait = gait;
}

void GaitMeter::Add(Tick tick, const WorldTruth& truth, const std::vector<StanceMeter>& stances,
                    std::span<const TouchDown> touch_downs) {
  SIDESTEP_REQUIRE(truth.feet.size() == plant_.num_feet, truth.feet.size());
  SIDESTEP_REQUIRE(stances.size() == plant_.num_feet, stances.size());
  SIDESTEP_REQUIRE(truth.joint_velocity.size() == truth.joint_torque_Nm.size(),
                   truth.joint_velocity.size());
  if (last_tick_) Integrate(truth, SecondsAt(tick - *last_tick_, tick_s_));
  last_tick_ = tick;
  sums_.tick = tick;
  sums_.p_WC = truth.p_WC.head<2>();
  for (const TouchDown& touch_down : touch_downs) {
    if (touch_down.is_step) NoteStep(touch_down);
  }
  num_loaded_ =
      static_cast<int>(std::count_if(stances.begin(), stances.end(), [](const StanceMeter& stance) {
        return stance.bears_load();
      }));
  double force_N = 0.0;
  for (const FootTruth& foot : truth.feet) force_N = std::max(force_N, foot.f_F_W.z());
  for (double& max_force_N : max_force_N_) max_force_N = std::max(max_force_N, force_N);
}

// From the last tick to this one. Feet count as they were at the last one, work as that of the step
// that led here.
void GaitMeter::Integrate(const WorldTruth& truth, double dt_s) {
  const double flight_s = num_loaded_ == 0 ? dt_s : 0.0;
  sums_.stance_s += num_loaded_ * dt_s;
  sums_.flight_s += flight_s;
  sums_.work_J += PositivePower_W(truth) * dt_s;
  segments_[begun_].duration_s += dt_s;
  segments_[begun_].flight_s += flight_s;
}

std::size_t GaitMeter::SegmentAt(Tick tick) const {
  std::size_t at = 0;
  while (at + 1 < segments_.size() && TickAt(segments_[at + 1].gait.start_s, tick_s_) <= tick) ++at;
  return at;
}

void GaitMeter::NoteStep(const TouchDown& touch_down) {
  ++sums_.steps;
  Mark mark = sums_;
  mark.p_WF = touch_down.p_WF.head<2>();
  const std::size_t before = begun_;
  begun_ = SegmentAt(touch_down.tick);
  if (begun_ != before) CloseStride(touch_down.foot, mark, segments_[before]);
  Segment& segment = segments_[begun_];
  if (segment.foot) {
    CloseStride(touch_down.foot, mark, segment);
  } else {
    segment.foot = touch_down.foot;
    segment.first = segment.last = mark;
  }
  max_force_N_[touch_down.foot] = 0.0;
}

void GaitMeter::CloseStride(std::size_t foot, const Mark& mark, Segment& segment) const {
  if (segment.foot != foot) return;
  ++segment.strides;
  segment.last = mark;
  segment.max_force_N = std::max(segment.max_force_N, max_force_N_[foot]);
}

GaitFigures GaitMeter::FiguresOf(const Segment& segment) const {
  GaitFigures figures;
  figures.strides = segment.strides;
  if (segment.strides == 0) return figures;
  const Mark &first = segment.first, &last = segment.last;
  const double duration_s = SecondsAt(last.tick - first.tick, tick_s_);
  const double advance_m = (last.p_WC - first.p_WC).norm();
  const double weight_N = plant_.mass_kg * kGravity_mps2;
  const auto steps = static_cast<double>(last.steps - first.steps);
  figures.from_s = SecondsAt(first.tick, tick_s_);
  figures.to_s = SecondsAt(last.tick, tick_s_);
  figures.speed_mps = advance_m / duration_s;
  figures.step_length_m = (last.p_WF - first.p_WF).norm() / steps;
  figures.step_frequency_hz = steps / duration_s;
  figures.duty_factor =
      (last.stance_s - first.stance_s) / (static_cast<double>(plant_.num_feet) * duration_s);
  figures.flight_fraction = (last.flight_s - first.flight_s) / duration_s;
  if (plant_.has_motors && advance_m >= kLeastAdvance_m * segment.strides) {
    figures.cost_of_transport = (last.work_J - first.work_J) / (weight_N * advance_m);
  }
  figures.max_ground_force_ratio = segment.max_force_N / weight_N;
  return figures;
}

std::vector<GaitRecord> GaitMeter::Records() const {
  std::vector<GaitRecord> records;
  for (const Segment& segment : segments_) records.push_back({segment.gait, FiguresOf(segment)});
  return records;
}

GaitFigures GaitMeter::LastMoving() const {
  const auto last = std::find_if(segments_.rbegin(), segments_.rend(), [](const Segment& segment) {
    return segment.gait.type != GaitType::kStand;
  });
  return last == segments_.rend() ? GaitFigures{} : FiguresOf(*last);
}

double GaitMeter::WalkFlightFraction() const {
  double flight_s = 0.0, duration_s = 0.0;
  for (const Segment& segment : segments_) {
    if (segment.gait.type != GaitType::kWalk) continue;
    flight_s += segment.flight_s;
    duration_s += segment.duration_s;
  }
  return RatioOrNaN(flight_s, duration_s);
}

double GaitMeter::RunFlightFraction() const {
  double flight_s = 0.0, duration_s = 0.0;
  for (const Segment& segment : segments_) {
    if (segment.gait.type != GaitType::kRun && segment.gait.type != GaitType::kHop) continue;
    flight_s += segment.last.flight_s - segment.first.flight_s;
    duration_s += SecondsAt(segment.last.tick - segment.first.tick, tick_s_);
  }
  return RatioOrNaN(flight_s, duration_s);
}

}  // namespace sidestep
