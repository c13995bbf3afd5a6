// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"
#include "models/support/config_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep::urdf_to_mjcf_test {
namespace {

const std::filesystem::path kMini =
    std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/models/mini_urdf";

/// The fixture as its robot.yaml has it converted.
class UrdfToMjcfTest : public testing::Test {
 protected:
  int Id(mjtObj type, const std::string& name) const { return RequireId(*model_, type, name); }
  std::string Parent(const std::string& body) const {
    return mj_id2name(model_.get(), mjOBJ_BODY, model_->body_parentid[Id(mjOBJ_BODY, body)]);
  }
  std::string Carrier(const std::string& site) const {
    return mj_id2name(model_.get(), mjOBJ_BODY, model_->site_bodyid[Id(mjOBJ_SITE, site)]);
  }
  Eigen::Vector3d SitePosition(const std::string& site) const {
    return Eigen::Map<const Eigen::Vector3d>(model_->site_pos + 3 * Id(mjOBJ_SITE, site));
  }
  Eigen::Vector3d GeomSize(const std::string& geom) const {
    return Eigen::Map<const Eigen::Vector3d>(model_->geom_size + 3 * Id(mjOBJ_GEOM, geom));
  }

  const RobotDescription robot_{ReadRobotDescription(kMini / "robot.yaml")};
  const MjModelPtr model_{CompileMjcf(robot_.model->drawn_mjcf, "", robot_.model->file)};
};

TEST_F(UrdfToMjcfTest, TheFirstLinkWithMassFloatsAndLinksAboveItAreItsFrames) {
  EXPECT_EQ(model_->jnt_type[model_->body_jntadr[Id(mjOBJ_BODY, "trunk")]], mjJNT_FREE);
  EXPECT_EQ(Carrier("footprint"), "trunk");
  EXPECT_LT((SitePosition("footprint") - Eigen::Vector3d(0, 0, -0.5)).norm(), 1e-15);
}

TEST_F(UrdfToMjcfTest, FixedLinksWithMassAreWeldedBodiesAndWithoutMassSites) {
  EXPECT_EQ(Parent("foot"), "leg");
  EXPECT_EQ(model_->body_jntnum[Id(mjOBJ_BODY, "foot")], 0);
  EXPECT_EQ(Carrier("sole"), "foot");
  EXPECT_EQ(mj_name2id(model_.get(), mjOBJ_BODY, "sole"), -1);
}

TEST_F(UrdfToMjcfTest, JointsKeepTypeRangeAndDampingAndLockedOnesAreWelds) {
  const int hip = Id(mjOBJ_JOINT, "hip");
  EXPECT_EQ(model_->jnt_type[hip], mjJNT_HINGE);
  EXPECT_EQ(model_->jnt_range[2 * hip], -1.0);
  EXPECT_EQ(model_->jnt_range[2 * hip + 1], 1.5);
  EXPECT_EQ(model_->dof_damping[model_->jnt_dofadr[hip]], 0.5) << "the URDF's";
  EXPECT_EQ(model_->dof_armature[model_->jnt_dofadr[hip]], 0.01);
  const int grip = Id(mjOBJ_JOINT, "grip");
  EXPECT_EQ(model_->jnt_type[grip], mjJNT_SLIDE);
  EXPECT_EQ(model_->dof_damping[model_->jnt_dofadr[grip]], 0.7) << "robot.yaml's";
  EXPECT_FALSE(model_->jnt_limited[Id(mjOBJ_JOINT, "shoulder")]) << "continuous";
  EXPECT_EQ(mj_name2id(model_.get(), mjOBJ_JOINT, "wag"), -1);
  EXPECT_EQ(model_->body_weldid[Id(mjOBJ_BODY, "tail")], Id(mjOBJ_BODY, "trunk"));
}

TEST_F(UrdfToMjcfTest, MotorsComeInTheOrderAndWithinTheLimitsOfRobotYaml) {
  ASSERT_EQ(model_->nu, 3);
  EXPECT_EQ(Id(mjOBJ_ACTUATOR, "shoulder"), 0);
  EXPECT_EQ(Id(mjOBJ_ACTUATOR, "hip"), 1);
  EXPECT_EQ(Id(mjOBJ_ACTUATOR, "grip"), 2);
  EXPECT_EQ(model_->actuator_ctrlrange[3], 30.0) << "the URDF's";
  EXPECT_EQ(model_->actuator_ctrlrange[5], 8.0) << "robot.yaml's";
}

TEST_F(UrdfToMjcfTest, ALongCylinderIsACapsuleAsLongAndAFlatOneACylinder) {
  EXPECT_EQ(model_->geom_type[Id(mjOBJ_GEOM, "leg_collision_0")], mjGEOM_CAPSULE);
  EXPECT_LT((GeomSize("leg_collision_0") - Eigen::Vector3d(0.02, 0.08, 0)).norm(), 1e-15);
  EXPECT_EQ(model_->geom_type[Id(mjOBJ_GEOM, "arm_collision_0")], mjGEOM_CYLINDER);
  EXPECT_LT((GeomSize("arm_collision_0") - Eigen::Vector3d(0.03, 0.01, 0)).norm(), 1e-15);
  EXPECT_LT((GeomSize("foot_collision_0") - Eigen::Vector3d(0.1, 0.05, 0.01)).norm(), 1e-15);
}

TEST_F(UrdfToMjcfTest, CollisionShapesHideWhereThereIsSomethingToLookAt) {
  EXPECT_EQ(model_->geom_group[Id(mjOBJ_GEOM, "trunk_collision_0")], 3);
  EXPECT_EQ(model_->geom_group[Id(mjOBJ_GEOM, "leg_collision_0")], 1);
  for (int geom = 0; geom < model_->ngeom; ++geom) {
    if (mj_id2name(model_.get(), mjOBJ_GEOM, geom) != nullptr) continue;  // named: collides
    EXPECT_EQ(model_->geom_contype[geom], 0);
    EXPECT_EQ(model_->geom_conaffinity[geom], 0);
  }
}

TEST_F(UrdfToMjcfTest, OnlyTheFootsShapesHaveItsContactParameters) {
  EXPECT_EQ(model_->geom_priority[Id(mjOBJ_GEOM, "foot_collision_0")], 1);
  EXPECT_EQ(model_->geom_priority[Id(mjOBJ_GEOM, "leg_collision_0")], 1)
      << "the foot is welded to it";
  EXPECT_EQ(model_->geom_priority[Id(mjOBJ_GEOM, "trunk_collision_0")], 0);
}

TEST_F(UrdfToMjcfTest, TheDistalPartOfASensorIsABodyWithItsJointsShapesAndSite) {
  EXPECT_EQ(Parent("arm_ft_distal"), "arm");
  EXPECT_EQ(Carrier("arm_ft"), "arm_ft_distal");
  EXPECT_EQ(Parent("gripper"), "arm_ft_distal");
  EXPECT_EQ(model_->geom_bodyid[Id(mjOBJ_GEOM, "arm_collision_0")],
            Id(mjOBJ_BODY, "arm_ft_distal"));
  const int rest = Id(mjOBJ_BODY, "arm");
  EXPECT_NEAR(model_->body_mass[rest], 0.1, 1e-15);
  // By hand: first moment 0.4 * (0, 0, -0.1) - 0.3 * (0.01, 0, -0.12), over 0.1 kg.
  const Eigen::Map<const Eigen::Vector3d> com_m(model_->body_ipos + 3 * rest);
  EXPECT_LT((com_m - Eigen::Vector3d(-0.03, 0, -0.04)).norm(), 1e-12);
}

TEST_F(UrdfToMjcfTest, ASensorWithoutDistalPartSitsBetweenItsLinkAndTheParent) {
  EXPECT_EQ(Carrier("foot_ft"), "foot");
  EXPECT_NEAR(mj_getTotalmass(model_.get()), 3.3, 1e-12);
}

TEST_F(UrdfToMjcfTest, SelfCollisionNamesPairsOfShapesWhereverTheyWent) {
  EXPECT_EQ(model_->npair, 2);
}

TEST_F(UrdfToMjcfTest, GroundPairsNameEveryShapeThatCollidesOnce) {
  const auto count = [&](const std::string& text) {
    std::size_t found = 0;
    const std::string& pairs = robot_.model->ground_pairs;
    for (std::size_t at = 0; (at = pairs.find(text, at)) != std::string::npos; ++at) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("<pair class="), 4u);
  EXPECT_EQ(count("geom1=\"floor\""), 4u);
  EXPECT_EQ(count("<pair class=\"foot\" geom1=\"floor\" geom2=\"foot_collision_0\"/>"), 1u);
  EXPECT_EQ(count("<pair class=\"body\" geom1=\"floor\" geom2=\"trunk_collision_0\"/>"), 1u);
}

/// Copies of the fixture's URDF, with one edit.
class UrdfErrorTest : public testing::Test {
 protected:
  std::string ErrorOfEdit(const std::string& from, const std::string& to) const {
    folder_.Write("robot.yaml", ReadConfigText(kMini / "robot.yaml"));
    folder_.Write("mini.urdf", Edit(ReadConfigText(kMini / "mini.urdf"), from, to));
    return folder_.ErrorOf([&] { ReadRobotDescription(folder_.path() / "robot.yaml"); });
  }

  const TempFolder folder_;
};

TEST_F(UrdfErrorTest, AnUntouchedCopyHasNoError) {
  EXPECT_EQ(ErrorOfEdit("<robot name=\"mini\">", "<robot name=\"mini\">"), "no error");
}

TEST_F(UrdfErrorTest, BadXmlIsToldWithItsPlace) {
  EXPECT_EQ(ErrorOfEdit("<link name=\"footprint\"/>", "<link name=\"footprint\">"),
            "mini.urdf:54:1: error: Error reading end tag.");
}

}  // namespace
}  // namespace sidestep::urdf_to_mjcf_test
