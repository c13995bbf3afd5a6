// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/start_pose.h"

#include <Eigen/QR>
#include <cmath>

#include "models/import/bent_knee.h"
#include "models/import/hanging_arm.h"
#include "models/import/joint_ranges.h"

namespace sidestep::importer {
namespace {

constexpr int kMaxIterations = 100;
constexpr double kSolved = 1e-6;      // m and rad
constexpr double kConverged = 1e-12;  // likewise
constexpr double kMostStep = 0.3;     // rad or m an iteration
constexpr double kDamping = 1e-8;     // of the Jacobian's normal matrix, whose entries are near 1
// The shares of a stretched leg that are tried, the one of the shipped robots first.
constexpr std::array<double, 6> kStretches{0.93, 0.95, 0.9, 0.97, 0.86, 0.8};
constexpr double kMostWidth = 0.3;  // of the legs' length: a walk wider than that sways too much
constexpr std::array<double, 5> kWidths{1.0, 1.15, 0.9, 1.3, 1.5};  // over the one at zero

constexpr int kMostUnknowns = 15;  // 12 joints, 3 of the root's place

using Residual = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostUnknowns, 1>;
using Jacobian =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostUnknowns, kMostUnknowns>;

Eigen::Vector3d RotationVector(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

/// Links at whose origins the legs end: the feet's, or the points on which they stand.
std::array<int, 2> AnklesOf(const BodyPlan& plan, const StartPoseTask& task) {
  if (plan.stands_on_points()) return task.sole_frames;
  return {plan.legs[0].end, plan.legs[1].end};
}

class PoseSolver {
 public:
  PoseSolver(const SourceRobot& robot, const BodyPlan& plan, const StartPoseTask& task)
      : robot_(robot),
        plan_(plan),
        task_(task),
        ankles_(AnklesOf(plan, task)),
        num_joints_(static_cast<int>(2 * plan.legs[0].joints.size())),
        rows_of_foot_(plan.stands_on_points() ? 3 : 6) {
    for (const Limb& leg : plan.legs) {
      unknowns_.insert(unknowns_.end(), leg.joints.begin(), leg.joints.end());
    }
  }

  /// From `start`, whose knees are bent.
  StartPose Solve(const Posture& start, double width_m, double leg_m) const {
    StartPose pose;
    pose.posture = start;
    const Placement first(robot_, start);
    const Eigen::Vector3d middle = 0.5 * (first.X_WL(task_.sole_frames[0]).translation() +
                                          first.X_WL(task_.sole_frames[1]).translation());
    pose.posture.X_WR.translation() -= middle;
    for (int i = 0; i < kMaxIterations; ++i) {
      const Placement placement(robot_, pose.posture);
      const Residual residual = ResidualAt(placement, width_m, leg_m);
      pose.residual = residual.cwiseAbs().maxCoeff();
      if (pose.residual < kConverged) break;
      Step(JacobianAt(placement), residual, &pose.posture);
    }
    pose.is_found = pose.residual < kSolved;
    pose.step_width_m = width_m;
    return pose;
  }

 private:
  const SourceJoint& Joint(int joint) const {
    return robot_.joints[static_cast<std::size_t>(joint)];
  }

  Residual ResidualAt(const Placement& placement, double width_m, double leg_m) const {
    Residual residual = Residual::Zero(num_joints_ + 3);
    double stretched_m = 0.0;
    for (int side = 0; side < 2; ++side) {
      const auto s = static_cast<std::size_t>(side);
      const Eigen::Isometry3d& X_WS = placement.X_WL(task_.sole_frames[s]);
      const Eigen::Vector3d wanted(0.0, side == 0 ? 0.5 * width_m : -0.5 * width_m,
                                   task_.sole_heights_m[s]);
      residual.segment<3>(rows_of_foot_ * side) = X_WS.translation() - wanted;
      if (rows_of_foot_ > 3) {
        residual.segment<3>(rows_of_foot_ * side + 3) = RotationVector(X_WS.linear());
      }
      stretched_m += 0.5 * HipToAnkle(placement, s).norm();
    }
    residual.segment<2>(num_joints_) = placement.com_W().head<2>();
    residual[num_joints_ + 2] = stretched_m - leg_m;
    return residual;
  }

  Jacobian JacobianAt(const Placement& placement) const {
    Jacobian J = Jacobian::Zero(num_joints_ + 3, num_joints_ + 3);
    for (int k = 0; k < num_joints_; ++k) {
      const int joint = unknowns_[static_cast<std::size_t>(k)];
      for (int side = 0; side < 2; ++side) {
        const auto s = static_cast<std::size_t>(side);
        J.block(rows_of_foot_ * side, k, rows_of_foot_, 1) =
            placement.Twist(joint, task_.sole_frames[s]).head(rows_of_foot_);
        const Eigen::Vector3d along = HipToAnkle(placement, s).normalized();
        const int hip = Joint(plan_.legs[s].joints.front()).child;
        J(num_joints_ + 2, k) += 0.5 * along.dot(placement.Twist(joint, ankles_[s]).head<3>() -
                                                 placement.Twist(joint, hip).head<3>());
      }
      J.block<2, 1>(num_joints_, k) = placement.ComVelocity(joint).head<2>();
    }
    for (int side = 0; side < 2; ++side) {
      J.block<3, 3>(rows_of_foot_ * side, num_joints_).setIdentity();
    }
    J.block<2, 2>(num_joints_, num_joints_).setIdentity();
    return J;
  }

  void Step(const Jacobian& J, const Residual& residual, Posture* posture) const {
    const Jacobian normal = J.transpose() * J + kDamping * Jacobian::Identity(J.rows(), J.cols());
    Residual step = normal.ldlt().solve(-J.transpose() * residual);
    step *= std::min(1.0, kMostStep / std::max(1e-300, step.cwiseAbs().maxCoeff()));
    for (int k = 0; k < num_joints_; ++k) {
      const int joint = unknowns_[static_cast<std::size_t>(k)];
      posture->q[joint] = Within(Joint(joint), posture->q[joint] + step[k]);
    }
    posture->X_WR.translation() += step.tail<3>();
  }

  Eigen::Vector3d HipToAnkle(const Placement& placement, std::size_t side) const {
    return placement.X_WL(ankles_[side]).translation() -
           placement.X_WJ(plan_.legs[side].joints.front()).translation();
  }

  const SourceRobot& robot_;
  const BodyPlan& plan_;
  const StartPoseTask& task_;
  std::array<int, 2> ankles_;
  int num_joints_;    // of both legs
  int rows_of_foot_;  // place, and attitude of a sole
  std::vector<int> unknowns_;
};

/// The soles' distance at zero, where the legs are as their maker drew them.
double WidthAtZero(const SourceRobot& robot, const BodyPlan& plan, const StartPoseTask& task) {
  Posture zero = ZeroPosture(robot);
  zero.X_WR.linear() =
      Eigen::AngleAxisd(-plan.facing_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Placement placement(robot, zero);
  return placement.X_WL(task.sole_frames[0]).translation().y() -
         placement.X_WL(task.sole_frames[1]).translation().y();
}

void FillFigures(const SourceRobot& robot, const BodyPlan& plan, StartPose* pose) {
  pose->com_height_m = Placement(robot, pose->posture).com_W().z();
  pose->least_margin_rad = 1e300;
  for (const Limb& leg : plan.legs) {
    for (const int index : leg.joints) {
      const SourceJoint& joint = robot.joints[static_cast<std::size_t>(index)];
      const double q = pose->posture.q[index];
      const double margin = std::min(q - LowerEnd(joint), UpperEnd(joint) - q);
      if (margin >= pose->least_margin_rad) continue;
      pose->least_margin_rad = margin;
      pose->tightest_joint = joint.name;
    }
  }
}

}  // namespace

StartPose FindStartPose(const SourceRobot& robot, const BodyPlan& plan, const StartPoseTask& task) {
  Posture upright = ZeroPosture(robot);
  upright.X_WR.linear() =
      Eigen::AngleAxisd(-plan.facing_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (const int joint : plan.Actuated()) {
    upright.q[joint] = Within(robot.joints[static_cast<std::size_t>(joint)], 0.0);
  }
  for (const Limb& arm : plan.arms) HangArm(robot, arm, task.arm_spread_rad, &upright);
  const PoseSolver solver(robot, plan, task);
  const double natural_m = WidthAtZero(robot, plan, task);
  const std::array<int, 2> ankles = AnklesOf(plan, task);
  StartPose best;
  best.residual = 1e300;
  for (const double stretch : kStretches) {
    Posture bent = upright;
    double leg_m = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
      leg_m += 0.5 * BendKnee(robot, plan.legs[side], ankles[side], stretch, &bent);
    }
    for (const double width : kWidths) {
      const double width_m =
          std::max(std::min(natural_m, kMostWidth * leg_m) * width, task.least_width_m);
      StartPose pose = solver.Solve(bent, width_m, stretch * leg_m);
      if (pose.residual >= best.residual) continue;
      best = pose;
      best.leg_length_m = leg_m;
      best.stretch = stretch;
      if (best.is_found) break;
    }
    if (best.is_found) break;
  }
  FillFigures(robot, plan, &best);
  return best;
}

}  // namespace sidestep::importer
