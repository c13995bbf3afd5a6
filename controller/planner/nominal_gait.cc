// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/nominal_gait.h"

#include <algorithm>
#include <array>
#include <limits>

#include "models/support/require.h"

namespace sidestep {
namespace {

constexpr Tick kForever = std::numeric_limits<Tick>::max() / 4;

// Walks through time, one support after the other, and writes contacts and CoM knots down.
class GaitWriter {
 public:
  GaitWriter(const std::vector<GaitParams>& segments, const GaitGeometry& geometry, double tick_s)
      : segments_(segments), geometry_(geometry), tick_s_(tick_s) {
    const int num_feet = geometry.num_feet;
    gait_.feet.resize(static_cast<std::size_t>(num_feet));
    for (int foot = 0; foot < num_feet; ++foot) {
      sequence_ = -1;  // every foot stands there from landing 0 on
      Land(foot, 0, segments.front());
    }
    AddComKnot(0, true);
  }

  // Goes on from a gait under way in which every foot stands at `tick`.
  GaitWriter(const std::vector<GaitParams>& segments, const GaitGeometry& geometry, double tick_s,
             NominalGait gait, Tick tick)
      : segments_(segments),
        geometry_(geometry),
        tick_s_(tick_s),
        gait_(std::move(gait)),
        previous_(&SegmentAt(tick)),
        now_(tick) {
    Forget(tick);
    const double half_width_m = 0.5 * previous_->step_width_m;
    path_x_m_ = std::max(FootX(0), FootX(1));
    path_y_of_foot_m_ = {Contacts(0).back().contact.nominal_p_WF.y() - half_width_m,
                         Contacts(1).back().contact.nominal_p_WF.y() + half_width_m};
    path_y_m_ = 0.5 * (PathY(0) + PathY(1));
    AddComKnot(tick, false);
  }

  // Quick steps on the spot.
  void Recover(const RecoveryParams& recovery, int first_foot) {
    recovery_ = *previous_;
    recovery_.step_length_m = recovery_.step_side_m = 0.0;
    recovery_.swing_s = recovery.swing_s;
    recovery_.double_support_s = recovery.double_support_s;
    next_foot_ = first_foot;
    for (int step = 0; step < recovery.steps; ++step) WalkStep(recovery_);
    previous_ = &recovery_;
  }

  NominalGait Write(Tick end_tick) {
    while (now_ < end_tick) {
      const GaitParams& gait = SegmentAt(now_);
      switch (gait.type) {
        case GaitType::kStand:
          Stand(end_tick);
          break;
        case GaitType::kWalk:
          WalkStep(gait);
          break;
        case GaitType::kRun:
          RunStep(gait);
          break;
        case GaitType::kHop:
          HopStep(gait);
          break;
      }
      previous_ = &gait;
    }
    if (gait_.com.size() < 2) AddComKnot(end_tick, true);
    return std::move(gait_);
  }

 private:
  // Drops what has not begun at `tick`.
  void Forget(Tick tick) {
    sequence_ = 0;
    for (auto& contacts : gait_.feet) {
      while (contacts.back().contact.start_tick > tick) contacts.pop_back();
      contacts.back().contact.end_tick = kForever;
      sequence_ = std::max(sequence_, contacts.back().sequence);
    }
    while (!gait_.com.empty() && gait_.com.back().tick >= tick) gait_.com.pop_back();
  }

  Tick Ticks(double time_s) const { return TickAt(time_s, tick_s_); }

  const GaitParams& SegmentAt(Tick tick) const {
    std::size_t at = 0;
    while (at + 1 < segments_.size() && Ticks(segments_[at + 1].start_s) <= tick) ++at;
    return segments_[at];
  }

  // Start of the next segment after now, or `end`.
  Tick NextSegmentStart(Tick end) const {
    for (const GaitParams& segment : segments_) {
      if (Ticks(segment.start_s) > now_) return Ticks(segment.start_s);
    }
    return end;
  }

  std::vector<NominalContact>& Contacts(int foot) {
    return gait_.feet[static_cast<std::size_t>(foot)];
  }
  bool OnGround(int foot) { return Contacts(foot).back().contact.end_tick == kForever; }
  double FootX(int foot) { return Contacts(foot).back().contact.nominal_p_WF.x(); }
  double& PathY(int foot) { return path_y_of_foot_m_[static_cast<std::size_t>(foot)]; }

  void Land(int foot, Tick tick, const GaitParams& gait) {
    double y_m = path_y_m_;
    if (geometry_.num_feet == 2) y_m += (foot == 0 ? 0.5 : -0.5) * gait.step_width_m;
    PathY(foot) = path_y_m_;
    NominalContact next;
    next.contact.index = static_cast<int>(Contacts(foot).size());
    next.contact.start_tick = tick;
    next.contact.end_tick = kForever;
    next.contact.nominal_p_WF = {path_x_m_, y_m, geometry_.sole_height_m};
    next.contact.adjusted_p_WF = next.contact.nominal_p_WF;
    next.contact.box_lower_m = geometry_.box_lower_m;
    next.contact.box_upper_m = geometry_.box_upper_m;
    if (foot == 1) {
      next.contact.box_lower_m.y() = -geometry_.box_upper_m.y();
      next.contact.box_upper_m.y() = -geometry_.box_lower_m.y();
    }
    next.sequence = ++sequence_;
    Contacts(foot).push_back(next);
  }

  void LiftOff(int foot, Tick tick) { Contacts(foot).back().contact.end_tick = tick; }

