// SPDX-License-Identifier: BSD-3-Clause
// A DcmPlan walks the pendulum that it knows: in closed loop with it, without a simulator.

#include "controller/dcm/dcm_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "controller/planner/capture_point.h"
#include "models/support/gravity.h"
#include "models/support/require.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::dcm::dcm_plan_test {
namespace {

constexpr double kMass_kg = 3.0;
constexpr double kStep_s = 0.005;  // of the pendulum, and a control tick
constexpr Tick kHorizon = 400;
constexpr Tick Ticks(double time_s) { return static_cast<Tick>(time_s / kStep_s + 0.5); }

Eigen::Matrix3Xd Sole() {
  Eigen::Matrix3Xd vertices_m(3, 4);
  vertices_m << 0.1, 0.1, -0.1, -0.1, 0.04, -0.04, -0.04, 0.04, 0.0, 0.0, 0.0, 0.0;
  return vertices_m;
}

// Bounds of a left step's adjustment (m); of nothing, where footholds are fixed.
struct Box {
  Eigen::Vector3d lower_m{-0.1, -0.05, 0.0};
  Eigen::Vector3d upper_m{0.2, 0.15, 0.0};
};
const Box kFixed{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};

DcmSetup SetupFor(Stepping stepping, const Box& box = {}) {
  DcmSetup setup;
  setup.control.stepping = stepping;
  setup.control.mpc.box_lower_m = box.lower_m;
  setup.control.mpc.box_upper_m = box.upper_m;
  setup.com_height_m = kComHeight_m;
  setup.mass_kg = kMass_kg;
  setup.vertices_m = {Sole(), Sole()};
  setup.tick_s = kStep_s;
  return setup;
}

GaitPlanner Walking(const Box& box) {
  GaitParams walk = Stretch(GaitType::kWalk, 0.5);
  walk.swing_s = 0.4;
  walk.double_support_s = 0.1;
  GaitSetup setup = SetupOf({Stretch(GaitType::kStand, 0.0), walk}, 2);
  setup.tick_s = kStep_s;
  setup.geometry.box_lower_m = box.lower_m;
  setup.geometry.box_upper_m = box.upper_m;
  return {setup, PlannerParams(), kHorizon};
}

// A linear pendulum whose feet are where the plan has them. Copies are independent.
class Walker {
 public:
  explicit Walker(Stepping stepping, const Box& box = {})
      : plan_(SetupFor(stepping, box)), planner_(Walking(box)) {
    state_.feet.resize(2);
    state_.p_WC = {0.0, 0.0, kComHeight_m};
  }

  void Tick1() {
    const ContactPlan& contacts = planner_.Update(state_, tick_);
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const PlannedContact& contact = contacts.feet[foot].front();
      if (contact.start_tick <= tick_) state_.feet[foot].p_WF = contact.adjusted_p_WF;
    }
    plan_.Update(state_, Eigen::Vector3d(0.0, 0.0, 0.25), tick_, &planner_);
    state_.v_WC += kStep_s * plan_.com().a_WC;
    state_.p_WC += kStep_s * state_.v_WC;
    ++tick_;
  }
  void GoOnTo(double time_s) {
    while (tick_ < Ticks(time_s)) Tick1();
  }
  void Kick(const Eigen::Vector3d& by_mps) { state_.v_WC += by_mps; }

  const DcmPlan& plan() const { return plan_; }
  const GaitPlanner& planner() const { return planner_; }
  const RobotState& state() const { return state_; }

  // From the middle of the feet.
  Eigen::Vector2d Off() const {
    return (state_.p_WC - 0.5 * (state_.feet[0].p_WF + state_.feet[1].p_WF)).head<2>();
  }

  std::string Bits() const {
    std::string text;
    const auto add = [&](const auto& vector) {
      text.append(reinterpret_cast<const char*>(vector.data()),
                  static_cast<std::size_t>(vector.size()) * sizeof(double));
    };
    add(state_.p_WC);
    add(state_.v_WC);
    for (std::size_t foot = 0; foot < 2; ++foot) {
      add(state_.feet[foot].p_WF);
      add(plan_.ForceOn(foot));
    }
    return text + std::to_string(planner_.support().tick);
  }

 private:
  DcmPlan plan_;
  GaitPlanner planner_;
  RobotState state_;
  Tick tick_{0};
};

class DcmPlanTest : public testing::TestWithParam<Stepping> {};

INSTANTIATE_TEST_SUITE_P(All, DcmPlanTest,
                         testing::Values(Stepping::kDcmQp, Stepping::kCapturePoint),
                         [](const auto& one) { return std::string(EnumName(one.param)); });

TEST_P(DcmPlanTest, ItsPendulumWalksAtTheGaitsSpeed) {
  Walker walker(GetParam());
  walker.GoOnTo(3);
  const double begin_m = walker.state().p_WC.x();
  walker.GoOnTo(8);  // ten steps of 0.1 m in half a second each
  EXPECT_NEAR(walker.state().p_WC.x() - begin_m, 1.0, 0.1);
  EXPECT_LT(walker.Off().norm(), 0.1);
  EXPECT_NEAR(walker.state().p_WC.z(), kComHeight_m, 1e-9);
}

