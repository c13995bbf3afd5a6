// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/write_scenario.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::write_scenario_test {
namespace {

/// Visitor: gives every field a value within its range, seldom its default.
class Randomize {
 public:
  explicit Randomize(unsigned seed) : random_(seed) {}

  void operator()(const char* /*key*/, double& field, Range range, Meaning /*meaning*/) {
    field = Draw(range);
  }
  void operator()(const char* /*key*/, int& field, Range range, Meaning /*meaning*/) {
    field = static_cast<int>(Draw(range));
  }
  void operator()(const char* /*key*/, Eigen::Vector3d& field, Range range, Meaning /*meaning*/) {
    for (double& entry : field) entry = Draw(range);
  }
  // Two that are clear of each other and of the robot's start.
  void operator()(const char* /*key*/, std::vector<GroundPatch>& field, Meaning /*meaning*/) {
    field = {{-2.0, Draw({-1.9, -1.0}), Draw({-9.0, 0.0}), Draw({0.1, 9.0}), Draw({-0.5, 0.5})},
             {Draw({1.0, 2.0}), 2.1, -kGroundReach_m, 0.0, Draw({-0.5, 0.5})}};
  }
  template <typename T>
  void operator()(const char* /*key*/, T& field, Meaning /*meaning*/) {
    if constexpr (std::is_same_v<T, bool>) {
      field = !field;
    } else if constexpr (std::is_enum_v<T>) {
      field = EnumNames<T>::kNames.back().first;
    } else {
      T::VisitFields(field, *this);
    }
  }

 private:
  double Draw(Range range) {
    return std::uniform_real_distribution<double>(range.min, range.max)(random_);
  }
  std::mt19937_64 random_;
};

/// Visitor: appends every field's bits to a list, so that two structs can be compared.
struct Collect {
  void operator()(const char* key, double field, Range /*range*/, Meaning /*meaning*/) {
    Add(key, field);
  }
  void operator()(const char* key, int field, Range /*range*/, Meaning /*meaning*/) {
    Add(key, field);
  }
  void operator()(const char* key, const Eigen::Vector3d& field, Range /*range*/,
                  Meaning /*meaning*/) {
    for (const double entry : field) Add(key, entry);
  }
  void operator()(const char* key, const std::vector<GroundPatch>& field, Meaning /*meaning*/) {
    Add(key, static_cast<double>(field.size()));
    for (const GroundPatch& patch : field) GroundPatch::VisitFields(patch, *this);
  }
  template <typename T>
  void operator()(const char* key, const T& field, Meaning /*meaning*/) {
    if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
      Add(key, static_cast<int>(field));
    } else {
      T::VisitFields(field, *this);
    }
  }
  void Add(const char* key, double value) { numbers.emplace_back(key, value); }

  std::vector<std::pair<std::string, double>> numbers;
};

template <typename T>
void ExpectSameFields(const T& left, const T& right) {
  Collect of_left, of_right;
  T::VisitFields(left, of_left);
  T::VisitFields(right, of_right);
  EXPECT_FALSE(of_left.numbers.empty());
  EXPECT_EQ(of_left.numbers, of_right.numbers);
}

void ExpectSame(const Scenario& left, const Scenario& right) {
  EXPECT_EQ(left.name, right.name);
  EXPECT_EQ(left.description, right.description);
  EXPECT_EQ(left.robot_name, right.robot_name);
  EXPECT_EQ(left.robot.file, right.robot.file);
  EXPECT_EQ(left.plant, right.plant);
  EXPECT_EQ(left.duration_s, right.duration_s);
  EXPECT_EQ(left.seed, right.seed);
  ExpectSameFields(left.control, right.control);
  ExpectSameFields(left.world, right.world);
  ExpectSameFields(left.sensors, right.sensors);
  ExpectSameFields(left.verdict, right.verdict);
  ASSERT_EQ(left.gait.size(), right.gait.size());
  for (std::size_t i = 0; i < left.gait.size(); ++i) ExpectSameFields(left.gait[i], right.gait[i]);
  ASSERT_EQ(left.pushes.size(), right.pushes.size());
  for (std::size_t i = 0; i < left.pushes.size(); ++i) {
    const Push &a = left.pushes[i], &b = right.pushes[i];
    EXPECT_TRUE(a.body == b.body && a.force_N == b.force_N && a.point_m == b.point_m);
    EXPECT_TRUE(a.start_s == b.start_s && a.duration_s == b.duration_s);
    EXPECT_TRUE(a.profile == b.profile && a.frame == b.frame);
  }
  ASSERT_EQ(left.expect.size(), right.expect.size());
  for (std::size_t i = 0; i < left.expect.size(); ++i) {
    const Expectation &a = left.expect[i], &b = right.expect[i];
    EXPECT_TRUE(a.metric == b.metric && a.min == b.min && a.max == b.max && a.is == b.is);
  }
  const VideoParams &a = left.video, &b = right.video;
  EXPECT_TRUE(a.enabled == b.enabled && a.camera == b.camera);
  EXPECT_TRUE(a.size.width_px == b.size.width_px && a.size.height_px == b.size.height_px &&
              a.fps == b.fps);
}

