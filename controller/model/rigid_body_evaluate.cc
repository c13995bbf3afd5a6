// SPDX-License-Identifier: BSD-3-Clause
// What a RigidBody evaluates when it is first read: M, biases and Jacobians at its state.
#include <Eigen/Geometry>

#include "controller/model/rigid_body.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

Eigen::Map<const Eigen::Vector3d> Vector3At(const mjtNum* numbers) {
  return Eigen::Map<const Eigen::Vector3d>(numbers);
}

}  // namespace

const Eigen::VectorXd& RigidBody::velocity() const {
  RequireState();
  return velocity_;
}

const std::vector<FootKinematics>& RigidBody::feet() const {
  RequireState();
  return feet_;
}

const ImuKinematics& RigidBody::imu() const {
  RequireState();
  return imu_;
}

const TorsoKinematics& RigidBody::torso() const {
  RequireState();
  return torso_;
}

const Eigen::MatrixXd& RigidBody::mass_matrix() const {
  EvaluateMassMatrix();
  return evaluated_.mass_matrix;
}

const Jacobian3& RigidBody::com_jacobian() const {
  EvaluateMassMatrix();
  return evaluated_.com_jacobian;
}

void RigidBody::EvaluateMassMatrix() const {
  RequireState();
  if (evaluated_.has_mass_matrix) return;
  evaluated_.has_mass_matrix = true;
  mj_crb(&state_.model(), state_.get());
  mj_fullM(&state_.model(), evaluated_.mass_matrix.data(), state_->qM);
  // The base's linear rows are Newton's law of the whole robot: m a_C - m g = sum of forces.
  Eigen::Index row = 0;
  for (const int axis : base_.linear_axes()) {
    evaluated_.com_jacobian.row(axis) = evaluated_.mass_matrix.row(row++) / mass_kg_;
  }
}

Eigen::Matrix3d RigidBody::base_inertia() const {
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Eigen::Index row = base_.num_linear();
  for (const int axis : base_.angular_axes()) {
    inertia.row(axis) = base_.Spread(mass_matrix().row(row++)).tail<3>().transpose();
  }
  return inertia;
}

const Eigen::VectorXd& RigidBody::bias() const {
  EvaluateBias();
  return evaluated_.bias;
}

const Eigen::Vector3d& RigidBody::com_bias_mps2() const {
  EvaluateBias();
  return evaluated_.com_bias_mps2;
}

void RigidBody::EvaluateBias() const {
  RequireState();
  if (evaluated_.has_bias) return;
  evaluated_.has_bias = true;
  const mjModel* model = &state_.model();
  mjData* data = state_.get();
  mj_passive(model, data);
  mj_rne(model, data, 0, data->qfrc_bias);
  evaluated_.bias = Eigen::Map<const Eigen::VectorXd>(data->qfrc_bias, model->nv) -
                    Eigen::Map<const Eigen::VectorXd>(data->qfrc_passive, model->nv);
  const Vector6 base_bias = base_.Spread(evaluated_.bias);
  evaluated_.com_bias_mps2 = base_bias.head<3>() / mass_kg_ + gravity_mps2_;
}

const FrameJacobian& RigidBody::foot_jacobian(std::size_t foot) const {
  EvaluateFrameJacobians();
  return evaluated_.foot_jacobian[foot];
}

const Jacobian3& RigidBody::torso_jacobian() const {
  EvaluateFrameJacobians();
  return evaluated_.torso_jacobian;
}

void RigidBody::EvaluateFrameJacobians() const {
  RequireState();
  if (evaluated_.has_frame_jacobians) return;
  evaluated_.has_frame_jacobians = true;
  const mjModel* model = &state_.model();
  mjData* data = state_.get();
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    FrameJacobian& foot = evaluated_.foot_jacobian[i];
    mj_jacSite(model, data, foot.J.data(), foot.J_rot.data(), foot_site_[i]);
  }
  if (has_torso()) {
    mj_jacSite(model, data, nullptr, evaluated_.torso_jacobian.data(), torso_site_);
  }
}

const FrameBias& RigidBody::foot_bias(std::size_t foot) const {
  EvaluateFrameBias();
  return evaluated_.foot_bias[foot];
}

const Eigen::Vector3d& RigidBody::torso_bias_radps2() const {
  EvaluateFrameBias();
  return evaluated_.torso_bias_radps2;
}

void RigidBody::EvaluateFrameBias() const {
  RequireState();
  if (evaluated_.has_frame_bias) return;
  evaluated_.has_frame_bias = true;
  const mjModel* model = &state_.model();
  mjData* data = state_.get();
  // With qacc = 0 an object's acceleration is Jdot nu, minus gravity by MuJoCo's convention.
  mju_zero(data->qacc, model->nv);
  mj_rnePostConstraint(model, data);
  mjtNum acceleration[6];  // [angular; linear]
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    mj_objectAcceleration(model, data, mjOBJ_SITE, foot_site_[i], acceleration, 0);
    evaluated_.foot_bias[i].linear_mps2 = Vector3At(acceleration + 3) + gravity_mps2_;
    evaluated_.foot_bias[i].angular_radps2 = Vector3At(acceleration);
  }
  if (has_torso()) {
    mj_objectAcceleration(model, data, mjOBJ_SITE, torso_site_, acceleration, 0);
    evaluated_.torso_bias_radps2 = Vector3At(acceleration);
  }
}

const Jacobian3& RigidBody::angular_momentum_jacobian() const {
  EvaluateAngularMomentum();
  return evaluated_.angular_momentum_jacobian;
}

const Eigen::Vector3d& RigidBody::angular_momentum_bias_Nm() const {
  EvaluateAngularMomentum();
  return evaluated_.angular_momentum_bias_Nm;
}

// The base's rows of the equation of motion, moved from its origin, in B, to C, in W. Gravity,
// which acts at C, drops out of the bias.
void RigidBody::EvaluateAngularMomentum() const {
  EvaluateMassMatrix();
  EvaluateBias();
  if (evaluated_.has_angular_momentum) return;
  evaluated_.has_angular_momentum = true;
  const mjData* data = state_.get();
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R_WB(data->xmat +
                                                                            9 * base_body_);
  const Eigen::Vector3d p_BC_W =
      Vector3At(data->subtree_com + 3 * base_body_) - Vector3At(data->xpos + 3 * base_body_);
  const auto about_com = [&](const Vector6& rows) -> Eigen::Vector3d {
    return R_WB * rows.tail<3>() - p_BC_W.cross(rows.head<3>());
  };
  for (Eigen::Index i = 0; i < velocity_.size(); ++i) {
    evaluated_.angular_momentum_jacobian.col(i) =
        about_com(base_.Spread(evaluated_.mass_matrix.col(i)));
  }
  evaluated_.angular_momentum_bias_Nm = about_com(base_.Spread(evaluated_.bias));
}

}  // namespace sidestep
