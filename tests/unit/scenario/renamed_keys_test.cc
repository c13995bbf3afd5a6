// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/renamed_keys.h"

#include <gtest/gtest.h>

#include "sim/scenario/write_scenario.h"
#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::renamed_keys_test {
namespace {

class RenamedKeysTest : public ScenarioFixture {
 protected:
  struct Reading {
    Scenario scenario;
    std::vector<std::string> notes;  ///< Without the folder.
  };

  Reading ReadNoting(const std::string& text,
                     const std::vector<std::string>& overrides = {}) const {
    Reading reading;
    reading.scenario = ReadScenario(
        folder_.Write("a.yaml", text), overrides,
        [&](const std::string& note) { reading.notes.push_back(folder_.Shorten(note)); });
    return reading;
  }

  using Notes = std::vector<std::string>;
  const std::string old_ = Edit(valid_, "  mode: torque\n",
                                "  mode: torque\n"
                                "  wbc: {com_weight: 3}\n"
                                "  position: {torso_weight: 4}\n");
};

TEST_F(RenamedKeysTest, AFileWithOldKeysReadsWithANoteEach) {
  const Reading reading = ReadNoting(old_);
  EXPECT_EQ(reading.scenario.control.inverse_dynamics.com_weight, 3.0);
  EXPECT_EQ(reading.scenario.control.inverse_kinematics.torso_weight, 4.0);
  EXPECT_EQ(reading.notes,
            (Notes{"a.yaml:9:3: note: control.wbc is now control.inverse_dynamics",
                   "a.yaml:10:3: note: control.position is now control.inverse_kinematics"}));
}

TEST_F(RenamedKeysTest, PresentNamesGiveNoNote) {
  EXPECT_EQ(ReadNoting(valid_, {"control.inverse_dynamics.com_weight=2"}).notes, Notes{});
  const Reading written = ReadNoting(ResolvedYaml(ReadNoting(old_).scenario));
  EXPECT_EQ(written.notes, Notes{}) << "what a run leaves has the present names";
  EXPECT_EQ(written.scenario.control.inverse_dynamics.com_weight, 3.0);
}

TEST_F(RenamedKeysTest, AnOverrideMayUseTheOldNameInPathAndValue) {
  const Reading by_path = ReadNoting(valid_, {"control.wbc.com_weight=5"});
  EXPECT_EQ(by_path.scenario.control.inverse_dynamics.com_weight, 5.0);
  EXPECT_EQ(by_path.notes, Notes{"--set control.wbc.com_weight=5: note: control.wbc is now "
                                 "control.inverse_dynamics"});
  const Reading by_value = ReadNoting(valid_, {"control={wbc: {com_weight: 6}}"});
  EXPECT_EQ(by_value.scenario.control.inverse_dynamics.com_weight, 6.0);
  EXPECT_EQ(by_value.notes, Notes{"--set control={wbc: {com_weight: 6}}: note: control.wbc is now "
                                  "control.inverse_dynamics (column 2 of the value)"});
}

TEST_F(RenamedKeysTest, AnOverrideEditsWhatTheFileGaveUnderTheOtherName) {
  const Reading newer = ReadNoting(old_, {"control.inverse_dynamics.swing_weight=7"});
  EXPECT_EQ(newer.scenario.control.inverse_dynamics.com_weight, 3.0);
  EXPECT_EQ(newer.scenario.control.inverse_dynamics.swing_weight, 7.0);
  const std::string present = Edit(old_, "  wbc:", "  inverse_dynamics:");
  const Reading older = ReadNoting(present, {"control.wbc.swing_weight=8"});
  EXPECT_EQ(older.scenario.control.inverse_dynamics.com_weight, 3.0);
  EXPECT_EQ(older.scenario.control.inverse_dynamics.swing_weight, 8.0);
}

TEST_F(RenamedKeysTest, BothNamesAreAMistake) {
  EXPECT_EQ(ErrorIn(Edit(old_, "  wbc:", "  inverse_dynamics: {com_weight: 1}\n  wbc:")),
            "a.yaml:10:3: error: control.wbc is the old name of control.inverse_dynamics, which is "
            "given too");
  EXPECT_EQ(ErrorOfSet("control={wbc: {}, inverse_dynamics: {}}"),
            "--set control={wbc: {}, inverse_dynamics: {}}: error: control.wbc is the old name of "
            "control.inverse_dynamics, which is given too (column 2 of the value)");
}

// Its value meant something else: taken over as it is it would weigh nothing any more.
TEST_F(RenamedKeysTest, AKeyOfAnotherMeaningTellsWhatIsInItsPlace) {
  const std::string what =
      "control.inverse_dynamics.force_weight is now planned_force_weight, of shares of the robot's "
      "weight: the old value, which was per N^2, times (mass * 9.81)^2";
  EXPECT_EQ(ErrorIn(Edit(old_, "com_weight: 3", "force_weight: 3")), "a.yaml:9:9: error: " + what);
  EXPECT_EQ(ErrorOfSet("control.wbc.force_weight=3"),
            "--set control.wbc.force_weight=3: error: " + what);
  EXPECT_EQ(ErrorOfSet("control.inverse_dynamics={force_weight: 3}"),
            "--set control.inverse_dynamics={force_weight: 3}: error: " + what +
                " (column 2 of the value)");
}

TEST_F(RenamedKeysTest, ErrorsInsideNameThePresentKey) {
  EXPECT_EQ(ErrorIn(Edit(old_, "com_weight: 3", "com_weigth: 3")),
            "a.yaml:9:9: error: control.inverse_dynamics.com_weigth is not a known key; did you "
            "mean 'com_weight'?");
}

TEST_F(RenamedKeysTest, OnlyTheControlBlockHasRenamedKeys) {
  EXPECT_EQ(ErrorOfSet("world.wbc=1"),
            "--set world.wbc=1: error: world.wbc is not a known key; known keys: friction, step_s, "
            "mass_scale, ground");
  EXPECT_EQ(ErrorOfSet("control.wbcs=1").find("note"), std::string::npos);
  EXPECT_NE(ErrorOfSet("control.wbcs=1"), "no error");
}

TEST_F(RenamedKeysTest, ARobotsControlBlockMayUseOldNames) {
  folder_.Write("robot.yaml",
                "sidestep_robot: 1\nname: point\nmass_kg: 2.0\ncom_height_m: 0.5\n"
                "feet:\n  - {name: foot, vertices_m: [[0, 0, 0]]}\n"
                "control:\n  wbc: {com_weight: 9}\n");
  const Reading reading =
      ReadNoting("sidestep: 1\nname: a\nrobot: robot.yaml\nplant: centroidal\nduration_s: 1\n");
  EXPECT_EQ(reading.scenario.control.inverse_dynamics.com_weight, 9.0);
  EXPECT_EQ(reading.notes,
            Notes{"robot.yaml:8:3: note: control.wbc is now control.inverse_dynamics"});
}

}  // namespace
}  // namespace sidestep::renamed_keys_test
