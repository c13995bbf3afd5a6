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

namespace sidestep {

enum class Plant { kMujoco, kCentroidal };

template <>
struct EnumNames<Plant> {
  static constexpr std::array<std::pair<Plant, std::string_view>, 2> kNames{
      {{Plant::kMujoco, "mujoco"}, {Plant::kCentroidal, "centroidal"}}};
};

enum class PushProfile { kConstant, kHalfSine };

template <>
struct EnumNames<PushProfile> {
  static constexpr std::array<std::pair<PushProfile, std::string_view>, 2> kNames{
      {{PushProfile::kConstant, "constant"}, {PushProfile::kHalfSine, "half_sine"}}};
};

enum class PushFrame {
  kWorld,    ///< Axes of W.
  kHeading,  ///< W turned about z by the base's yaw when the push starts.
  kBody      ///< Axes of the pushed body or frame, turning with it.
};

template <>
struct EnumNames<PushFrame> {
  static constexpr std::array<std::pair<PushFrame, std::string_view>, 3> kNames{
      {{PushFrame::kWorld, "world"}, {PushFrame::kHeading, "heading"}, {PushFrame::kBody, "body"}}};
};

/// A scripted force at a point of a body. The file gives `force_N`, or `magnitude_N` with
/// `direction_rad` (about z from x, heading frame); either way it ends up here as force_N.
struct Push {
  std::string body;  ///< A body or a frame (site) of the robot.
  Eigen::Vector3d force_N{Eigen::Vector3d::Zero()};
  double start_s{0.0};
  double duration_s{0.0};
  Eigen::Vector3d point_m{Eigen::Vector3d::Zero()};  ///< In the body's or frame's own axes.
  PushProfile profile{PushProfile::kConstant};       ///< half_sine peaks at force_N.
  PushFrame frame{PushFrame::kWorld};
};

struct WorldParams {
  double friction{0.8};    ///< Sliding coefficient between foot and floor.
  double step_s{0.001};    ///< One physics step, one tick.
  double mass_scale{1.0};  ///< Every mass and inertia of the plant over what the controller takes.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("friction", self.friction, Range{0.0, 10.0});
    visit("step_s", self.step_s, Range{1e-5, 0.02});
    visit("mass_scale", self.mass_scale, Range{0.5, 2.0});
  }
};

/// Errors of the sensors: noise (standard deviations, drawn anew each frame), biases (constant),
/// delay and dropout.
struct SensorParams {
  double gyro_noise_radps{0.0};
  double accelerometer_noise_mps2{0.0};
  double orientation_noise_rad{0.0};
  double encoder_noise_rad{0.0};  ///< Per joint; m for a slide.
  double encoder_velocity_noise_radps{0.0};
  double touch_noise_N{0.0};
  double delay_s{0.0};        ///< Age of a frame when the controller sees it.
  double dropout{0.0};        ///< Probability that a frame repeats the last one.
  double force_noise_N{0.0};  ///< Of the force/torque sensors, per axis.
  double torque_noise_Nm{0.0};
  /// Added to every force/torque sensor, in its own axes (N).
  Eigen::Vector3d force_bias_N{Eigen::Vector3d::Zero()};
  Eigen::Vector3d gyro_bias_radps{Eigen::Vector3d::Zero()};
  Eigen::Vector3d accelerometer_bias_mps2{Eigen::Vector3d::Zero()};
  /// Standard deviation of the encoders' constant errors, one a joint, which the seed decides.
  double encoder_bias_rad{0.0};
  double wrench_delay_s{0.0};  ///< Age of the force/torque readings beyond delay_s.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("gyro_noise_radps", self.gyro_noise_radps, Range{0.0, 10.0});
    visit("accelerometer_noise_mps2", self.accelerometer_noise_mps2, Range{0.0, 100.0});
    visit("orientation_noise_rad", self.orientation_noise_rad, Range{0.0, 1.0});
    visit("encoder_noise_rad", self.encoder_noise_rad, Range{0.0, 1.0});
    visit("encoder_velocity_noise_radps", self.encoder_velocity_noise_radps, Range{0.0, 10.0});
    visit("touch_noise_N", self.touch_noise_N, Range{0.0, 100.0});
    visit("delay_s", self.delay_s, Range{0.0, 0.1});
    visit("dropout", self.dropout, Range{0.0, 0.9});
    visit("force_noise_N", self.force_noise_N, Range{0.0, 100.0});
    visit("torque_noise_Nm", self.torque_noise_Nm, Range{0.0, 100.0});
    visit("force_bias_N", self.force_bias_N, Range{-100.0, 100.0});
    visit("gyro_bias_radps", self.gyro_bias_radps, Range{-1.0, 1.0});
    visit("accelerometer_bias_mps2", self.accelerometer_bias_mps2, Range{-10.0, 10.0});
    visit("encoder_bias_rad", self.encoder_bias_rad, Range{0.0, 0.1});
    visit("wrench_delay_s", self.wrench_delay_s, Range{0.0, 0.1});
  }
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