// More than the sole takes back, and the QP by time alone: 0.05 m and 0.06 m of DCM.
Eigen::Vector3d KickFor(Stepping stepping) {
  return {0.0, stepping == Stepping::kDcmQp ? 0.27 : 0.22, 0.0};
}

TEST_P(DcmPlanTest, APushIsCaughtByASideStepInTheBox) {
  Walker walker(GetParam());
  walker.GoOnTo(4.25);
  walker.Kick(KickFor(GetParam()));
  double most_m = 0.0;
  for (int tick = 0; tick < Ticks(1.5); ++tick) {
    walker.Tick1();
    for (std::size_t foot = 0; foot < 2; ++foot) {
      for (const PlannedContact& contact : walker.planner().plan().feet[foot]) {
        const Eigen::Vector3d off_m = contact.adjusted_p_WF - contact.nominal_p_WF;
        EXPECT_GE((off_m - contact.box_lower_m).minCoeff(), -1e-9);
        EXPECT_LE((off_m - contact.box_upper_m).maxCoeff(), 1e-9);
        most_m = std::max(most_m, off_m.head<2>().norm());
      }
    }
  }
  EXPECT_GT(most_m, 0.02);
  walker.GoOnTo(9);
  EXPECT_LT(walker.Off().norm(), 0.1);
}

TEST_P(DcmPlanTest, ThePushIsNotCaughtWithFixedFootholds) {
  Walker walker(GetParam(), kFixed);
  walker.GoOnTo(4.25);
  walker.Kick(KickFor(GetParam()));
  walker.GoOnTo(9);
  EXPECT_GT(walker.Off().norm(), 1.0);
}

// Where no vertex is without force, for that costs the pressure its place (support_area.h).
TEST_P(DcmPlanTest, ForcesAreThePendulumsAndActWhereItsPressureIs) {
  Walker walker(GetParam());
  walker.GoOnTo(4.25);
  walker.Kick({0.1, 0.1, 0.0});
  const double omega2 = kGravity_mps2 / kComHeight_m;
  int compared = 0;
  for (int tick = 0; tick < Ticks(1.0); ++tick) {
    const Eigen::Vector2d p_m = walker.state().p_WC.head<2>();
    walker.Tick1();
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero(), at = Eigen::Vector3d::Zero();
    bool all_bear = true;
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const Eigen::Matrix3Xd& on_N = walker.plan().ForceOn(foot);
      EXPECT_GE(on_N.row(2).minCoeff(), -1e-9);
      force_N += on_N.rowwise().sum();
      all_bear = all_bear && (on_N.isZero() || on_N.row(2).minCoeff() > 0.0);
      for (Eigen::Index i = 0; i < on_N.cols(); ++i) {
        at += on_N(2, i) * (walker.state().feet[foot].p_WF + Sole().col(i));
      }
    }
    const Eigen::Vector3d wanted_N =
        kMass_kg * (walker.plan().com().a_WC + Eigen::Vector3d(0.0, 0.0, kGravity_mps2));
    EXPECT_LT((force_N - wanted_N).norm(), 1e-9);
    const Eigen::Vector2d pressure_m = p_m - walker.plan().com().a_WC.head<2>() / omega2;
    if (all_bear && ++compared > 0) {
      EXPECT_LT((at.head<2>() / force_N.z() - pressure_m).norm(), 1e-9) << "at tick " << tick;
    }
    EXPECT_EQ(walker.plan().com().angular_momentum.z(), 0.25) << "it is passed on";
  }
  EXPECT_GT(compared, 50);
}

TEST_P(DcmPlanTest, ACopyGoesOnAlikeAndAlone) {
  Walker straight(GetParam());
  straight.GoOnTo(4.1);  // a foot is in the air
  Walker copy(straight);
  copy.Kick({0.2, -0.2, 0.0});
  Walker kicked_later(straight);
  copy.GoOnTo(6);
  straight.GoOnTo(6);
  kicked_later.Kick({0.2, -0.2, 0.0});
  kicked_later.GoOnTo(6);
  EXPECT_TRUE(copy.Bits() == kicked_later.Bits()) << "a copy's run touched what it came from";
  EXPECT_FALSE(copy.Bits() == straight.Bits()) << "the kick did nothing";
}

TEST(DcmPlanTimingTest, ThePushedQpLandsEarlyAndTheCapturePointByTheClock) {
  const auto landing_after = [](Stepping stepping) {
    Walker walker(stepping);
    walker.GoOnTo(4.15);
    const Tick due = StepAheadOf(walker.planner().setup(), walker.planner().support())->landing;
    walker.Kick({0.0, 0.3, 0.0});
    walker.Tick1();
    const auto step = StepAheadOf(walker.planner().setup(), walker.planner().support());
    return step->landing - due;
  };
  EXPECT_LT(landing_after(Stepping::kDcmQp), -4);
  EXPECT_EQ(landing_after(Stepping::kCapturePoint), 0);
}

TEST(DcmPlanContractTest, ItHasTwoFeet) {
  DcmSetup setup = SetupFor(Stepping::kDcmQp);
  setup.vertices_m.resize(1);
  EXPECT_THROW(DcmPlan{setup}, ContractViolation);
}

}  // namespace
}  // namespace sidestep::dcm::dcm_plan_test
