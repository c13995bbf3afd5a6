// SPDX-License-Identifier: BSD-3-Clause
// G1 and XBot-L through URDF, MJCF and MuJoCo against what their makers' URDFs add up to.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <ostream>
#include <string>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"

namespace sidestep::public_humanoids_test {
namespace {

/// The whole robot with all joints at zero, in the axes of its base: sums over the links of the
/// public URDF, taken once by a script that shares nothing with this program.
struct PublicFigures {
  std::string robot;
  int num_joints;
  double mass_kg;
  Eigen::Vector3d com_m;                     // from the base
  Eigen::Matrix<double, 6, 1> inertia_kgm2;  // about the CoM: xx, xy, xz, yy, yz, zz
};

void PrintTo(const PublicFigures& figures, std::ostream* out) { *out << figures.robot; }

const PublicFigures kG1{
    "g1",
    23,
    33.341142020,
    {0.02033208, 0.00008226, -0.08866594},
    {3.694816, 0.000092, -0.018778, 3.421389, -0.000873, 0.469595},
};

// The source rounds quarters of a turn to four digits: 4e-6 of a radian, 6e-7 m of the CoM.
const PublicFigures kXbotL{
    "xbot_l",
    12,
    53.036263703,
    {0.01236085, -0.00020827, -0.11343907},
    {6.075951, -0.000229, 0.416243, 5.227667, -0.004133, 1.218637},
};

constexpr double kComTolerance_m = 1e-6;
constexpr double kInertiaTolerance_kgm2 = 2e-5;

class PublicHumanoidTest : public testing::TestWithParam<PublicFigures> {
 protected:
  PublicHumanoidTest()
      : robot_(ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models" /
                                    GetParam().robot / "robot.yaml")),
        model_(CompileMjcf(robot_.model->drawn_mjcf, "", robot_.model->file)),
        data_(MakeData(*model_)) {
    mju_zero(data_->qpos, model_->nq);
    data_->qpos[3] = 1.0;  // the base level and at the origin
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
  }

  Eigen::Vector3d Com() const { return Eigen::Map<const Eigen::Vector3d>(data_->subtree_com); }

  Eigen::Matrix3d InertiaAboutCom() const {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    Eigen::Matrix3d sum_kgm2 = Eigen::Matrix3d::Zero();
    for (int body = 1; body < model_->nbody; ++body) {
      const Eigen::Matrix3d R_WI = Eigen::Map<const RowMajor>(data_->ximat + 9 * body);
      const Eigen::Map<const Eigen::Vector3d> principal(model_->body_inertia + 3 * body);
      const Eigen::Vector3d arm_m =
          Eigen::Map<const Eigen::Vector3d>(data_->xipos + 3 * body) - Com();
      sum_kgm2 += R_WI * principal.asDiagonal() * R_WI.transpose() +
                  model_->body_mass[body] * (arm_m.squaredNorm() * Eigen::Matrix3d::Identity() -
                                             arm_m * arm_m.transpose());
    }
    return sum_kgm2;
  }

  const RobotDescription robot_;
  const MjModelPtr model_;
  const MjDataPtr data_;
};

TEST_P(PublicHumanoidTest, WeighsWhatItsMakersFiguresAddUpTo) {
  EXPECT_NEAR(mj_getTotalmass(model_.get()), GetParam().mass_kg, 1e-6);
  EXPECT_EQ(robot_.joints.size(), static_cast<std::size_t>(GetParam().num_joints));
}

TEST_P(PublicHumanoidTest, HasTheirComAndInertiaWhereJointsAreAtZero) {
  EXPECT_LT((Com() - GetParam().com_m).norm(), kComTolerance_m) << Com().transpose();
  const auto& I = GetParam().inertia_kgm2;
  Eigen::Matrix3d expected_kgm2;
  expected_kgm2 << I[0], I[1], I[2], I[1], I[3], I[4], I[2], I[4], I[5];
  EXPECT_LT((InertiaAboutCom() - expected_kgm2).cwiseAbs().maxCoeff(), kInertiaTolerance_kgm2)
      << InertiaAboutCom();
}

INSTANTIATE_TEST_SUITE_P(Shipped, PublicHumanoidTest, testing::Values(kG1, kXbotL),
                         [](const auto& figures) { return figures.param.robot; });

}  // namespace
}  // namespace sidestep::public_humanoids_test
