// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// contact_forces: what the ground may do to the feet: forces at the vertices of the soles.
//
//   generalised force   sum_V J_V' f_V,     J_V = J_F - [R_WF p_FV]x J_F,rot
//   wrench about F      [sum f_V; sum (R_WF p_FV) x f_V]
//   f_V within its friction pyramid, about the vertical: the floor is level
//
// A foot stands from when the plan has it on the ground and the sensor feels it there until the
// plan lifts it: one that bears little for a while, and is not felt, does not begin to swing. Not
// felt it may bear no more than kUnfeltShare of the weight, for it may be in the air: with that it
// finds the ground, and the CoM is not built on it. The less a foot bears, by plan and by feel, the
// less it is held in its place: one about to lift does not pull the CoM down by a leg that is at
// its length.
//
// As variables of a QP the forces of the feet in contact follow the nv accelerations, three a
// vertex, foot by foot.

#include <Eigen/Core>
#include <vector>

#include "controller/model/rigid_body.h"
#include "controller/types/control_tick.h"
#include "controller/wbc/qp_builder.h"

namespace sidestep::wbc {

inline constexpr double kUnfeltShare = 0.1;  ///< Twice what a contact's threshold should be.
inline constexpr double kLeastHold = 1e-5;   ///< Of the weight of a standing foot's task.

/// [force (N); moment about F (N m)] in W of forces at the vertices of a sole. `vertices_m` is
/// 3 x n_v, in F; `vertex_force_N` is 3 x n_v, in W.
Eigen::Matrix<double, 6, 1> FootWrench(const Eigen::Matrix3d& R_WF,
                                       const Eigen::Matrix3Xd& vertices_m,
                                       const Eigen::Matrix3Xd& vertex_force_N);

class ContactForces {
 public:
  /// Of a robot of `num_velocities` velocities; `friction` is the pyramids' coefficient.
  ContactForces(const RobotDescription& robot, int num_velocities, double friction);

  /// Takes the feet that support. Does not allocate.
  void Update(const RobotState& state, const RigidBody& body, const std::vector<FootTarget>& feet);

  /// Whether `foot` stands, as of the last Update().
  bool stands(std::size_t foot) const { return feet_[foot].stands; }

  /// How firmly a standing `foot` is to be held, as of the last Update(): 1 if it bears
  /// kUnfeltShare of the weight or more, planned or felt; less in proportion; at least kLeastHold.
  double hold(std::size_t foot) const { return feet_[foot].hold; }

  Eigen::Index size() const { return size_; }  ///< Variables: 3 a vertex in contact.
  Eigen::Index max_size() const { return jacobian_.rows(); }
  Eigen::Index max_rows() const {
    return max_size() / 3 * pyramid_.rows() + static_cast<Eigen::Index>(feet_.size());
  }

  /// size() x nv: the J_V of the vertices in contact, one below the other.
  auto jacobian() const { return jacobian_.topRows(size_); }

  /// Weighs the deviation from the plan's vertex forces, per N^2.
  void AddPlanTo(double weight, QpBuilder* qp) const;

  /// Weighs how far the forces' moment about p_WC (m, in W) is from `moment_W` (N m), per (N m)^2.
  void AddMomentTo(const Eigen::Vector3d& p_WC, const Eigen::Vector3d& moment_W, double weight,
                   QpBuilder* qp);

  /// The pyramids, and what a foot that is not felt may bear of the robot's `weight_N`, as rows of
  /// the inequalities.
  void AddLimitsTo(double weight_N, QpBuilder* qp) const;

 private:
  struct Foot {
    Eigen::Matrix3Xd vertices_m;
    bool stands{false};
    bool is_felt{false};
    double hold{1.0};
    Eigen::Index first{0};  ///< Of its variables, if it stands.
  };

  std::vector<Foot> feet_;
  Eigen::Matrix<double, 4, 3> pyramid_;
  Eigen::Index num_velocities_;
  Eigen::Index size_{0};
  Eigen::MatrixXd jacobian_;   // of all vertices; the first size_ rows are in use
  Eigen::VectorXd planned_N_;  // likewise
  Eigen::Matrix3Xd p_WV_;      // likewise, a column a vertex
  Eigen::MatrixXd moment_;     // 3 x all: of the forces' moment, from force to force
};

}  // namespace sidestep::wbc
