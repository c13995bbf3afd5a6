// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/resolve_pushes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "models/support/gravity.h"
#include "sim/scenario/read_scenario.h"
#include "sim/scenario/write_scenario.h"
#include "tests/support/temp_folder.h"

namespace sidestep::resolve_pushes_test {
namespace {

// The reduced biped: walks, from 1 s on, swings of 0.4 s and 0.1 s on both feet.
constexpr const char* kWalk = R"(sidestep: 1
name: walk
robot: two_legs
plant: centroidal
duration_s: 8
gait:
  - {type: stand}
  - {type: walk, start_s: 1, step_length_m: 0.1, swing_s: 0.4, double_support_s: 0.1}
  - {type: stand, start_s: 6}
pushes:
  - {body: com, magnitude_N: 10, direction_rad: 0, start_s: 2, duration_s: 0.1}
)";

class ResolvePushesTest : public testing::Test {
 protected:
  Push Pushed(const std::vector<std::string>& overrides) const {
    return ReadScenario(file_, overrides).pushes.at(0);
  }
  std::string ErrorOf(const std::vector<std::string>& overrides) const {
    return folder_.ErrorOf([&] { Pushed(overrides); });
  }

  const TempFolder folder_;
  const std::filesystem::path file_ = folder_.Write("walk.yaml", kWalk);
  const double mass_kg_ = ReadScenario(file_).robot.mass_kg;
};

TEST_F(ResolvePushesTest, AWeightIsThePlantsMassTimesGravity) {
  const double weight_N = mass_kg_ * kGravity_mps2;
  EXPECT_NEAR(Pushed({"pushes.0.magnitude_mg=0.5"}).force_N.x(), 0.5 * weight_N, 1e-9);
  EXPECT_NEAR(Pushed({"pushes.0.magnitude_mg=0.5", "world.mass_scale=1.2"}).force_N.x(),
              0.6 * weight_N, 1e-9);
}

TEST_F(ResolvePushesTest, AnImpulseIsTheForceTimesItsDuration) {
  const double force_N = Pushed({"pushes.0.impulse_Nspkg=0.3"}).force_N.x();
  EXPECT_NEAR(force_N * 0.1, 0.3 * mass_kg_, 1e-9);
  const double peak_N =
      Pushed({"pushes.0.impulse_Nspkg=0.3", "pushes.0.profile=half_sine"}).force_N.x();
  EXPECT_NEAR(peak_N * 0.1 * 2.0 / std::numbers::pi, 0.3 * mass_kg_, 1e-9);
}

TEST_F(ResolvePushesTest, TheGaitIsLaidOutOnceForAllPushes) {
  std::string pushes = "pushes=[";
  for (int i = 0; i < 500; ++i) {
    pushes +=
        "{body: com, magnitude_mg: 0.1, direction_rad: 0, at_phase: mid_swing, after_s: 2000,"
        " duration_s: 0.1},";
  }
  const std::clock_t start = std::clock();
  EXPECT_GT(Pushed({"duration_s=3000", "gait.2.start_s=2900", pushes + "]"}).start_s, 2000.0);
  const double cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(cpu_s, 5.0);  // 0.3 s with sanitizers; done anew for each, it was 13 s
}

// By hand: the left foot swings first, from 1 s on if the gait begins with a lift-off; what counts
// is the distance between the instants, which the gait's times give.
TEST_F(ResolvePushesTest, NamedPhasesLieWhereTheGaitsTimesPutThem) {
  const auto start_s = [&](const std::string& phase, const std::string& foot) {
    return Pushed({"pushes.0.at_phase=" + phase, "pushes.0.foot=" + foot, "pushes.0.after_s=2.0"})
        .start_s;
  };
  const double lift_off_s = start_s("0", "left");
  EXPECT_GE(lift_off_s, 2.0);
  EXPECT_LT(lift_off_s, 3.0) << "a stride is 1 s";
  EXPECT_NEAR(start_s("mid_swing", "left") - lift_off_s, 0.2, 1e-9);
  EXPECT_NEAR(start_s("swing_to_stance", "left") - lift_off_s, 0.4, 1e-9);
  EXPECT_NEAR(start_s("mid_stance", "left") - lift_off_s, 0.7, 1e-9);
  EXPECT_NEAR(start_s("stance_to_swing", "left") - lift_off_s, 1.0, 1e-9);
  EXPECT_NEAR(start_s("0.25", "left") - lift_off_s, 0.25, 1e-9);
  EXPECT_NEAR(std::abs(start_s("0", "right") - lift_off_s), 0.5, 1e-9) << "they alternate";
}

TEST_F(ResolvePushesTest, AnInstantsPhaseIsThatWhichLeadsToIt) {
  const Scenario scenario = ReadScenario(file_);
  for (const double phase : {0.0, 0.25, 0.5, 0.9}) {
    const std::string at = "pushes.0.at_phase=" + std::to_string(phase);
    const double start_s = Pushed({at, "pushes.0.after_s=3"}).start_s;
    EXPECT_NEAR(PhaseAt(scenario, start_s).value_or(-1.0), phase, 1e-3)
        << start_s;  // a tick of 1 s
  }
  EXPECT_FALSE(PhaseAt(scenario, 0.5).has_value()) << "it stands";
  EXPECT_FALSE(PhaseAt(scenario, 7.9).has_value()) << "it stands again";
}

TEST_F(ResolvePushesTest, WhatIsWrittenReadsBackAsTheSamePush) {
  const Scenario scenario =
      ReadScenario(file_, {"pushes.0.at_phase=mid_swing", "pushes.0.after_s=2",
                           "pushes.0.impulse_Nspkg=0.3", "pushes.0.direction_rad=1"});
  const std::string text = ResolvedYaml(scenario);
  EXPECT_EQ(ResolvedYaml(ReadScenario(folder_.Write("resolved.yaml", text))), text);
  EXPECT_EQ(text.find("at_phase"), std::string::npos);
}

TEST_F(ResolvePushesTest, AnOverrideTakesThePlaceOfTheFilesOwnWay) {
  const std::string by_force =
      Edit(kWalk, "magnitude_N: 10, direction_rad: 0", "force_N: [0, 5, 0]");
  const auto file = folder_.Write("force.yaml", by_force);
  const Scenario scenario =
      ReadScenario(file, {"pushes.0.magnitude_N=20", "pushes.0.direction_rad=0"});
  EXPECT_EQ(scenario.pushes.at(0).force_N, Eigen::Vector3d(20, 0, 0));
  EXPECT_EQ(
      ErrorOf({"pushes.0.magnitude_N=20", "pushes.0.magnitude_mg=1", "pushes.0.impulse_Nspkg=1"}),
      "--set pushes.0.magnitude_mg=1: error: pushes.0.magnitude_mg and magnitude_N exclude "
      "each other");
}

TEST_F(ResolvePushesTest, Errors) {
  EXPECT_EQ(ErrorOf({"pushes.0.at_phase=mid_swing", "pushes.0.after_s=7"}),
            "--set pushes.0.at_phase=mid_swing: error: pushes.0.at_phase has no stride to be in: "
            "the gait has no whole one of the left foot between 7 s and the end at 8 s");
  EXPECT_EQ(ErrorOf({"robot=one_leg", "gait={type: hop, step_width_m: 0}", "pushes.0.at_phase=0",
                     "pushes.0.foot=right"}),
            "--set pushes.0.foot=right: error: pushes.0.foot = right needs a robot of 2 feet; "
            "'one_leg' has 1");
}

}  // namespace
}  // namespace sidestep::resolve_pushes_test
