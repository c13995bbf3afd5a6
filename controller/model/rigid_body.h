// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// rigid_body: kinematics and dynamics of the nominal robot, on the controller's own mjModel.
//
// In : base pose and velocity, joints.     Out: M, bias, CoM, momentum, feet and their Jacobians.
// The only place of controller/ where MuJoCo appears. Velocities nu are MuJoCo's:
//   nu = [v_WB (base origin, in W); w_WB_B (in B); joints in the order of the model].
// Equation of motion: M nudot + h = S^T tau + sum J_F^T f_F, h holding gravity and damping.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "controller/types/robot_state.h"
#include "models/mjcf/centroidal_motion.h"
#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Row-major like MuJoCo's Jacobians, so that they map without a copy.
using Jacobian3 = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;

/// A foot's kinematics at the current state.
struct FootKinematics {
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d R_WF{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d w_WF{Eigen::Vector3d::Zero()};
  Jacobian3 J;                                         ///< 3 x nv, velocity of F in W.
  Jacobian3 J_rot;                                     ///< 3 x nv, angular velocity of F in W.
  Eigen::Vector3d bias_mps2{Eigen::Vector3d::Zero()};  ///< Jdot nu.
};

/// Motion of the IMU's site U at the current state, in W.
struct ImuKinematics {
  Eigen::Vector3d p_WU{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d R_WU{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d v_WU{Eigen::Vector3d::Zero()};
  Eigen::Vector3d w_WU{Eigen::Vector3d::Zero()};
};

/// How the IMU's site U sits on the base B, and turns against it, for the joints' state.
struct ImuInBase {
  Eigen::Matrix3d R_BU{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d w_BU_B{Eigen::Vector3d::Zero()};  ///< Of U relative to B.
};

/// Orientation of the torso's site at the current state.
struct TorsoKinematics {
  Eigen::Matrix3d R_WT{Eigen::Matrix3d::Identity()};
  Jacobian3 J_rot;  ///< 3 x nv, angular velocity in W.
};

/// A force/torque sensor at the current state: its site, and what it would read were nothing but
/// gravity and inertia acting on its distal part.
struct ForceTorqueKinematics {
  Eigen::Vector3d p_WS{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d R_WS{Eigen::Matrix3d::Identity()};
  Wrench unloaded;  ///< Distal on proximal, in S, about S.
};

/// The nominal robot. The Update functions evaluate it at one state; the rest reads what they left.
class RigidBody {
 public:
  /// Compiles the robot's MJCF. Throws ConfigError if it lacks a name that robot.yaml promises.
  explicit RigidBody(const RobotDescription& robot);

  /// Evaluates everything at the base and joint state of `state`: the four below in a row.
  /// None of them allocates.
  void Update(const RobotState& state);

  /// Poses and velocities: of feet, IMU and torso, the CoM, the angular momentum.
  void UpdateKinematics(const RobotState& state);

  /// M with base_inertia(), and the Jacobians of CoM, feet and torso, at the state of the last
  /// UpdateKinematics(). They keep that state until the next call.
  void UpdateJacobians();

  /// h and com_bias_mps2(), at the state of the last UpdateKinematics().
  void UpdateBias();

  /// The feet's bias_mps2, at the state of the last UpdateKinematics().
  void UpdateFootBias();

  /// Moves the robot of the last UpdateKinematics() as a whole by `p` (m) and makes it faster by
  /// `v` (m/s), both in W. Leaves what evaluating that state would, for next to nothing: rotations,
  /// momentum about the CoM, M, Jacobians and biases depend on neither. force_torque() stays where
  /// it was, after an UpdateForceTorque() too.
  void Translate(const Eigen::Vector3d& p, const Eigen::Vector3d& v);

  /// The IMU on the base for the joints of `state`, whose base is not read. What the Update
  /// functions leave stays, but the next of them must be UpdateKinematics().
  ImuInBase LocateImu(const RobotState& state);

  /// Predicts the force/torque sensors for the acceleration `nudot` (nv) at the state of the last
  /// UpdateKinematics().
  void UpdateForceTorque(const Eigen::VectorXd& nudot);

  /// Base position and attitude and joints at the start of a run; the rest of `state` is zero.
  void WriteHome(RobotState* state) const;

  /// Writes p_WC, v_WC, angular_momentum and the feet's pose and velocity into `state`, which must
  /// be the state given to UpdateKinematics(). Leaves in_contact alone.
  void FillDerived(RobotState* state) const;

  int num_velocities() const { return model_->nv; }
  int num_actuators() const { return model_->nu; }
  double mass_kg() const { return mass_kg_; }
  const Eigen::Vector3d& gravity_mps2() const { return gravity_mps2_; }

  const Eigen::MatrixXd& mass_matrix() const { return mass_matrix_; }  ///< nv x nv.
  const Eigen::VectorXd& bias() const { return bias_; }                ///< h, nv.
  const Eigen::VectorXd& velocity() const { return velocity_; }        ///< nu, nv.
  const Jacobian3& com_jacobian() const { return com_jacobian_; }      ///< 3 x nv, in W.
  const Eigen::Vector3d& com_bias_mps2() const { return com_bias_mps2_; }
  const std::vector<FootKinematics>& feet() const { return feet_; }
  const ImuKinematics& imu() const { return imu_; }
  bool has_torso() const { return torso_site_ >= 0; }
  const TorsoKinematics& torso() const { return torso_; }
  const std::vector<ForceTorqueKinematics>& force_torque() const { return force_torque_; }

  /// Index in nu of each actuator's joint, in the order of the actuators.
  const std::vector<int>& actuated_velocity() const { return actuated_velocity_; }
  const Eigen::VectorXd& torque_limit_Nm() const { return torque_limit_Nm_; }

  /// Position limits of each actuator's joint (rad); infinite where there is none.
  const Eigen::VectorXd& joint_lower() const { return joint_lower_; }
  const Eigen::VectorXd& joint_upper() const { return joint_upper_; }

  /// Locked inertia about the base's origin, in B: the base block of M (kg m^2).
  Eigen::Matrix3d base_inertia() const { return mass_matrix_.block<3, 3>(3, 3); }

 private:
  void ResolveNames(const RobotDescription& robot);
  void ResolveImuChain();
  void SetState(const RobotState& state);
  void SetJoints(const RobotState& state);

  MjModelPtr model_;
  MjDataPtr data_;
  double mass_kg_{0.0};
  Eigen::Vector3d gravity_mps2_;
  int base_body_{0};
  std::vector<int> foot_site_;
  std::vector<int> actuated_position_;  // index in qpos
  std::vector<int> actuated_velocity_;
  Eigen::VectorXd torque_limit_Nm_;
  Eigen::VectorXd joint_lower_;
  Eigen::VectorXd joint_upper_;
  int imu_site_{0};
  std::vector<int> joints_to_imu_;
  int torso_site_{-1};
  struct ForceTorqueIds {
    int site{0}, force{0}, torque{0};  // addresses in sensordata
  };
  std::vector<ForceTorqueIds> force_torque_ids_;
  Eigen::VectorXd home_position_;  // qpos

  Eigen::MatrixXd mass_matrix_;
  Eigen::VectorXd bias_;
  Eigen::VectorXd velocity_;
  Jacobian3 com_jacobian_;
  Eigen::Vector3d com_bias_mps2_;
  CentroidalMotion centroidal_;
  std::vector<FootKinematics> feet_;
  ImuKinematics imu_;
  TorsoKinematics torso_;
  std::vector<ForceTorqueKinematics> force_torque_;
};

}  // namespace sidestep
