// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/rays.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/unit/sweep/sweep_fixture.h"

namespace sidestep::rays_test {
namespace {

TEST(RaysTest, EveryCombinationIsThereOnce) {
  const SweepSpec spec = SmallSweep();
  const std::vector<Ray> rays = RaysOf(spec);
  ASSERT_EQ(rays.size(), 4U);
  EXPECT_EQ(NumRays(spec), 4.0);
  std::set<std::pair<std::size_t, std::string>> seen;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(rays[i].index, i);
    seen.emplace(rays[i].controller, rays[i].values.at(0));
  }
  EXPECT_EQ(seen.size(), 4U);
}

TEST(RaysTest, DrawnAxesGoTogetherAndGridsWithAll) {
  SweepOptions options;
  options.vary = {"world.friction=0.2:1:latin=5", "pushes.0.magnitude_N=[1, 2, 3]",
                  "world.mass_scale=0.9:1.1:latin=5"};
  const SweepSpec spec = ReadSweep("hopper_push", options);
  const std::vector<Ray> rays = RaysOf(spec);
  EXPECT_EQ(rays.size(), 15U);
  EXPECT_EQ(NumRays(spec), 15.0);
  std::set<std::pair<std::string, std::string>> draws;
  for (const Ray& ray : rays) draws.emplace(ray.values[0], ray.values[2]);
  EXPECT_EQ(draws.size(), 5U);
}

TEST(RaysTest, ACellIsTheSweepThenItsControllerThenItsAxes) {
  SweepSpec spec = SmallSweep();
  spec.set = {"duration_s=6"};
  const Ray ray = RaysOf(spec).back();
  const CellKey cell = FirstCell(spec, ray);
  EXPECT_EQ(OverridesOf(spec, ray, cell),
            (std::vector<std::string>{"duration_s=6", "control.mode=passive",
                                      "pushes.0.direction_rad=1.5", "pushes.0.magnitude_N=10",
                                      "seed=1"}));
}

TEST(RaysTest, AStrengthSurvivesOnlyUnderEverySeed) {
  const SweepSpec spec = SmallSweep();
  const Ray ray = RaysOf(spec).front();
  const LimitResult result = WalkRay(spec, ray, [](const CellKey& cell) {
    const bool is_lost = cell.strength == "40" && cell.seed == "2";
    return std::optional(is_lost ? CellOutcome::kLost : CellOutcome::kRecovered);
  });
  EXPECT_TRUE(result.is_complete);
  EXPECT_EQ(BracketOf(result.tested).lost, 40.0);
}

TEST(RaysTest, CellsAreCountedBeforeTheyAreListed) {
  SweepOptions options;
  options.vary = {"world.friction=0.2:1:1000", "pushes.0.magnitude_N=1:9:1000"};
  options.seeds = "1000";
  EXPECT_EQ(NumCells(ReadSweep("hopper_push", options)), 1e9);
}

}  // namespace
}  // namespace sidestep::rays_test
