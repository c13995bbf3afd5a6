// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/contact_forces.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "controller/types/friction_pyramid.h"

namespace sidestep::wbc {

Eigen::Matrix<double, 6, 1> FootWrench(const Eigen::Matrix3d& R_WF,
                                       const Eigen::Matrix3Xd& vertices_m,
                                       const Eigen::Matrix3Xd& vertex_force_N) {
  Eigen::Matrix<double, 6, 1> wrench = Eigen::Matrix<double, 6, 1>::Zero();
  for (Eigen::Index v = 0; v < vertices_m.cols(); ++v) {
    const Eigen::Vector3d force_N = vertex_force_N.col(v);
    wrench.head<3>() += force_N;
    wrench.tail<3>() += (R_WF * vertices_m.col(v)).cross(force_N);
  }
  return wrench;
}

ContactForces::ContactForces(const RobotDescription& robot, int num_velocities, double friction)
    : pyramid_(FrictionPyramid(friction)), num_velocities_(num_velocities) {
  Eigen::Index vertices = 0;
  for (const FootDescription& foot : robot.feet) {
    feet_.push_back({foot.vertices_m});
    vertices += foot.vertices_m.cols();
  }
  jacobian_.setZero(3 * vertices, num_velocities);
  planned_N_.setZero(3 * vertices);
  p_WV_.setZero(3, vertices);
  moment_.setZero(3, 3 * vertices);
}

void ContactForces::Update(const RobotState& state, const RigidBody& body,
                           const std::vector<FootTarget>& feet) {
  const double firm_N = kUnfeltShare * body.mass_kg() * body.gravity_mps2().norm();
  size_ = 0;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    Foot& at = feet_[i];
    at.is_felt = state.feet[i].in_contact;
    const double felt_N = at.is_felt ? state.feet[i].wrench.force_N.z() : 0.0;
    at.hold =
        std::clamp(std::max(felt_N, feet[i].vertex_force_N.row(2).sum()) / firm_N, kLeastHold, 1.0);
    at.stands = feet[i].supports;
    at.first = size_;
    if (!at.stands) continue;
    const FrameJacobian& foot = body.foot_jacobian(i);
    for (Eigen::Index v = 0; v < at.vertices_m.cols(); ++v) {
      const Eigen::Vector3d p_FV_W = body.feet()[i].R_WF * at.vertices_m.col(v);
      for (Eigen::Index column = 0; column < num_velocities_; ++column) {
        jacobian_.block<3, 1>(size_, column) =
            foot.J.col(column) - p_FV_W.cross(foot.J_rot.col(column));
      }
      p_WV_.col(size_ / 3) = body.feet()[i].p_WF + p_FV_W;
      planned_N_.segment<3>(size_) = feet[i].vertex_force_N.col(v);
      size_ += 3;
    }
  }
}

void ContactForces::AddPlanTo(double weight, QpBuilder* qp) const {
  for (Eigen::Index i = 0; i < size_; ++i) {
    qp->AddDiagonal(num_velocities_ + i, planned_N_[i], weight);
  }
}

void ContactForces::AddMomentTo(const Eigen::Vector3d& p_WC, const Eigen::Vector3d& moment_W,
                                double weight, QpBuilder* qp) {
  for (Eigen::Index first = 0; first < size_; first += 3) {
    const Eigen::Vector3d p_CV_W = p_WV_.col(first / 3) - p_WC;
    moment_.middleCols<3>(first) << 0.0, -p_CV_W.z(), p_CV_W.y(),  //
        p_CV_W.z(), 0.0, -p_CV_W.x(),                              //
        -p_CV_W.y(), p_CV_W.x(), 0.0;
  }
  qp->AddTaskOn(num_velocities_, moment_.leftCols(size_), moment_W, weight);
}

void ContactForces::AddLimitsTo(double weight_N, QpBuilder* qp) const {
  for (Eigen::Index first = 0; first < size_; first += 3) {
    InequalityRows rows = qp->AddInequalities(pyramid_.rows());
    rows.C.middleCols<3>(num_velocities_ + first) = pyramid_;
    rows.upper.setZero();
  }
  for (const Foot& foot : feet_) {
    if (!foot.stands || foot.is_felt) continue;
    InequalityRows row = qp->AddInequalities(1);
    for (Eigen::Index v = 0; v < foot.vertices_m.cols(); ++v) {
      row.C(0, num_velocities_ + foot.first + 3 * v + 2) = 1.0;
    }
    row.upper[0] = kUnfeltShare * weight_N;
  }
}

}  // namespace sidestep::wbc
