// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// scenario: everything that decides a run, as plain data. The file's keys are the fields' names.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/types/control_params.h"
#include "controller/types/field.h"
#include "controller/types/gait_params.h"
#include "models/robot_description/robot_description.h"
#include "sim/scenario/push.h"
#include "sim/scenario/sensor_params.h"
#include "sim/scenario/world_params.h"

namespace sidestep {

/// What is simulated; see sim/world/mujoco_world.h and sim/world/centroidal_world.h.
enum class Plant { kMujoco, kCentroidal };

template <>
struct EnumNames<Plant> {
  static constexpr std::array<std::pair<Plant, std::string_view>, 2> kNames{
      {{Plant::kMujoco, "mujoco"}, {Plant::kCentroidal, "centroidal"}}};
};

/// Bounds that decide FALL and SLIP on the truth; see sim/verdict.
/// A fall or a slip makes the run a FAIL unless the scenario's `expect` says that it is to come.
/// Any contact of another body than a foot with the ground is a fall as well and has no bound. The
/// height is the base's, or the CoM's on the centroidal plant, whose nominal one is the robot's.
struct VerdictParams {
  double min_base_height_ratio{0.5};  ///< 0: no height is too low.
  double max_tilt_rad{1.0};           ///< Pi and more: no tilt is too much.
  double max_slip_m{0.05};            ///< Of any one foot.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("min_base_height_ratio", self.min_base_height_ratio, Range{0.0, 1.0},
          "FALL below this share of the nominal height of the base");
    visit("max_tilt_rad", self.max_tilt_rad, Range{0.05, 3.2},
          "FALL beyond this angle of the base from upright");
    visit("max_slip_m", self.max_slip_m, Range{0.0, 10.0},
          "SLIP if a foot slides farther in one stance");
  }
};

/// An expected value or interval of a metric of summary.json.
/// Bounds are inclusive, in the metric's unit; either may be missing. A plain number in a file is
/// both of them. A metric that is NaN meets no bound.
struct Expectation {
  std::string metric;         ///< A name of KnownMetrics().
  std::optional<double> min;  ///< Empty: no lower bound.
  std::optional<double> max;  ///< Empty: no upper bound.
  std::optional<bool> is;     ///< For metrics that are true or false, such as `fall`.
};

/// How the camera moves; sim/render/camera_path.h has the path.
enum class VideoCamera { kFollow, kFixed };

template <>
struct EnumNames<VideoCamera> {
  static constexpr std::array<std::pair<VideoCamera, std::string_view>, 2> kNames{
      {{VideoCamera::kFollow, "follow"}, {VideoCamera::kFixed, "fixed"}}};
};

/// Both sides are even, as H.264 asks.
struct PixelSize {
  int width_px;
  int height_px;
};

/// The video; in a file `video: false` draws none, and there is no key `enabled`.
/// Only of what is drawn afterwards from the log: nothing of it can change the run.
struct VideoParams {
  bool enabled{true};
  PixelSize size{640, 480};
  int fps{30};
  VideoCamera camera{VideoCamera::kFollow};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("size", self.size, Range{64.0, 4096.0}, "[width, height] in pixels, both even");
    visit("fps", self.fps, Range{1.0, 240.0}, "frames a second of simulated time");
    visit("camera", self.camera, "follow: goes along with the robot; fixed: stands still");
  }
};

/// What a scenario says of itself in single values.
/// Each is one line of a file; the sections of Scenario are the blocks below them.
struct ScenarioBasics {
  int format{1};
  std::string name;
  std::string description;
  std::string robot_name;  ///< As the file names it.
  Plant plant{Plant::kMujoco};
  double duration_s{0.0};  ///< No default: 0 is refused.
  std::uint64_t seed{1};   ///< The only randomness of a run.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("sidestep", self.format, Range{1.0, 1.0}, Required("version of the file format"));
    visit("name", self.name,
          Required("a plain word of letters, digits, '_', '-', '.'; it names the run's folder"));
    visit("description", self.description, "a sentence for the report");
    visit("robot", self.robot_name,
          Required("a robot that ships (see `sidestep robots`), or the path of a robot.yaml"));
    visit("plant", self.plant,
          "mujoco: rigid bodies; centroidal: CoM and momentum alone, for robots without a model");
    visit("duration_s", self.duration_s, Range{0.01, 1e4}, Required("simulated time"));
    visit("seed", self.seed, "of the sensors' noise");
  }
};

/// A whole scenario: its basics, its sections and the robot it names.
/// Two equal ones give the same run, bit for bit, on one machine and build. ReadScenario() makes
/// one and checks that its parts fit each other; code that fills one by hand must see to that
/// itself, for those who take a Scenario rely on it.
struct Scenario : ScenarioBasics {
  std::filesystem::path file;            ///< Where it was read from; not part of the resolved file.
  std::vector<std::string> overrides{};  ///< As ReadScenario() took them; likewise.
  RobotDescription robot;
  ControlParams control;
  std::vector<GaitParams> gait;  ///< In order of start_s; the first starts at 0.
  std::vector<Push> pushes;      ///< In the file's order; they may overlap.
  WorldParams world;
  SensorParams sensors;
  VerdictParams verdict;
  std::vector<Expectation> expect;  ///< In the file's order.
  VideoParams video;

  /// Like VisitFields, for the keys that hold more than one value.
  template <typename Self, typename Visitor>
  static void VisitSections(Self& self, Visitor&& visit) {
    visit("control", self.control,
          "the controller; a robot's own `control:` in its robot.yaml stands before this one");
    visit("gait", self.gait, "one gait, or a list of them ordered by start_s");
    visit("pushes", self.pushes, "scripted forces on the robot");
    visit("world", self.world, "the simulated world");
    visit("sensors", self.sensors, "errors of the sensors");
    visit("verdict", self.verdict, "bounds of a fall and of a slip");
    visit("expect", self.expect,
          "metrics (see `sidestep metrics`), each with a number, true or false, or {min, max}");
    visit("video", self.video, "what the video looks like; false: none, true: the defaults");
  }
};

}  // namespace sidestep
