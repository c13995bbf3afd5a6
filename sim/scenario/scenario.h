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

enum class Plant { kMujoco, kCentroidal };

template <>
struct EnumNames<Plant> {
  static constexpr std::array<std::pair<Plant, std::string_view>, 2> kNames{
      {{Plant::kMujoco, "mujoco"}, {Plant::kCentroidal, "centroidal"}}};
};

/// Bounds that decide FALL and SLIP on the truth; see sim/verdict.
struct VerdictParams {
  double min_base_height_ratio{0.5};  ///< FALL below this share of the nominal height.
  double max_tilt_rad{1.0};           ///< FALL beyond this angle of the base from upright.
  double max_slip_m{0.05};            ///< SLIP if a foot slides farther in one stance.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("min_base_height_ratio", self.min_base_height_ratio, Range{0.0, 1.0});
    visit("max_tilt_rad", self.max_tilt_rad, Range{0.05, 3.2});
    visit("max_slip_m", self.max_slip_m, Range{0.0, 10.0});
  }
};

/// An expected value or interval of a metric of summary.json.
struct Expectation {
  std::string metric;
  std::optional<double> min;
  std::optional<double> max;
  std::optional<bool> is;  ///< For metrics that are true or false, such as `fall`.
};

enum class VideoCamera { kFollow, kFixed };

template <>
struct EnumNames<VideoCamera> {
  static constexpr std::array<std::pair<VideoCamera, std::string_view>, 2> kNames{
      {{VideoCamera::kFollow, "follow"}, {VideoCamera::kFixed, "fixed"}}};
};

struct VideoParams {
  bool enabled{true};
  int width_px{640};  ///< The file's `size: [width, height]`.
  int height_px{480};
  int fps{30};
  VideoCamera camera{VideoCamera::kFollow};
};

struct Scenario {
  std::filesystem::path file;  ///< Where it was read from; not part of the resolved file.
  std::string name;
  std::string description;
  std::string robot;  ///< As the file names it.
  RobotDescription description_of_robot;
  Plant plant{Plant::kMujoco};
  double duration_s{0.0};
  std::uint64_t seed{1};
  ControlParams control;
  std::vector<GaitParams> gait;  ///< In order of start_s; the first starts at 0.
  std::vector<Push> pushes;
  WorldParams world;
  SensorParams sensors;
  VerdictParams verdict;
  std::vector<Expectation> expect;
  VideoParams video;
};

}  // namespace sidestep