using WriteScenarioTest = ScenarioFixture;

TEST_F(WriteScenarioTest, ReadingItBackGivesTheSameScenario) {
  const Scenario scenario = Read(
      valid_, {"description=\"a: 'b' # c\"", "expect.energy_J=3",
               "gait=[{type: stand}, {type: hop, start_s: 0.3}]", "pushes.1.direction_rad=0.7"});
  ExpectSame(scenario, Read(ResolvedYaml(scenario)));
}

TEST_F(WriteScenarioTest, ReadingItBackGivesTheSameDefaults) {
  const Scenario scenario =
      Read("sidestep: 1\nname: a\nrobot: mini\nduration_s: 0.1\nvideo: false\n");
  EXPECT_EQ(ResolvedYaml(scenario), ResolvedYaml(Read(ResolvedYaml(scenario))));
  ExpectSame(scenario, Read(ResolvedYaml(scenario)));
}

TEST_F(WriteScenarioTest, EveryFieldKeepsEveryBit) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Scenario scenario = Read(valid_);
    Randomize randomize(seed);
    randomize("world", scenario.world, "");
    randomize("sensors", scenario.sensors, "");
    randomize("verdict", scenario.verdict, "");
    randomize("control", scenario.control, "");
    // What has to fit together is put back.
    scenario.world.step_s = 0.001;
    scenario.control.rate_hz = 250.0;
    scenario.control.mpc.rate_hz = 12.5;
    scenario.control.mpc.step_s = 0.033;
    scenario.control.mpc.box_lower_m = -scenario.control.mpc.box_upper_m.cwiseAbs();
    scenario.control.mpc.box_upper_m = scenario.control.mpc.box_upper_m.cwiseAbs();
    scenario.control.estimation.push_cutoff_hz = 0.0;
    ExpectSame(scenario, Read(ResolvedYaml(scenario)));
  }
}

TEST_F(WriteScenarioTest, EveryDefaultIsWrittenOut) {
  const Scenario scenario = Read("sidestep: 1\nname: a\nrobot: mini\nduration_s: 1\n");
  const std::string text = ResolvedYaml(scenario);
  Collect fields;
  ControlParams::VisitFields(scenario.control, fields);
  WorldParams::VisitFields(scenario.world, fields);
  SensorParams::VisitFields(scenario.sensors, fields);
  VerdictParams::VisitFields(scenario.verdict, fields);
  GaitParams::VisitFields(scenario.gait[0], fields);
  for (const auto& [key, value] : fields.numbers) {
    EXPECT_NE(text.find(" " + key + ": "), std::string::npos) << key;
  }
  EXPECT_NE(text.find("\npushes: []\n"), std::string::npos);
  EXPECT_NE(text.find("\nexpect: {}\n"), std::string::npos);
  EXPECT_NE(text.find("\nvideo:\n  size: [640, 480]\n  fps: 30\n"), std::string::npos);
  EXPECT_NE(text.find("\nseed: 1\n"), std::string::npos);
}

TEST_F(WriteScenarioTest, ADirectionIsWrittenAsItsForce) {
  const std::string text = ResolvedYaml(Read(valid_));
  EXPECT_NE(text.find("force_N: [2, 0, 0]\n"), std::string::npos);
  EXPECT_NE(text.find("frame: heading\n"), std::string::npos);
  EXPECT_EQ(text.find("magnitude_N"), std::string::npos);
}

TEST_F(WriteScenarioTest, ARobotThatShipsKeepsItsName) {
  EXPECT_NE(ResolvedYaml(Read(valid_)).find("\nrobot: mini\n"), std::string::npos);
}

TEST_F(WriteScenarioTest, ARobotGivenByItsPathIsWrittenAbsolute) {
  const auto robot = std::filesystem::relative(FixtureRobots() / "mini/robot.yaml", folder_.path());
  const Scenario scenario = Read(Edit(valid_, "robot: mini", "robot: " + robot.string()));
  const std::string text = ResolvedYaml(scenario);
  EXPECT_NE(text.find((FixtureRobots() / "mini/robot.yaml").string()), std::string::npos);
  const auto elsewhere = folder_.Write("deep/er/b.yaml", text);
  EXPECT_EQ(ReadScenario(elsewhere).robot.file, FixtureRobots() / "mini/robot.yaml");
}

}  // namespace
}  // namespace sidestep::write_scenario_test