  // Midpoint of the feet on the ground at this moment; y on the path.
  void AddComKnot(Tick tick, bool at_rest) {
    double x_sum_m = 0.0;
    double y_sum_m = 0.0;
    int standing = 0;
    for (int foot = 0; foot < geometry_.num_feet; ++foot) {
      if (!OnGround(foot)) continue;
      x_sum_m += FootX(foot);
      y_sum_m += PathY(foot);
      ++standing;
    }
    SIDESTEP_REQUIRE(standing > 0, standing);
    const Eigen::Vector3d p_WC(x_sum_m / standing, y_sum_m / standing, geometry_.com_height_m);
    gait_.com.push_back({tick, p_WC, sequence_, at_rest});
  }

  // In the middle of a swing: halfway between the double supports around it, and towards the foot
  // that stands.
  void AddSwayKnot(Tick tick, int stance, const GaitParams& gait) {
    const double next_x_m = path_x_m_ + gait.step_length_m;
    const double x_m = 0.25 * (2.0 * FootX(stance) + FootX(1 - stance) + next_x_m);
    const double path_y_m = path_y_m_ + 0.5 * gait.step_side_m;
    const double foot_y_m = Contacts(stance).back().contact.nominal_p_WF.y();
    const double y_m = path_y_m + geometry_.com_sway * (foot_y_m - path_y_m);
    gait_.com.push_back({tick, {x_m, y_m, geometry_.com_height_m}, sequence_, false});
  }

  void Stand(Tick end_tick) {
    if (geometry_.num_feet == 2 && !FeetSideBySide()) {
      SIDESTEP_REQUIRE(previous_ != nullptr, "a gait begins side by side");
      GaitParams closing = *previous_;
      closing.step_length_m = 0.0;
      closing.step_side_m = 0.0;
      WalkStep(closing);
      return;
    }
    AddComKnot(now_ + 1, true);
    now_ = std::max(NextSegmentStart(end_tick), now_ + 2);
    AddComKnot(now_, true);
  }

  bool FeetSideBySide() {
    return OnGround(0) && OnGround(1) && FootX(0) == FootX(1) && PathY(0) == PathY(1);
  }

  void WalkStep(const GaitParams& gait) {
    const int swing = next_foot_;
    Tick landing = now_ + Ticks(gait.swing_s);
    if (OnGround(swing)) {
      const Tick double_support = Ticks(gait.double_support_s);
      AddComKnot(now_ + double_support / 2, false);
      LiftOff(swing, now_ + double_support);
      landing += double_support;
    }
    if (geometry_.com_sway > 0.0) AddSwayKnot(landing - Ticks(gait.swing_s) / 2, 1 - swing, gait);
    Advance(swing, landing, gait);
  }

  void RunStep(const GaitParams& gait) {
    const int swing = next_foot_;
    const int stance = 1 - swing;
    const Tick stance_ticks = Ticks(gait.stance_s);
    // Coming from a walk the rear foot is still down: it leaves as it would have when walking.
    if (OnGround(swing)) {
      const bool from_walk = previous_ != nullptr && previous_->type == GaitType::kWalk;
      const Tick overlap = from_walk ? Ticks(previous_->double_support_s) : 0;
      LiftOff(swing, now_ + std::min(overlap, stance_ticks / 2));
    }
    AddComKnot(now_ + stance_ticks / 2, false);
    LiftOff(stance, now_ + stance_ticks);
    Advance(swing, now_ + stance_ticks + Ticks(gait.flight_s), gait);
  }

  void HopStep(const GaitParams& gait) {
    AddComKnot(now_ + Ticks(gait.stance_s) / 2, false);
    LiftOff(0, now_ + Ticks(gait.stance_s));
    Advance(0, now_ + Ticks(gait.stance_s) + Ticks(gait.flight_s), gait);
  }

  void Advance(int foot, Tick landing, const GaitParams& gait) {
    path_x_m_ += gait.step_length_m;
    path_y_m_ += gait.step_side_m;
    Land(foot, landing, gait);
    if (geometry_.num_feet == 2) next_foot_ = 1 - foot;
    now_ = landing;
  }

  const std::vector<GaitParams>& segments_;
  GaitGeometry geometry_;
  double tick_s_;
  NominalGait gait_;
  const GaitParams* previous_{nullptr};
  GaitParams recovery_;
  Tick now_{0};
  double path_x_m_{0.0};
  double path_y_m_{0.0};
  std::array<double, 2> path_y_of_foot_m_{};  // of the path, where each foot landed last
  int next_foot_{0};
  int sequence_{0};
};

}  // namespace

NominalGait BuildNominalGait(const std::vector<GaitParams>& segments, const GaitGeometry& geometry,
                             Tick end_tick, double tick_s) {
  SIDESTEP_REQUIRE(!segments.empty(), segments.size());
  return GaitWriter(segments, geometry, tick_s).Write(end_tick);
}

void InsertRecovery(const RecoveryParams& recovery, int first_foot,
                    const std::vector<GaitParams>& segments, const GaitGeometry& geometry,
                    Tick tick, Tick end_tick, double tick_s, NominalGait* gait) {
  SIDESTEP_REQUIRE(gait->feet.size() == 2, gait->feet.size());
  GaitWriter writer(segments, geometry, tick_s, std::move(*gait), tick);
  writer.Recover(recovery, first_foot);
  *gait = writer.Write(end_tick);
}

}  // namespace sidestep
