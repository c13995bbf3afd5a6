// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/based_on.h"

#include <nlohmann/json.hpp>

#include "sim/scenario/scenario_schema.h"
#include "sim/scenario/write_scenario.h"
#include "tests/unit/scenario/json_schema.h"
#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::based_on_test {
namespace {

/// base.yaml is the valid scenario; a.yaml is based on it.
class BasedOnTest : public ScenarioFixture {
 protected:
  BasedOnTest() { folder_.Write("base.yaml", valid_); }

  const std::string head_ = "sidestep: 1\nname: child\nbased_on: base.yaml\n";
};

TEST_F(BasedOnTest, NothingElseSaidItIsTheBaseUnderAnotherName) {
  Scenario child = Read(head_);
  EXPECT_EQ(child.name, "child");
  child.name = "hop";
  EXPECT_EQ(ResolvedYaml(child), ResolvedYaml(Read(valid_)));
  EXPECT_EQ(ResolvedYaml(child).find("based_on"), std::string::npos);
}

TEST_F(BasedOnTest, MapsAreMergedKeyByKeyAtAnyDepth) {
  const Scenario child = Read(head_ + "control: {mpc: {knots: 9}}\n");
  EXPECT_EQ(child.control.mpc.knots, 9);
  EXPECT_EQ(child.control.mpc.rate_hz, 20.0) << "its neighbour";
  EXPECT_EQ(child.control.rate_hz, 500.0) << "its parent's neighbour";
}

TEST_F(BasedOnTest, ListsReplaceTheBasesWhole) {
  const Scenario child =
      Read(head_ + "pushes:\n  - {body: foot, force_N: [1, 0, 0], start_s: 1, duration_s: 0.1}\n");
  ASSERT_EQ(child.pushes.size(), 1U);
  EXPECT_EQ(child.pushes[0].body, "foot");
  EXPECT_EQ(child.pushes[0].point_m.z(), 0.0) << "the base's first push has 0.1 there";
}

TEST_F(BasedOnTest, ExpectationsReplaceTheBasesWhole) {
  const Scenario child = Read(head_ + "expect: {fall: true}\n");
  ASSERT_EQ(child.expect.size(), 1U) << "no max_tilt_rad";
  EXPECT_EQ(child.expect[0].is, true);
  EXPECT_EQ(Read(head_).expect.size(), 2U);
}

TEST_F(BasedOnTest, AChainOfBasesIsReadToItsEnd) {
  folder_.Write("deep/mid.yaml", "sidestep: 1\nname: mid\nbased_on: ../base.yaml\nseed: 8\n");
  const Scenario child =
      Read("sidestep: 1\nname: c\nbased_on: deep/mid.yaml\nworld: {friction: 1}\n");
  EXPECT_EQ(child.seed, 8U);
  EXPECT_EQ(child.world.friction, 1.0);
  EXPECT_EQ(child.duration_s, 6.0);
}

TEST_F(BasedOnTest, ARobotsPathIsRelativeToTheFileThatSpellsIt) {
  folder_.Write("lib/base.yaml", Edit(valid_, "robot: mini", "robot: mini/robot.yaml"));
  std::filesystem::copy(FixtureRobots() / "mini", folder_.path() / "lib/mini");
  const Scenario child = Read("sidestep: 1\nname: c\nbased_on: lib/base.yaml\n");
  EXPECT_EQ(child.robot.file.lexically_normal(), folder_.path() / "lib/mini/robot.yaml");
}

TEST_F(BasedOnTest, OverridesGoBeforeBoth) {
  EXPECT_EQ(Read(head_ + "seed: 8\n", {"seed=9", "world.friction=0.7"}).seed, 9U);
  EXPECT_EQ(ErrorIn(head_, {"based_on=base.yaml"}),
            "--set based_on=base.yaml: error: based_on can't be overridden; write a file that has "
            "it");
}

TEST_F(BasedOnTest, MistakesAreToldWhereTheyStand) {
  folder_.Write("base.yaml", Edit(valid_, "friction: 0.9", "friction: -1"));
  EXPECT_EQ(ErrorIn(head_),
            "base.yaml:15:19: error: world.friction = -1 violates 0 "
            "<= friction <= 10");
  EXPECT_EQ(ErrorIn(head_ + "world: {friction: 1, step_s: 7}\n"),
            "a.yaml:4:30: error: world.step_s = 7 violates 1e-05 <= step_s <= 0.02");
}

TEST_F(BasedOnTest, EveryFileHasItsOwnNameAndFormat) {
  EXPECT_EQ(ErrorIn("sidestep: 1\nbased_on: base.yaml\n"),
            "a.yaml:1:1: error: name is missing (required)");
  EXPECT_EQ(ErrorIn("name: c\nbased_on: base.yaml\n"),
            "a.yaml:1:1: error: sidestep is missing (required)");
  folder_.Write("base.yaml", Edit(valid_, "sidestep: 1", "sidestep: 2"));
  EXPECT_EQ(ErrorIn(head_),
            "base.yaml:1:11: error: sidestep = 2 is a format that this program "
            "can't read; it reads 1");
}

TEST_F(BasedOnTest, RefusesWhatIsNoBase) {
  EXPECT_EQ(ErrorIn("sidestep: 1\nname: c\nbased_on: none.yaml\n").substr(0, 95),
            "a.yaml:3:11: error: based_on = 'none.yaml' is neither a file beside this one nor a "
            "scenario tha");
  folder_.Write("base.yaml", "sidestep_sweep: 1\n");
  EXPECT_EQ(ErrorIn(head_),
            "base.yaml:1:1: error: is a sweep's file, no scenario's; sidestep sweep runs it");
}

TEST_F(BasedOnTest, RefusesARing) {
  folder_.Write("base.yaml", "sidestep: 1\nname: b\nbased_on: ./a.yaml\n");
  EXPECT_EQ(ErrorIn(head_), "base.yaml:3:11: error: based_on = './a.yaml' leads back to ./a.yaml");
  EXPECT_EQ(ErrorIn("sidestep: 1\nname: c\nbased_on: a.yaml\n"),
            "a.yaml:3:11: error: based_on = 'a.yaml' leads back to a.yaml");
}

TEST_F(BasedOnTest, RefusesALongChain) {
  folder_.Write("1.yaml", valid_);
  for (int i = 2; i <= 9; ++i) {
    folder_.Write(std::to_string(i) + ".yaml",
                  "sidestep: 1\nname: n\nbased_on: " + std::to_string(i - 1) + ".yaml\n");
  }
  EXPECT_EQ(folder_.ErrorOf([&] { ReadScenario(folder_.path() / "8.yaml"); }), "no error");
  EXPECT_EQ(folder_.ErrorOf([&] { ReadScenario(folder_.path() / "9.yaml"); }),
            "2.yaml:3:11: error: based_on makes a chain of more than 8 files");
}

TEST_F(BasedOnTest, TheSchemaAsksLessOfAFileThatHasABase) {
  const JsonSchema schema(ScenarioSchema());
  const auto fault_of = [&](const std::string& text) {
    return schema.Fault(JsonOf(ReadConfigFile(folder_.Write("a.yaml", text))));
  };
  EXPECT_EQ(fault_of(head_), "");
  EXPECT_NE(fault_of("sidestep: 1\nname: child\n"), "") << "no robot, no duration";
  EXPECT_NE(fault_of("sidestep: 1\nbased_on: base.yaml\n"), "") << "no name";
}

}  // namespace
}  // namespace sidestep::based_on_test
