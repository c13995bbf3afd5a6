// SPDX-License-Identifier: BSD-3-Clause
// iCub3 through URDF, urdfdom, MJCF and MuJoCo against the figures that it was made from.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"

namespace sidestep::icub3_figures_test {
namespace {

const std::filesystem::path kSource{SIDESTEP_SOURCE_DIR};

nlohmann::json ReadJson(const std::string& name) {
  return nlohmann::json::parse(ReadTextFile(kSource / "tests/data/icub3" / name));
}

Eigen::Vector3d Vector(const nlohmann::json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

/// The robot alone, its base at the world's origin.
class Icub3FiguresTest : public testing::Test {
 protected:
  Icub3FiguresTest()
      : robot_(ReadRobotDescription(kSource / "models/icub3/robot.yaml")),
        model_(CompileMjcf(robot_.model->drawn_mjcf, "", robot_.model->file)),
        data_(MakeData(*model_)) {
    mju_zero(data_->qpos, model_->nq);
    data_->qpos[3] = 1.0;
    Update();
  }

  void Update() {
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
  }

  Eigen::Vector3d Com() const {
    return Eigen::Map<const Eigen::Vector3d>(data_->subtree_com + 3 * Id(mjOBJ_BODY, robot_.base));
  }

  int Id(mjtObj type, const std::string& name) const { return RequireId(*model_, type, name); }

  const RobotDescription robot_;
  const MjModelPtr model_;
  const MjDataPtr data_;
};

/// Mass, CoM and inertia (about the CoM) of all that is welded to a body, in that body's frame.
struct Welded {
  double mass_kg{0.0};
  Eigen::Vector3d com_m{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d inertia_kgm2{Eigen::Matrix3d::Zero()};
};

Welded Recombine(const mjModel& model, const mjData& data, int body) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Welded sum;
  const Eigen::Map<const Eigen::Vector3d> p_WB(data.xpos + 3 * body);
  const Eigen::Matrix3d R_WB = Eigen::Map<const RowMajor>(data.xmat + 9 * body);
  for (int pass = 0; pass < 2; ++pass) {  // first the CoM, then the inertia about it
    for (int part = 1; part < model.nbody; ++part) {
      if (model.body_weldid[part] != body) continue;
      const double mass_kg = model.body_mass[part];
      const Eigen::Vector3d com_m =
          R_WB.transpose() * (Eigen::Map<const Eigen::Vector3d>(data.xipos + 3 * part) - p_WB);
      if (pass == 0) {
        sum.com_m = (sum.mass_kg * sum.com_m + mass_kg * com_m) / (sum.mass_kg + mass_kg);
        sum.mass_kg += mass_kg;
        continue;
      }
      const Eigen::Matrix3d R_BI =
          R_WB.transpose() * Eigen::Map<const RowMajor>(data.ximat + 9 * part);
      const Eigen::Map<const Eigen::Vector3d> principal(model.body_inertia + 3 * part);
      const Eigen::Vector3d arm_m = com_m - sum.com_m;
      sum.inertia_kgm2 +=
          R_BI * principal.asDiagonal() * R_BI.transpose() +
          mass_kg * (arm_m.squaredNorm() * Eigen::Matrix3d::Identity() - arm_m * arm_m.transpose());
    }
  }
  return sum;
}

TEST_F(Icub3FiguresTest, EveryLinkKeepsItsMassComAndInertiaThoughSensorsSplitIt) {
  const nlohmann::json figures = ReadJson("bodies.json");
  ASSERT_EQ(figures.at("bodies").size(), 24U);
  for (const nlohmann::json& body : figures.at("bodies")) {
    const auto name = body.at("name").get<std::string>();
    const Welded welded = Recombine(*model_, *data_, Id(mjOBJ_BODY, name));
    EXPECT_NEAR(welded.mass_kg, body.at("mass_kg").get<double>(), 1e-12) << name;
    EXPECT_LT((welded.com_m - Vector(body.at("com_m"))).norm(), 1e-12) << name;
    const auto I = body.at("inertia_kgm2").get<std::vector<double>>();
    Eigen::Matrix3d inertia_kgm2;
    inertia_kgm2 << I[0], I[1], I[2], I[1], I[3], I[4], I[2], I[4], I[5];
    // MuJoCo finds principal axes to 3e-7 of the moments, with and without a split.
    EXPECT_LT((welded.inertia_kgm2 - inertia_kgm2).norm(), 1e-6 * inertia_kgm2.trace()) << name;
  }
}

TEST_F(Icub3FiguresTest, SensorsSplitShouldersAndFeet) {
  EXPECT_NEAR(model_->body_mass[Id(mjOBJ_BODY, "l_arm_ft_distal")], 0.2625, 1e-12);
  EXPECT_NEAR(model_->body_mass[Id(mjOBJ_BODY, "r_foot_rear_ft_distal")], 0.17874, 1e-12);
  const int upper_arm = Id(mjOBJ_BODY, "l_upper_arm");
  EXPECT_EQ(model_->body_parentid[upper_arm], Id(mjOBJ_BODY, "l_arm_ft_distal"));
}

TEST_F(Icub3FiguresTest, TheWholeHasItsMassAndCom) {
  const nlohmann::json figures = ReadJson("bodies.json");
  EXPECT_NEAR(mj_getTotalmass(model_.get()), 52.410076, 1e-6);
  EXPECT_LT((Com() - Eigen::Vector3d(0.006635381, -0.000001804, -0.047111040)).norm(), 1e-8);
  EXPECT_LT((Com() - Vector(figures.at("com_zero_config_m"))).norm(), 1e-9);
}

TEST_F(Icub3FiguresTest, ForwardKinematicsAreThoseOfTheOriginalLinks) {
  const nlohmann::json figures = ReadJson("fk_cases.json");
  const auto joints = figures.at("joints").get<std::vector<std::string>>();
  ASSERT_EQ(figures.at("cases").size(), 5U);
  for (const nlohmann::json& fk : figures.at("cases")) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      data_->qpos[model_->jnt_qposadr[Id(mjOBJ_JOINT, joints[i])]] =
          fk.at("joint_position_rad").at(i).get<double>();
    }
    Update();
    EXPECT_LT((Com() - Vector(fk.at("com_m"))).norm(), 1e-6);
    EXPECT_EQ(fk.at("frames").size(), 5U);
    for (const auto& [frame, pose] : fk.at("frames").items()) {
      const int site = Id(mjOBJ_SITE, frame);
      const Eigen::Map<const Eigen::Vector3d> position(data_->site_xpos + 3 * site);
      EXPECT_LT((position - Vector(pose.at("xyz_m"))).norm(), 1e-6) << frame;
      for (int row = 0; row < 3; ++row) {
        const Eigen::Map<const Eigen::Vector3d> mine(data_->site_xmat + 9 * site + 3 * row);
        const Eigen::Vector3d theirs = Vector(pose.at("rotation").at(static_cast<size_t>(row)));
        EXPECT_LT((mine - theirs).cwiseAbs().maxCoeff(), 1e-6) << frame << " row " << row;
      }
    }
  }
}

TEST_F(Icub3FiguresTest, ActuatorsAreInTheControllersOrder) {
  const auto joints = ReadJson("fk_cases.json").at("joints").get<std::vector<std::string>>();
  ASSERT_EQ(static_cast<std::size_t>(model_->nu), joints.size());
  ASSERT_EQ(robot_.joints.size(), joints.size());
  for (int i = 0; i < model_->nu; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_EQ(mj_id2name(model_.get(), mjOBJ_JOINT, model_->actuator_trnid[2 * i]), joints[at]);
    EXPECT_EQ(robot_.joints[at].name, joints[at]);
  }
}

TEST_F(Icub3FiguresTest, MotorsAndServosHaveTheirFigures) {
  const int knee = Id(mjOBJ_ACTUATOR, "l_knee");
  EXPECT_EQ(model_->actuator_ctrlrange[2 * knee], -110.0);
  EXPECT_EQ(model_->actuator_ctrlrange[2 * knee + 1], 110.0);
  EXPECT_TRUE(model_->actuator_ctrllimited[knee]);
  const JointDescription& servo = robot_.joints[static_cast<std::size_t>(knee)];
  EXPECT_GT(servo.servo_stiffness_Nm_per_rad, 0.0);
  EXPECT_EQ(servo.velocity_limit_radps, 4.189);
  const int joint = Id(mjOBJ_JOINT, "l_knee");
  EXPECT_NEAR(model_->jnt_range[2 * joint], -1.2217304764, 1e-9);  // -70 deg
  EXPECT_NEAR(model_->jnt_range[2 * joint + 1], 0.0872664626, 1e-9);
  EXPECT_TRUE(model_->jnt_limited[joint]);
}

}  // namespace
}  // namespace sidestep::icub3_figures_test
