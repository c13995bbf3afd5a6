// SPDX-License-Identifier: BSD-3-Clause
// A whole-body controller that is copied in mid-run: both go on bit for bit, and neither knows of
// the other.
#include <gtest/gtest.h>

#include "controller/wbc/inverse_dynamics.h"
#include "controller/wbc/inverse_kinematics.h"
#include "tests/support/icub3_stance.h"
#include "tests/support/wild_targets.h"

namespace sidestep::wbc::whole_body_copy_test {
namespace {

/// Moves belief and targets of a tick; `seed` decides how.
class Story {
 public:
  explicit Story(std::uint64_t seed) : targets_(seed, &stance_) { stance_.PlanWeightEvenly(); }

  ActuatorCommand Tick(WholeBody* whole_body) {
    targets_.Next();
    ActuatorCommand command;
    whole_body->Solve(stance_.state, stance_.body, stance_.com, stance_.feet, &command);
    return command;
  }

 private:
  IcubStance stance_;
  WildTargets targets_;
};

class WholeBodyCopyTest : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Ticks, WholeBodyCopyTest, testing::Values(0, 1, 17, 40));

TEST_P(WholeBodyCopyTest, InverseKinematicsAndItsCloneGoOnAsOneThatWasNeverCopied) {
  const RobotDescription robot = Icub3();
  const InverseKinematicsParams params;
  InverseKinematics never_copied(robot, params, kStanceTick_s);
  auto original = std::make_unique<InverseKinematics>(robot, params, kStanceTick_s);
  Story reference(5), before(5);
  for (int tick = 0; tick < GetParam(); ++tick) {
    reference.Tick(&never_copied);
    before.Tick(original.get());
  }
  const std::unique_ptr<WholeBody> clone = original->Clone();
  Story other(9);
  for (int tick = 0; tick < 30; ++tick) other.Tick(original.get());  // goes its own way
  original.reset();
  for (int tick = 0; tick < 30; ++tick) {
    const ActuatorCommand expected = reference.Tick(&never_copied);
    const ActuatorCommand command = before.Tick(clone.get());
    ASSERT_EQ(command.joint_position, expected.joint_position) << tick;
    ASSERT_EQ(command.joint_velocity, expected.joint_velocity) << tick;
  }
}

TEST_P(WholeBodyCopyTest, InverseDynamicsAndItsCloneGiveTheSameTorques) {
  const RobotDescription robot =
      ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models/hopper/robot.yaml");
  RigidBody body(robot);
  RobotState state;
  state.feet.resize(1);
  body.WriteHome(&state);
  SeededNumbers numbers(static_cast<std::uint64_t>(GetParam()));
  std::vector<FootTarget> feet(1);
  const auto draw = [&] {
    state.joint_velocity = numbers.NormalMatrix(3, 1);
    state.w_WB_B = 0.3 * numbers.NormalMatrix(3, 1);
    body.Update(state);
    body.FillDerived(&state);
    state.feet[0].in_contact = feet[0].planned_contact = numbers.Integer(0, 1) == 1;
    feet[0].supports = feet[0].planned_contact;
    feet[0].p_WF = state.feet[0].p_WF + 0.01 * numbers.NormalMatrix(3, 1);
    feet[0].vertex_force_N = Eigen::Vector3d(0.0, 0.0, 9.81);
  };
  InverseDynamics original(robot, {}, body);
  ActuatorCommand command, copied;
  for (int tick = 0; tick < GetParam(); ++tick) {
    draw();
    original.Solve(state, body, {}, feet, &command);
  }
  const std::unique_ptr<WholeBody> clone = original.Clone();
  for (int tick = 0; tick < 30; ++tick) {
    draw();
    // The clone holds no pointer to the original's.
    const RigidBody elsewhere(body);  // NOLINT(performance-unnecessary-copy-initialization)
    original.Solve(state, body, {}, feet, &command);
    clone->Solve(state, elsewhere, {}, feet, &copied);
    ASSERT_EQ(copied.torque_Nm, command.torque_Nm) << tick;
    ASSERT_GT(command.torque_Nm.norm(), 0.0);
  }
}

}  // namespace
}  // namespace sidestep::wbc::whole_body_copy_test
