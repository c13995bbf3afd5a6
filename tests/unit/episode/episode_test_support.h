// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// episode_test_support: controllers that solve nothing, and the bits of a world's state.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "controller/controller.h"
#include "sim/episode/run_episode.h"
#include "tests/support/hopper_scenario.h"

namespace sidestep {

/// All that decides how a world of rigid bodies goes on, and what of its contacts shows, as bits.
inline std::string BitsOf(const WorldTruth& truth) {
  std::string bits;
  const auto append = [&bits](const auto& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const double number = values[i];
      bits.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
  };
  append(truth.qpos);
  append(truth.v_WB);
  append(truth.w_WB_B);
  append(truth.joint_velocity);
  append(truth.p_WC);
  append(truth.angular_momentum);
  for (const FootTruth& foot : truth.feet) append(foot.f_F_W);
  return bits;
}

/// What a controller was given, in the order that it came.
using Frames = std::vector<SensorFrame>;

/// Answers each frame with torques alone and keeps the frames where the test can see them.
class TorqueController final : public Controller {
 public:
  /// Torques (Nm; N for a slide) for a frame, given how many were asked for before it.
  using Law = std::function<Eigen::VectorXd(const SensorFrame& frame, int num_before)>;

  TorqueController(Law law, std::shared_ptr<Frames> seen)
      : law_(std::move(law)), seen_(std::move(seen)) {}

  const ControlTick& Update(const SensorFrame& frame) override {
    if (seen_) seen_->push_back(frame);
    tick_.tick = frame.tick;
    tick_.command.torque_Nm = law_(frame, num_asked_++);
    return tick_;
  }

  /// The copy goes on counting by itself; what it sees is its own affair.
  std::unique_ptr<Controller> Clone(StageTimer* /*timer*/) const override {
    auto copy = std::make_unique<TorqueController>(*this);
    copy->seen_ = nullptr;
    return copy;
  }

 private:
  Law law_;
  std::shared_ptr<Frames> seen_;
  int num_asked_{0};
  ControlTick tick_;
};

/// No torque at all: the hopper falls slowly to one side.
inline Eigen::VectorXd NoTorque(const SensorFrame& frame, int /*num_before*/) {
  return Eigen::VectorXd::Zero(frame.joint_position.size());
}

/// Leans on noisy encoders and on how often it was asked: whoever draws other noise, or forgets the
/// count, moves otherwise.
inline Eigen::VectorXd NoisyTorque(const SensorFrame& frame, int num_before) {
  return -2.0 * frame.joint_position.array() + 1e-3 * num_before;
}

/// A factory of TorqueController. @param seen  Gets the frames; may be null.
inline ControllerFactory TorqueBy(TorqueController::Law law, std::shared_ptr<Frames> seen = {}) {
  return [law = std::move(law), seen = std::move(seen)](const ControllerSetup&, StageTimer*) {
    return std::make_unique<TorqueController>(law, seen);
  };
}

/// The hopper with its noisy sensors, for `duration_s`: 1 ms ticks, control at 500 Hz; no pushes,
/// and no expectations, which are of a longer run.
inline Scenario ShortHop(double duration_s, const std::vector<std::string>& overrides = {}) {
  Scenario scenario = HoppingHopper(overrides);
  scenario.duration_s = duration_s;
  scenario.pushes.clear();
  scenario.expect.clear();
  return scenario;
}

/// The same with a sideways push on the trunk from 0.1 s on: without control it falls within 1 s.
inline Scenario FallingHopper() {
  Scenario scenario = ShortHop(5.0);
  scenario.pushes = {TrunkPush({0.0, 5.0, 0.0}, 0.1, 0.2, Eigen::Vector3d::Zero())};
  return scenario;
}

}  // namespace sidestep
