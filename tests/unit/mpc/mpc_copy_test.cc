// SPDX-License-Identifier: BSD-3-Clause
// A CentroidalMpc copied in mid-run: original and copy go on bit for bit, and neither hears of the
// other.
#include <gtest/gtest.h>

#include <optional>
#include <tuple>
#include <vector>

#include "controller/mpc/centroidal_mpc.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::mpc_copy_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr Tick kSolve = 50;
constexpr Tick kEnd = 520;

MpcParams Params(MpcBackend backend, Tick latency) {
  MpcParams params;
  params.backend = backend;
  params.rate_hz = 20.0;
  params.knots = 12;
  params.step_s = 0.05;
  params.friction = 0.6;
  params.latency_s = SecondsAt(latency, kTick_s);
  return params;
}

RobotModel Robot() {
  RobotModel robot;
  robot.mass_kg = 20.0;
  robot.foot_names = {"sole", "point"};
  robot.vertices_m = {Foot("", 4).vertices_m, Foot("", 1).vertices_m};
  return robot;
}

PlannedContact Stay(int index, Tick start, Tick end, double y_m) {
  PlannedContact contact;
  contact.index = index;
  contact.start_tick = start;
  contact.end_tick = end;
  contact.nominal_p_WF.y() = contact.adjusted_p_WF.y() = y_m;
  contact.box_lower_m = {-0.1, -0.05, 0.0};
  contact.box_upper_m = {0.1, 0.05, 0.0};
  return contact;
}

/// Two feet in turn; each lands within the run.
ContactPlan Walk() {
  return {{{Stay(0, 0, 200, 0.1), Stay(1, 350, 100000, 0.1)},
           {Stay(0, 0, 400, -0.1), Stay(1, 500, 100000, -0.1)}}};
}

/// What the rest of the control chain reads after a tick.
struct Reading {
  bool has_changed{false};
  ComTarget com;
  std::vector<Eigen::Matrix3Xd> force_N;
  std::vector<Eigen::Vector3d> footholds;
  double age_s{0.0};
  MpcReport report;
};

bool operator==(const Reading& a, const Reading& b) {
  const auto report = [](const MpcReport& r) {
    return std::tuple(r.ran, r.status, r.iterations, r.cost, r.constraint_violation, r.kkt_error);
  };
  return a.has_changed == b.has_changed && a.com.p_WC == b.com.p_WC && a.com.v_WC == b.com.v_WC &&
         a.com.a_WC == b.com.a_WC && a.force_N == b.force_N && a.footholds == b.footholds &&
         a.age_s == b.age_s && report(a.report) == report(b.report);
}

/// Ticks `begin` to `end` of a run whose belief is drawn anew for each solve, from `seed`.
std::vector<Reading> Drive(CentroidalMpc* mpc, Tick begin, Tick end, unsigned seed) {
  const int knots = 12;
  GridReferences references;
  references.p_WC.setZero(3, knots + 1);
  references.p_WC.row(2).setConstant(0.5);
  references.angular_momentum.setZero(3, knots + 1);
  std::vector<Reading> readings;
  for (Tick tick = begin; tick < end; ++tick) {
    if (tick % kSolve == 0) {
      Numbers numbers(seed + static_cast<unsigned>(tick));
      RobotState state;
      state.p_WC = Eigen::Vector3d(0.0, 0.0, 0.5) + 0.01 * numbers.Vector3();
      state.v_WC = 0.1 * numbers.Vector3();
      state.external_wrench.force_N = 10.0 * numbers.Vector3();
      mpc->Solve(state, Walk(), references, tick);
    }
    Reading reading;
    reading.has_changed = mpc->Activate(tick);
    reading.com = mpc->ComAt(tick);
    reading.force_N = {mpc->ForceAt(0, tick), mpc->ForceAt(1, tick)};
    for (const Foothold& foothold : mpc->footholds()) reading.footholds.push_back(foothold.p_WF);
    reading.age_s = mpc->Age_s(tick);
    reading.report = mpc->report();
    readings.push_back(reading);
  }
  return readings;
}

class MpcCopyTest : public testing::TestWithParam<std::tuple<MpcBackend, Tick>> {
 protected:
  CentroidalMpc Make() const {
    const auto [backend, latency] = GetParam();
    return CentroidalMpc(Params(backend, latency), Robot(), kTick_s);
  }

  /// A tick that differs from case to case; with a latency of 120, two or three plans wait then.
  Tick CopyTick() const {
    Numbers numbers(static_cast<unsigned>(std::get<1>(GetParam())) + 3);
    return 200 + static_cast<Tick>(150.0 * (numbers.Next() + 1.0));
  }
};

TEST_P(MpcCopyTest, OriginalAndCopyGoOnBitForBitWhicheverRunsFirst) {
  CentroidalMpc uncopied = Make();
  Drive(&uncopied, 0, CopyTick(), 1);
  const std::vector<Reading> expected = Drive(&uncopied, CopyTick(), kEnd, 1);

  CentroidalMpc original = Make();
  Drive(&original, 0, CopyTick(), 1);
  CentroidalMpc constructed = original;
  CentroidalMpc assigned = Make();
  assigned = original;
  EXPECT_EQ(Drive(&constructed, CopyTick(), kEnd, 1), expected);
  EXPECT_EQ(Drive(&original, CopyTick(), kEnd, 1), expected);
  EXPECT_EQ(Drive(&assigned, CopyTick(), kEnd, 1), expected);
}

TEST_P(MpcCopyTest, ACopyThatIsPushedElsewhereLeavesTheOriginalAlone) {
  CentroidalMpc uncopied = Make();
  Drive(&uncopied, 0, CopyTick(), 1);
  const std::vector<Reading> expected = Drive(&uncopied, CopyTick(), kEnd, 1);

  CentroidalMpc original = Make();
  Drive(&original, 0, CopyTick(), 1);
  CentroidalMpc copy = original;
  std::vector<Reading> of_original;
  bool is_other = false;
  for (Tick tick = CopyTick(); tick < kEnd; ++tick) {
    const Reading astray = Drive(&copy, tick, tick + 1, 1000)[0];
    of_original.push_back(Drive(&original, tick, tick + 1, 1)[0]);
    is_other |= !(astray == of_original.back());
  }
  EXPECT_EQ(of_original, expected);
  EXPECT_TRUE(is_other) << "the copy was to go another way";
}

TEST_P(MpcCopyTest, ACopyOutlivesItsOriginal) {
  std::optional<CentroidalMpc> original(Make());
  Drive(&*original, 0, CopyTick(), 1);
  CentroidalMpc copy = *original;
  const std::vector<Reading> expected = Drive(&*original, CopyTick(), kEnd, 1);
  original.reset();
  EXPECT_EQ(Drive(&copy, CopyTick(), kEnd, 1), expected);
}

using Case = std::tuple<MpcBackend, Tick>;
INSTANTIATE_TEST_SUITE_P(BackEnds, MpcCopyTest,
                         testing::Values(Case(MpcBackend::kStructured, 0),
                                         Case(MpcBackend::kStructured, 30),
                                         Case(MpcBackend::kStructured, 120),
                                         Case(MpcBackend::kIpopt, 120)),
                         [](const auto& at) {
                           return std::string(EnumName(std::get<0>(at.param))) + "_latency_" +
                                  std::to_string(std::get<1>(at.param));
                         });

}  // namespace
}  // namespace sidestep::mpc::mpc_copy_test
