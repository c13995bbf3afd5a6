// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_writer.h"

#include <algorithm>

#include "controller/planner/bounce.h"
#include "models/support/gravity.h"
#include "models/support/require.h"

namespace sidestep {

GaitWriter::GaitWriter(const GaitSetup& setup, const GaitSupport& support,
                       ContactSchedule* schedule)
    : setup_(setup), support_(support), schedule_(schedule) {
  SIDESTEP_REQUIRE(!setup.segments.empty(), setup.segments.size());
  if (schedule_ == nullptr) return;
  const auto num_feet = static_cast<std::size_t>(setup.geometry.num_feet);
  schedule_->feet.resize(num_feet);
  for (std::size_t foot = 0; foot < num_feet; ++foot) {
    if (support.feet[foot].stands()) schedule_->feet[foot].push_back(support.feet[foot].nominal);
  }
  for (std::size_t i = 0; i < support.num_passed; ++i) schedule_->com.push_back(support.passed[i]);
}

void GaitWriter::StandAtTheBegin() {
  for (int foot = 0; foot < setup_.geometry.num_feet; ++foot) {
    support_.sequence = -1;  // every foot stands there from landing 0 on
    Foot(foot).nominal.contact.index = -1;
    Land(foot, 0, setup_.segments.front());
  }
  AddComKnot(0, true);
}

bool GaitWriter::Step() {
  lift_offs_ = {};
  BeginOrder();
  const GaitParams gait = NextGait();
  const bool is_of_one_foot = gait.type == GaitType::kHop;
  SIDESTEP_REQUIRE(
      gait.type == GaitType::kStand || is_of_one_foot == (setup_.geometry.num_feet == 1),
      setup_.geometry.num_feet);
  bool goes_on = true;
  switch (gait.type) {
    case GaitType::kStand:
      goes_on = Stand();
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
  if (!goes_on) return false;
  support_.previous = gait;
  EndOrder();
  return true;
}

GaitParams GaitWriter::NextGait() const {
  for (const StepOrder& order : support_.orders.next) {
    if (order.steps > 0) return order.gait;
  }
  if (support_.orders.instead) return *support_.orders.instead;
  const std::vector<GaitParams>& segments = setup_.segments;
  std::size_t at = 0;
  while (at + 1 < segments.size() && Ticks(segments[at + 1].start_s) <= support_.tick) ++at;
  return segments[at];
}

void GaitWriter::BeginOrder() {
  for (StepOrder& order : support_.orders.next) {
    if (order.steps == 0) continue;
    if (order.first_foot >= 0) support_.next_foot = order.first_foot;
    order.first_foot = -1;
    return;
  }
}

void GaitWriter::EndOrder() {
  for (StepOrder& order : support_.orders.next) {
    if (order.steps == 0) continue;
    --order.steps;
    return;
  }
}

// A move was checked against the step that it was made for; one that has become another since then,
// for a new gait begins sooner, must not end before it begins.
Tick GaitWriter::Moved(Tick in_the_air, Tick least) const {
  const TouchDownMove move = MoveOfNextLanding();
  return move.by == 0 ? in_the_air : std::max(in_the_air + move.by, least);
}

TouchDownMove GaitWriter::MoveOfNextLanding() const {
  for (const TouchDownMove& move : support_.orders.moves) {
    if (move.sequence == support_.sequence + 1) return move;
  }
  return {};
}

std::optional<Tick> GaitWriter::NextSegmentStart() const {
  if (support_.orders.instead) return std::nullopt;
  for (const GaitParams& segment : setup_.segments) {
    if (Ticks(segment.start_s) > support_.tick) return Ticks(segment.start_s);
  }
  return std::nullopt;
}

// Puts `foot` on the ground at the path's place, a half width aside, a landing further.
void GaitWriter::Land(int foot, Tick tick, const GaitParams& gait) {
  const GaitGeometry& geometry = setup_.geometry;
  double y_m = support_.path_y_m;
  if (geometry.num_feet == 2) y_m += (foot == 0 ? 0.5 : -0.5) * gait.step_width_m;
  Foot(foot).path_y_m = support_.path_y_m;
  NominalContact& next = Foot(foot).nominal;
  const int index = next.contact.index + 1;
  next = {};
  next.contact.index = index;
  next.contact.start_tick = next.contact.end_tick = tick;
  next.contact.due_tick = tick - MoveOfNextLanding().waited;
  next.contact.end_is_known = false;
  next.contact.nominal_p_WF = {support_.path_x_m, y_m, geometry.sole_height_m};
  next.contact.adjusted_p_WF = next.contact.nominal_p_WF;
  next.contact.swing = {gait.swing_height_m, gait.landing_speed_mps};
  next.contact.box_lower_m = geometry.box_lower_m;
  next.contact.box_upper_m = geometry.box_upper_m;
  if (foot == 1) {
    next.contact.box_lower_m.y() = -geometry.box_upper_m.y();
    next.contact.box_upper_m.y() = -geometry.box_lower_m.y();
  }
  next.sequence = ++support_.sequence;
  if (schedule_ != nullptr) schedule_->feet[static_cast<std::size_t>(foot)].push_back(next);
}

void GaitWriter::LiftOff(int foot, Tick tick) {
  const auto end = [tick](PlannedContact* contact) {
    contact->end_tick = tick;
    contact->end_is_known = true;
  };
  end(&Foot(foot).nominal.contact);
  if (schedule_ != nullptr) {
    end(&schedule_->feet[static_cast<std::size_t>(foot)].back().contact);
  }
  lift_offs_[static_cast<std::size_t>(foot)] = tick;
}

void GaitWriter::CloseAt(Tick tick) {
  for (auto& contacts : schedule_->feet) {
    if (contacts.empty() || contacts.back().contact.end_is_known) continue;
    contacts.back().contact.end_tick = std::max(tick, support_.tick);
  }
}

// Leaves a knot out that would be before the last: of a closing step that began while running.
void GaitWriter::AddKnot(ComKnot knot) {
  if (support_.num_passed > 0 && knot.tick < support_.last_passed().tick) return;
  knot.sequence = support_.sequence;
  knot.shift = support_.shift;
  support_.Pass(knot);
  if (schedule_ != nullptr) schedule_->com.push_back(knot);
}

void GaitWriter::AddComKnot(Tick tick, bool at_rest, double haste) {
  double x_sum_m = 0.0;
  double y_sum_m = 0.0;
  int standing = 0;
  for (int foot = 0; foot < setup_.geometry.num_feet; ++foot) {
    if (!Foot(foot).stands()) continue;
    x_sum_m += FootX(foot);
    y_sum_m += Foot(foot).path_y_m;
    ++standing;
  }
  SIDESTEP_REQUIRE(standing > 0, standing);
  AddKnot({.tick = tick,
           .p_WC = {x_sum_m / standing, y_sum_m / standing, setup_.geometry.com_height_m},
           .at_rest = at_rest,
           .haste = haste});
}

// In the middle of a swing: halfway between the double supports around it, and towards the foot
// that stands.
void GaitWriter::AddSwayKnot(Tick tick, int stance, const GaitParams& gait, const Sway& sway) {
  const double next_x_m = support_.path_x_m + gait.step_length_m;
  const double x_m = 0.25 * (2.0 * FootX(stance) + FootX(1 - stance) + next_x_m);
  const double path_y_m = support_.path_y_m + 0.5 * gait.step_side_m;
  const double foot_y_m = Foot(stance).nominal.contact.nominal_p_WF.y();
  const double aside_m = foot_y_m - path_y_m;
  AddKnot({.tick = tick,
           .p_WC = {x_m, path_y_m + sway.share * aside_m, setup_.geometry.com_height_m},
           .a_WC = {0.0, -sway.turn_back_per_s2 * aside_m, 0.0}});
}

void GaitWriter::AddBounceKnots(int foot, Tick lift_off, const GaitParams& gait) {
  const Bounce bounce = BounceOf(gait);
  const double height_m = setup_.geometry.com_height_m;
  const Eigen::Vector3d support(FootX(foot), Foot(foot).path_y_m, height_m);
  const Eigen::Vector3d next(support_.path_x_m + gait.step_length_m,
                             support_.path_y_m + gait.step_side_m, height_m);
  AddKnot({.tick = lift_off - Ticks(gait.stance_s) / 2,
           .p_WC = support - Eigen::Vector3d(0.0, 0.0, bounce.depth_m),
           .a_WC = {0.0, 0.0, bounce.stance_mps2}});
  if (gait.flight_s == 0.0) return;
  AddKnot({.tick = lift_off + Ticks(gait.flight_s) / 2,
           .p_WC = 0.5 * (support + next) + Eigen::Vector3d(0.0, 0.0, bounce.rise_m),
           .a_WC = {0.0, 0.0, -kGravity_mps2}});
}

bool GaitWriter::Stand() {
  if (setup_.geometry.num_feet == 2 && !FeetSideBySide()) {
    SIDESTEP_REQUIRE(support_.previous.has_value(), "a gait begins side by side");
    GaitParams closing = *support_.previous;
    closing.step_length_m = 0.0;
    closing.step_side_m = 0.0;
    WalkStep(closing);
    return true;
  }
  AddComKnot(support_.tick + 1, true);
  const std::optional<Tick> next_segment = NextSegmentStart();
  if (!next_segment) return false;
  support_.tick = std::max(*next_segment, support_.tick + 2);
  AddComKnot(support_.tick, true);
  return true;
}

bool GaitWriter::FeetSideBySide() const {
  if (setup_.geometry.num_feet == 1) return Foot(0).stands();
  return Foot(0).stands() && Foot(1).stands() && FootX(0) == FootX(1) &&
         Foot(0).path_y_m == Foot(1).path_y_m;
}

void GaitWriter::WalkStep(const GaitParams& gait) {
  const int swing = support_.next_foot;
  const Tick swing_ticks = Moved(Ticks(gait.swing_s), 1);
  const Sway sway = SwayOf(setup_.geometry.sway, gait, setup_.geometry.com_height_m);
  Tick landing = support_.tick + swing_ticks;
  if (Foot(swing).stands()) {
    const Tick double_support = Ticks(gait.double_support_s);
    const bool goes_on = support_.num_passed > 0 && !support_.last_passed().at_rest;
    AddComKnot(support_.tick + double_support / 2, false, goes_on ? sway.haste : 1.0);
    LiftOff(swing, support_.tick + double_support);
    landing += double_support;
  }
  if (sway.share > 0.0) AddSwayKnot(landing - swing_ticks / 2, 1 - swing, gait, sway);
  Advance(swing, landing, gait);
}

void GaitWriter::RunStep(const GaitParams& gait) {
  const int swing = support_.next_foot;
  const int stance = 1 - swing;
  const Tick stance_ticks = Ticks(gait.stance_s);
  // Coming from a walk the rear foot is still down: it leaves as it would have when walking.
  if (Foot(swing).stands()) {
    const bool from_walk = support_.previous && support_.previous->type == GaitType::kWalk;
    const Tick overlap = from_walk ? Ticks(support_.previous->double_support_s) : 0;
    LiftOff(swing, support_.tick + std::min(overlap, stance_ticks / 2));
  }
  AddBounceKnots(stance, support_.tick + stance_ticks, gait);
  LiftOff(stance, support_.tick + stance_ticks);
  Advance(swing, support_.tick + stance_ticks + Moved(Ticks(gait.flight_s), 0), gait);
}

void GaitWriter::HopStep(const GaitParams& gait) {
  const Tick lift_off = support_.tick + Ticks(gait.stance_s);
  AddBounceKnots(0, lift_off, gait);
  LiftOff(0, lift_off);
  Advance(0, lift_off + Moved(Ticks(gait.flight_s), 1), gait);
}

void GaitWriter::Advance(int foot, Tick landing, const GaitParams& gait) {
  SIDESTEP_REQUIRE(landing > support_.tick, landing - support_.tick);
  support_.path_x_m += gait.step_length_m;
  support_.path_y_m += gait.step_side_m;
  Land(foot, landing, gait);
  if (setup_.geometry.num_feet == 2) support_.next_foot = 1 - foot;
  support_.tick = landing;
}

}  // namespace sidestep
