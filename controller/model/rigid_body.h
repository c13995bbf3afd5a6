// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// rigid_body: kinematics and dynamics of the nominal robot, on the controller's own mjModel.
//
// In : base pose and velocity, joints.     Out: M, bias, CoM, momentum, feet and their Jacobians.
// The only place of controller/ where MuJoCo appears. Velocities nu are MuJoCo's:
//   nu = [v_WB (base origin, in W); w_WB_B (in B); joints in the order of the model],
// of a base that moves in a plane nu = [v_WB.x, v_WB.z, w_WB_B.y; joints]: see base_joints.h.
// States stay three-dimensional; what such a base can't do is not read. Equation of motion: M nudot
// + h = S^T tau + sum J_F^T f_F, h holding gravity and damping.
//
// There is no order of calls to keep: Update() poses the robot, and whatever is read afterwards
// belongs to that state, evaluated when it is first read and kept until the next Update().

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "controller/types/robot_state.h"
#include "models/mjcf/base_joints.h"
#include "models/mjcf/centroidal_motion.h"
#include "models/mjcf/mj_state.h"
#include "models/mjcf/stretched_leg.h"
#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Row-major like MuJoCo's Jacobians, so that they map without a copy.
using Jacobian3 = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;

/// A foot's pose and velocity.
/// All in W, of the sole's origin F.
struct FootKinematics {
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};  ///< m.
  Eigen::Matrix3d R_WF{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};  ///< m/s.
  Eigen::Vector3d w_WF{Eigen::Vector3d::Zero()};  ///< rad/s.
};

/// Of a frame: its velocities are J nu and J_rot nu, in W.
struct FrameJacobian {
  Jacobian3 J;      ///< 3 x nv, linear.
  Jacobian3 J_rot;  ///< 3 x nv, angular.
};

/// Accelerations of a frame at nudot = 0, in W: Jdot nu.
struct FrameBias {
  Eigen::Vector3d linear_mps2{Eigen::Vector3d::Zero()};
  Eigen::Vector3d angular_radps2{Eigen::Vector3d::Zero()};
};

/// Motion of the IMU's site U, in W.
struct ImuKinematics {
  Eigen::Vector3d p_WU{Eigen::Vector3d::Zero()};  ///< m.
  Eigen::Matrix3d R_WU{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d v_WU{Eigen::Vector3d::Zero()};  ///< m/s.
  Eigen::Vector3d w_WU{Eigen::Vector3d::Zero()};  ///< rad/s, in W: the gyro tells it in U.
};

/// How the IMU's site U sits on the base B, and turns against it, for the joints' state.
struct ImuInBase {
  Eigen::Matrix3d R_BU{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d w_BU_B{Eigen::Vector3d::Zero()};  ///< Of U relative to B.
};

/// Attitude and angular velocity of the torso's site T, in W.
struct TorsoKinematics {
  Eigen::Matrix3d R_WT{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d w_WT{Eigen::Vector3d::Zero()};
};

/// A force/torque sensor: its site, and what it would read were nothing but gravity and inertia
/// acting on its distal part.
struct ForceTorqueKinematics {
  Eigen::Vector3d p_WS{Eigen::Vector3d::Zero()};  ///< m.
  Eigen::Matrix3d R_WS{Eigen::Matrix3d::Identity()};
  Wrench unloaded;  ///< Distal on proximal, in S, about S.
};

/// The nominal robot at one state. A value: copies share the compiled model and nothing else. Not
/// thread-safe, not even to read, for reading evaluates. Nothing but construction and copies
/// allocates.
class RigidBody {
 public:
  /// Compiles the robot's MJCF and poses it at home, at rest. Throws ConfigError if it lacks a name
  /// that robot.yaml promises.
  explicit RigidBody(const RobotDescription& robot);

  /// Puts it at the base and joint state of `state`. Poses and velocities of feet, IMU and torso,
  /// the CoM and the momentum are evaluated at once, all else when it is first read.
  void Update(const RobotState& state);

  /// Moves the robot as a whole by `p` (m) and makes it faster by `v` (m/s), both in W. Leaves what
  /// evaluating that state would, for next to nothing: rotations, momentum about the CoM, M,
  /// Jacobians and biases depend on neither, whether they have been read before or not.
  /// PredictForceTorque() alone goes on telling sites where they were.
  void Translate(const Eigen::Vector3d& p, const Eigen::Vector3d& v);

  /// The IMU on the base for the joints of `state`, whose base is not read. The robot is at no
  /// state after it: reading one before the next Update() is a ContractViolation.
  ImuInBase LocateImu(const RobotState& state);

  /// Poses of the force/torque sensors and their unloaded readings for the acceleration `nudot`
  /// (nv). The reference stays valid; the next call overwrites what is behind it.
  const std::vector<ForceTorqueKinematics>& PredictForceTorque(const Eigen::VectorXd& nudot);

  /// Base position and attitude and joints at the start of a run; the rest of `state` is zero.
  void WriteHome(RobotState* state) const;

  /// Leaves of `state`'s base, and of the external wrench, what this base can do: nothing changes
  /// where it is free.
  void Project(RobotState* state) const;

  /// Writes p_WC, v_WC, angular_momentum and the feet's pose and velocity into `state`, which must
  /// be the state given to Update(). Leaves in_contact alone.
  void FillDerived(RobotState* state) const;

