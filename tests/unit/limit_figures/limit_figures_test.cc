// SPDX-License-Identifier: BSD-3-Clause
// Whole tables of limits against those of an independent program, which had been checked against
// closed forms and a random search for survivals. 16 directions, 8 moments; where both have the
// same grid of footholds and times they agree to what was printed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "sim/limit/push_limit.h"

namespace sidestep::limit::limit_figures_test {
namespace {

constexpr double kPrinted_mps = 0.0001;

struct Figures {
  double least;
  double mean;
};

using Table = std::vector<std::vector<double>>;

Table TableOf(const LimitParams& params, StepFreedom freedom, bool is_planar = false) {
  LimitTask task{params, GaitType::kWalk, is_planar, freedom, {}, EvenDirections(16, is_planar)};
  task.moments = EvenMoments(params, GaitType::kWalk, 8);
  return LargestVelocitySteps(task);
}

Figures Of(const Table& table) {
  Figures figures{1e9, 0.0};
  for (const auto& row : table) {
    for (const double limit : row) {
      figures.least = std::min(figures.least, limit);
      figures.mean += limit / static_cast<double>(table.size() * row.size());
    }
  }
  return figures;
}

// The iCub in place: h = 0.543 m, steps of 0.4 s and 0.1 s on two feet, 0.16 m apart.
LimitParams ICub() {
  LimitParams params;
  params.omega_per_s = 4.25;
  params.sole_half_length_m = 0.105;
  params.sole_half_width_m = 0.045;
  params.reach_m = 0.4;
  params.nearest_m = 0.11;
  params.farthest_m = 0.45;
  params.swing_speed_mps = 2.5;
  params.grid_m = 0.02;
  return params;
}

// Times that give way, 2 m/s.
LimitParams QuickICub() {
  LimitParams params = ICub();
  params.reach_m = 0.5;
  params.farthest_m = 0.49;
  params.swing_speed_mps = 2.0;
  return params;
}

// Wide, quick, with the centre of pressure inside.
LimitParams WideICub() {
  LimitParams params = QuickICub();
  params.step_width_m = 0.24;
  params.swing_s = 0.3;
  params.double_support_s = 0.05;
  params.cop_inset_m = 0.03;
  return params;
}

TEST(LimitFiguresTest, ICubOnFixedFootholds) {
  const Table table = TableOf(ICub(), StepFreedom::kNone);
  EXPECT_NEAR(Of(table).least, 0.2251, kPrinted_mps);
  EXPECT_NEAR(Of(table).mean, 0.4423, kPrinted_mps);
  constexpr std::array<double, 16> kMidStep{0.4462, 0.4830, 0.4089, 0.3129, 0.2891, 0.3129,
                                            0.4089, 0.4830, 0.4462, 0.4830, 0.6311, 0.4902,
                                            0.4528, 0.4902, 0.6311, 0.4830};
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(table[4][i], kMidStep[i], kPrinted_mps) << i;
}

TEST(LimitFiguresTest, ICubWithFixedTimes) {
  const Table table = TableOf(ICub(), StepFreedom::kPlaces);
  EXPECT_NEAR(Of(table).least, 0.2817, kPrinted_mps);
  EXPECT_NEAR(Of(table).mean, 0.7776, kPrinted_mps);
  constexpr std::array<double, 16> kInDoubleSupport{0.7167, 0.7430, 0.4417, 0.3381, 0.3123, 0.3381,
                                                    0.4417, 0.7430, 0.7167, 0.7757, 0.7024, 0.8120,
                                                    0.7502, 0.8120, 0.7024, 0.7757};
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_NEAR(table[7][i], kInDoubleSupport[i], kPrinted_mps) << i;
  }
}

TEST(LimitFiguresTest, SlowGaitsGainLittleFromPlacesAlone) {
  LimitParams params = ICub();
  params.swing_s = 0.5;
  params.double_support_s = 0.2;
  EXPECT_NEAR(Of(TableOf(params, StepFreedom::kPlaces)).least, 0.2433, kPrinted_mps);
  EXPECT_NEAR(Of(TableOf(params, StepFreedom::kPlaces)).mean, 0.6793, kPrinted_mps);
  params.swing_s = params.double_support_s = 1.0;
  EXPECT_NEAR(Of(TableOf(params, StepFreedom::kPlaces)).least, 0.1935, kPrinted_mps);
  // Ours also knows the gait's own foothold, which lies between those of the grid.
  EXPECT_NEAR(Of(TableOf(params, StepFreedom::kPlaces)).mean, 0.5017, 0.0025);
}

// The other program leaves out that a step may still be the gait's own, which is worth up to 0.005
// of the means and nothing at the worst; crossings lie elsewhere on its grid, worth 0.005.
TEST(LimitFiguresTest, ICubWithTimesThatGiveWay) {
  EXPECT_NEAR(Of(TableOf(QuickICub(), StepFreedom::kFree)).least, 0.3848, kPrinted_mps);
  EXPECT_NEAR(Of(TableOf(QuickICub(), StepFreedom::kFree)).mean, 1.0526, 0.005);
  EXPECT_NEAR(Of(TableOf(WideICub(), StepFreedom::kFree)).least, 0.5712, kPrinted_mps);
  EXPECT_NEAR(Of(TableOf(WideICub(), StepFreedom::kFree)).mean, 1.1404, 0.005);
  LimitParams crossing = WideICub();
  crossing.crossing_m = 0.22;
  EXPECT_NEAR(Of(TableOf(crossing, StepFreedom::kFree)).least, 0.7710, 0.005);
  EXPECT_NEAR(Of(TableOf(crossing, StepFreedom::kFree)).mean, 1.2270, 0.005);
}

// As N s/kg of a push of 0.1 s, which are the figures that tables of this robot quote.
TEST(LimitFiguresTest, APushOfATenthOfASecond) {
  const double factor = HeldPushFactor(4.25, 0.1);
  const auto expect = [&](const LimitParams& params, StepFreedom freedom, Figures quoted) {
    const Figures figures = Of(TableOf(params, freedom));
    EXPECT_NEAR(factor * figures.least, quoted.least, 0.005);  // two digits
    EXPECT_NEAR(factor * figures.mean, quoted.mean, 0.011);    // and the difference above
  };
  expect(ICub(), StepFreedom::kNone, {0.28, 0.54});
  expect(ICub(), StepFreedom::kPlaces, {0.35, 0.95});
  expect(QuickICub(), StepFreedom::kFree, {0.47, 1.29});
  expect(WideICub(), StepFreedom::kFree, {0.70, 1.40});
}

TEST(LimitFiguresTest, AStandOnBothFeet) {
  LimitParams params = QuickICub();
  params.farthest_m = 0.45;
  LimitTask task{params, GaitType::kStand,         false, StepFreedom::kFree,
                 {},     EvenDirections(16, false)};
  task.moments = EvenMoments(params, GaitType::kStand, 1);
  const Figures figures = Of(LargestVelocitySteps(task));
  EXPECT_NEAR(figures.least, 0.5899, kPrinted_mps);
  EXPECT_NEAR(figures.mean, 0.9304, kPrinted_mps);
}

TEST(LimitFiguresTest, AFinerGridGainsLittle) {
  LimitParams params = QuickICub();
  const Figures coarse = Of(TableOf(params, StepFreedom::kFree));
  params.grid_m = 0.01;
  const Figures fine = Of(TableOf(params, StepFreedom::kFree));
  EXPECT_GE(fine.mean, coarse.mean);
  EXPECT_LT(fine.mean, 1.02 * coarse.mean);
}

// Planar robots of which only the plane counts; the other program's feet, on its grid, are 1 cm out
// of it, which costs them 0.1 mm of a step, and 0.0001 m/s.
TEST(LimitFiguresTest, PlanarRobots) {
  LimitParams biped = ICub();
  biped.omega_per_s = std::sqrt(9.81 / 0.55);
  biped.sole_half_length_m = 0.1;
  biped.reach_m = 0.3;
  EXPECT_NEAR(Of(TableOf(biped, StepFreedom::kNone, true)).least, 0.4223, kPrinted_mps);
  const Figures free = Of(TableOf(biped, StepFreedom::kFree, true));
  EXPECT_NEAR(free.least, 1.0044, 2 * kPrinted_mps);
  EXPECT_NEAR(free.mean, 1.3614, 0.007);  // of which 0.006 are the gait's own step, as above
  LimitParams rabbit = biped;
  rabbit.omega_per_s = std::sqrt(9.81 / 0.7);
  rabbit.sole_half_length_m = 0.0;
  EXPECT_NEAR(Of(TableOf(rabbit, StepFreedom::kFree, true)).least, 0.6230, 2 * kPrinted_mps);
  EXPECT_NEAR(Of(TableOf(rabbit, StepFreedom::kNone, true)).least, 0.0, kPrinted_mps);
}

}  // namespace
}  // namespace sidestep::limit::limit_figures_test
