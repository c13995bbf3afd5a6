// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/gait_meter.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "models/support/gravity.h"
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
  const Instant now = InstantOf(tick, truth, stances);
  const auto& in_stance = now.in_stance;
  const bool has_begun = last_ || !recent_.empty();
  if (!has_begun && std::find(in_stance.begin(), in_stance.end(), true) == in_stance.end()) return;
  recent_.push_back(now);
  for (std::size_t foot = 0; foot < plant_.num_feet; ++foot) {
    if (in_stance[foot]) BridgeBreak(foot);
  }
  std::copy_if(touch_downs.begin(), touch_downs.end(), std::back_inserter(steps_),
               [](const TouchDown& touch_down) { return touch_down.is_step; });
  const Tick wait = TickAt(kShortestStance_s, tick_s_);
  while (tick - recent_.front().tick >= wait) {
    Settle(recent_.front());
    recent_.pop_front();
  }
}

GaitMeter::Instant GaitMeter::InstantOf(Tick tick, const WorldTruth& truth,
                                        const std::vector<StanceMeter>& stances) {
  Instant instant{tick, {}, truth.p_WC.head<2>(), PositivePower_W(truth), 0.0};
  for (const StanceMeter& stance : stances) instant.in_stance.push_back(stance.bears_load());
  for (const FootTruth& foot : truth.feet) {
    instant.max_force_N = std::max(instant.max_force_N, foot.f_F_W.z());
  }
  return instant;
}

// The foot bears load at the latest tick: if it did so a bounce before, it stood in between.
void GaitMeter::BridgeBreak(std::size_t foot) {
  const auto in_stance = [&](const Instant& instant) { return instant.in_stance[foot]; };
  const auto broken = std::next(recent_.rbegin());
  const auto before = std::find_if(broken, recent_.rend(), in_stance);
  if (before == recent_.rend()) return;
  const Tick break_start = std::prev(before)->tick;
  if (recent_.back().tick - break_start > TickAt(kBounce_s, tick_s_)) return;
  std::for_each(broken, before, [&](Instant& instant) { instant.in_stance[foot] = true; });
}

void GaitMeter::Settle(const Instant& instant) {
  if (last_) Integrate(instant);
  last_ = instant;
  sums_.tick = instant.tick;
  sums_.p_WC = instant.p_WC;
  for (; !steps_.empty() && steps_.front().tick <= instant.tick; steps_.pop_front()) {
    NoteStep(steps_.front());
  }
  for (double& max_force_N : max_force_N_) max_force_N = std::max(max_force_N, instant.max_force_N);
}

GaitMeter GaitMeter::Settled() const {
  GaitMeter settled = *this;
  for (const Instant& instant : recent_) settled.Settle(instant);
  settled.recent_.clear();
  return settled;
}

// From the last instant to this one. Feet count as they were at the last one, work as that of the
// step that led here.
void GaitMeter::Integrate(const Instant& instant) {
  const double dt_s = SecondsAt(instant.tick - last_->tick, tick_s_);
  const auto num_standing = std::count(last_->in_stance.begin(), last_->in_stance.end(), true);
  const double flight_s = num_standing == 0 ? dt_s : 0.0;
  sums_.stance_s += static_cast<double>(num_standing) * dt_s;
  sums_.flight_s += flight_s;
  sums_.work_J += instant.power_W * dt_s;
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
  const GaitMeter settled = Settled();
  std::vector<GaitRecord> records;
  for (const Segment& segment : settled.segments_)
    records.push_back({segment.gait, FiguresOf(segment)});
  return records;
}

GaitFigures GaitMeter::LastMoving() const {
  const std::vector<Segment> segments = Settled().segments_;
  const auto last = std::find_if(segments.rbegin(), segments.rend(), [](const Segment& segment) {
    return segment.gait.type != GaitType::kStand;
  });
  return last == segments.rend() ? GaitFigures{} : FiguresOf(*last);
}

double GaitMeter::WalkFlightFraction() const {
  const GaitMeter settled = Settled();
  double flight_s = 0.0, duration_s = 0.0;
  for (const Segment& segment : settled.segments_) {
    if (segment.gait.type != GaitType::kWalk) continue;
    flight_s += segment.flight_s;
    duration_s += segment.duration_s;
  }
  return RatioOrNaN(flight_s, duration_s);
}

double GaitMeter::RunFlightFraction() const {
  const GaitMeter settled = Settled();
  double flight_s = 0.0, duration_s = 0.0;
  for (const Segment& segment : settled.segments_) {
    if (segment.gait.type != GaitType::kRun && segment.gait.type != GaitType::kHop) continue;
    flight_s += segment.last.flight_s - segment.first.flight_s;
    duration_s += SecondsAt(segment.last.tick - segment.first.tick, tick_s_);
  }
  return RatioOrNaN(flight_s, duration_s);
}

}  // namespace sidestep