  /// Sizes of the model, fixed from construction on.
  int num_velocities() const { return state_.model().nv; }
  int num_base_velocities() const { return base_.num_velocities(); }
  int num_actuators() const { return state_.model().nu; }
  std::size_t num_feet() const { return foot_site_.size(); }
  bool has_torso() const { return torso_site_ >= 0; }
  bool has_force_torque() const { return !force_torque_ids_.empty(); }
  double mass_kg() const { return mass_kg_; }
  const Eigen::Vector3d& gravity_mps2() const { return gravity_mps2_; }

  const Eigen::VectorXd& velocity() const;  ///< nu, nv.
  const std::vector<FootKinematics>& feet() const;
  const ImuKinematics& imu() const;
  const TorsoKinematics& torso() const;

  /// Whether the legs hang on another body than the base, over joints: the model is rooted above a
  /// waist, or in a foot.
  bool has_waist() const { return leg_root_body_ != base_body_; }
  /// Attitude in W of the body that the legs hang on.
  Eigen::Matrix3d leg_root_R_W() const;

  const Eigen::MatrixXd& mass_matrix() const;  ///< M, nv x nv.
  const Eigen::VectorXd& bias() const;         ///< h, nv.

  /// How the base floats: which component of a twist or a wrench each base row is.
  const BaseJoints& base() const { return base_; }

  /// Locked inertia about the base's origin, in B: the base block of M (kg m^2), zero about axes
  /// that the base can't turn about.
  Eigen::Matrix3d base_inertia() const;

  const Jacobian3& com_jacobian() const;         ///< 3 x nv: v_WC = J nu.
  const Eigen::Vector3d& com_bias_mps2() const;  ///< Jdot nu.

  /// By index of RobotDescription::feet. References stay valid as long as the body lives; what is
  /// behind them changes with the next Update(), or when it is first read after that.
  const FrameJacobian& foot_jacobian(std::size_t foot) const;
  const FrameBias& foot_bias(std::size_t foot) const;
  const Jacobian3& torso_jacobian() const;           ///< 3 x nv, angular: w_WT = J nu.
  const Eigen::Vector3d& torso_bias_radps2() const;  ///< Jdot nu.

  /// 3 x nv: h_C_W = J nu, the angular momentum about C.
  const Jacobian3& angular_momentum_jacobian() const;
  /// Jdot nu (N m): J nudot + Jdot nu is the moment about C of all forces but gravity.
  const Eigen::Vector3d& angular_momentum_bias_Nm() const;

  /// The leg of a foot as it is at home, if it has one. By index of RobotDescription::feet.
  const std::optional<StretchedLeg>& leg(std::size_t foot) const { return legs_[foot]; }

  /// Index in nu of each actuator's joint, in the order of the actuators.
  const std::vector<int>& actuated_velocity() const { return actuated_velocity_; }
  /// Greatest torque of each actuator, the upper end of its control range; N for a slide.
  const Eigen::VectorXd& torque_limit_Nm() const { return torque_limit_Nm_; }

  /// Position limits of each actuator's joint (rad); infinite where there is none.
  const Eigen::VectorXd& joint_lower() const { return joint_lower_; }
  const Eigen::VectorXd& joint_upper() const { return joint_upper_; }

 private:
  /// What is evaluated when it is first read, and whether it has been since the last Update().
  struct Evaluated {
    bool has_mass_matrix{false}, has_bias{false}, has_frame_jacobians{false}, has_frame_bias{false},
        has_angular_momentum{false};
    Eigen::MatrixXd mass_matrix;
    Jacobian3 com_jacobian;
    Eigen::VectorXd bias;
    Eigen::Vector3d com_bias_mps2{Eigen::Vector3d::Zero()};
    std::vector<FrameJacobian> foot_jacobian;
    std::vector<FrameBias> foot_bias;
    Jacobian3 torso_jacobian;
    Eigen::Vector3d torso_bias_radps2{Eigen::Vector3d::Zero()};
    Jacobian3 angular_momentum_jacobian;
    Eigen::Vector3d angular_momentum_bias_Nm{Eigen::Vector3d::Zero()};
  };
  struct ForceTorqueIds {
    int site{0}, force{0}, torque{0};  // addresses in sensordata
  };

  void ResolveNames(const RobotDescription& robot);
  void ResolveImuChain();
  void ResolveActuators();
  void TakeMemory();
  void SetState(const RobotState& state);
  void SetJoints(const RobotState& state);
  void RequireState() const;
  void EvaluateMassMatrix() const;
  void EvaluateBias() const;
  void EvaluateFrameJacobians() const;
  void EvaluateFrameBias() const;
  void EvaluateAngularMomentum() const;

  MjState state_;
  double mass_kg_{0.0};
  Eigen::Vector3d gravity_mps2_;
  int base_body_{0};
  BaseJoints base_;
  std::vector<int> foot_site_;
  int leg_root_body_{0};
  std::vector<std::optional<StretchedLeg>> legs_;
  std::vector<int> actuated_position_;  // index in qpos
  std::vector<int> actuated_velocity_;
  Eigen::VectorXd torque_limit_Nm_;
  Eigen::VectorXd joint_lower_;
  Eigen::VectorXd joint_upper_;
  int imu_site_{0};
  std::vector<int> joints_to_imu_;
  int torso_site_{-1};
  std::vector<ForceTorqueIds> force_torque_ids_;
  Eigen::VectorXd home_position_;  // qpos

  bool has_state_{false};  // mjData is where Update() put it
  Eigen::VectorXd velocity_;
  CentroidalMotion centroidal_;
  std::vector<FootKinematics> feet_;
  ImuKinematics imu_;
  TorsoKinematics torso_;
  mutable Evaluated evaluated_;
  std::vector<ForceTorqueKinematics> force_torque_;
};

}  // namespace sidestep
