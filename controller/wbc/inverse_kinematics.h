// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// inverse_kinematics: references of the joints' servos from CoM, feet, torso and posture, by one
// QP.
//
//   minimise   w_T |J_T nu - w_T*|^2 + sum_j w_j (qdot_j - k (q_home_j - q_j))^2
//   over       nu (nv): base twist and joint velocities
//   subject to J_F nu = v_F* for both feet's poses, J_C nu = v_C*, and joint position and velocity
//              limits
//
// nu is integrated to the *commanded* robot, a kinematic state of its own; its joints are the
// servos' references. Starred velocities are feed-forward plus gain times error of the commanded
// robot. Measurements enter by the CoM velocity (com_zmp_correction) and by the anchor: a rigid
// motion of the commanded robot, which leaves its joints alone and keeps it where the belief sees
// the standing feet and the attitude of the body that the legs hang on. (Not the base's, if a waist
// is between them: how far the trunk makes its servos give way is not how far the robot has turned.
// Feet would turn against it, and the trunk lean more.) Standing feet may give way to the ground
// (foot_compliance.h), and a swinging foot's attitude may be weighed instead of exact. Source:
// Romualdi et al. (ICRA 2022), section III-C.

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "controller/model/rigid_body.h"
#include "controller/types/control_params.h"
#include "controller/wbc/foot_compliance.h"
#include "controller/wbc/qp/dense_qp.h"
#include "controller/wbc/qp_builder.h"
#include "controller/wbc/servo_deflection.h"
#include "controller/wbc/whole_body.h"

namespace sidestep::wbc {

class InverseKinematics final : public WholeBody {
 public:
  /// `dt_s` is the control period. The robot must have servos (RobotDescription::joints).
  InverseKinematics(const RobotDescription& robot, const InverseKinematicsParams& params,
                    double dt_s);

  /// `body` is read only of a robot with a waist between base and legs: the commanded robot has one
  /// of its own. If no twist meets all exact rows and limits, those of the CoM become a task of
  /// high weight and the report is not ok; should that fail too, the commanded robot stays where it
  /// is. The first call puts the commanded robot at the belief.
  WbcReport Solve(const RobotState& state, const RigidBody& body, const ComTarget& com,
                  const std::vector<FootTarget>& feet, ActuatorCommand* command) override;
  std::unique_ptr<WholeBody> Clone() const override;

  /// The last problem solved. If its CoM rows had to give way, they are in H and g, not in A.
  DenseQpView problem() const { return qp_.View(); }

 private:
  /// Where a standing foot is held.
  struct Hold {
    bool active{false};  ///< It stands, as the schedule and the landing have it.
    Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};
  };

  /// The commanded robot as it is believed to be, at rest, every foot held.
  void Start(const RobotState& state);
  /// Draws the commanded robot as a whole to the belief, which `believed` is at, while a held foot
  /// is felt.
  void Anchor(const RobotState& state, const RigidBody& believed);
  void Build(const Eigen::Vector3d& v_WC, const RobotState& state,
             const std::vector<FootTarget>& feet);
  /// Exact rows, six on a base that floats freely: flat, on its hold or along its target.
  void AddFoot(std::size_t foot, const FootTarget& target, bool stands);
  void AddTrunk(const std::vector<FootTarget>& feet);
  void AddPosture();
  /// Velocity bounds that also keep each joint from running into its end.
  void AddJointLimits();
  void Integrate(const Eigen::VectorXd& nu);
  /// Where an actuator's joint is in nu.
  Eigen::Index Joint(std::size_t actuator) const;

  RobotDescription robot_;
  InverseKinematicsParams params_;
  double dt_s_;
  RigidBody body_;  // at the commanded state
  RobotState commanded_;
  bool started_{false};
  Eigen::Index nv_;
  Eigen::VectorXd home_;     // posture, one a joint
  std::vector<Hold> holds_;  // one a foot
  std::vector<Eigen::Matrix3Xd> vertices_m_;
  std::vector<FootYielding> yielding_;
  ServoDeflection deflection_;
  QpBuilder qp_;
  DenseQpSolver solver_;
  Eigen::VectorXd nu_;
};

}  // namespace sidestep::wbc
