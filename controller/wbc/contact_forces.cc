// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/contact_forces.h"

#include <Eigen/Geometry>

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
    vertices_m_.push_back(foot.vertices_m);
    vertices += foot.vertices_m.cols();
  }
  jacobian_.setZero(3 * vertices, num_velocities);
  planned_N_.setZero(3 * vertices);
}

void ContactForces::Update(const RobotState& state, const RigidBody& body,
                           const std::vector<FootTarget>& feet) {
  size_ = 0;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    if (!feet[i].supports) continue;
    const FrameJacobian& foot = body.foot_jacobian(i);
    for (Eigen::Index v = 0; v < vertices_m_[i].cols(); ++v) {
      const Eigen::Vector3d p_FV_W = body.feet()[i].R_WF * vertices_m_[i].col(v);
      for (Eigen::Index column = 0; column < num_velocities_; ++column) {
        jacobian_.block<3, 1>(size_, column) =
            foot.J.col(column) - p_FV_W.cross(foot.J_rot.col(column));
      }
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

void ContactForces::AddConesTo(QpBuilder* qp) const {
  for (Eigen::Index first = 0; first < size_; first += 3) {
    InequalityRows rows = qp->AddInequalities(pyramid_.rows());
    rows.C.middleCols<3>(num_velocities_ + first) = pyramid_;
    rows.upper.setZero();
  }
}

}  // namespace sidestep::wbc
