// SPDX-License-Identifier: BSD-3-Clause
// Against where MuJoCo's own kinematics puts the base, and numbers by hand.
#include "models/mjcf/base_joints.h"

#include <gtest/gtest.h>

#include <numbers>

#include "models/mjcf/mjcf.h"
#include "models/mjcf/quaternion.h"
#include "tests/support/crooked_robot.h"
#include "tests/support/planar_robot.h"

namespace sidestep::base_joints_test {
namespace {

constexpr double kRounding = 1e-14;

/// A base in a model of its own.
struct Base {
  explicit Base(const std::string& mjcf, const char* body = "base")
      : model(CompileMjcf(mjcf, "", "toy.xml")),
        data(MakeData(*model)),
        joints(*model, RequireId(*model, mjOBJ_BODY, body), "toy.xml") {}

  /// Where MuJoCo has the body's origin, and how it is turned.
  BaseMotion InMuJoCo() {
    mj_kinematics(model.get(), data.get());
    mj_comPos(model.get(), data.get());
    mj_comVel(model.get(), data.get());
    const int body = RequireId(*model, mjOBJ_BODY, "base");
    mjtNum twist[6];  // [angular; linear]
    mj_objectVelocity(model.get(), data.get(), mjOBJ_XBODY, body, twist, 0);
    const Eigen::Quaterniond q_WB = FromMuJoCo(data->xquat + 4 * body);
    return {Eigen::Map<const Eigen::Vector3d>(data->xpos + 3 * body), q_WB,
            Eigen::Map<const Eigen::Vector3d>(twist + 3),
            q_WB.conjugate() * Eigen::Map<const Eigen::Vector3d>(twist)};
  }

  MjModelPtr model;
  MjDataPtr data;
  BaseJoints joints;
};

void ExpectSame(const BaseMotion& a, const BaseMotion& b) {
  EXPECT_LT((a.p_WB - b.p_WB).norm(), kRounding);
  EXPECT_LT(a.q_WB.angularDistance(b.q_WB), 1e-7) << "of an angle: the root of the rounding";
  EXPECT_LT((a.v_WB - b.v_WB).norm(), kRounding);
  EXPECT_LT((a.w_WB_B - b.w_WB_B).norm(), kRounding);
}

Eigen::Quaterniond Pitched(double angle_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()));
}

TEST(BaseJointsTest, FreeBaseIsWhereItWasWrittenTo) {
  Base base(kCrookedMjcf);
  const BaseMotion motion{{0.3, -0.2, 1.1},
                          Eigen::Quaterniond(0.7, 0.3, -0.4, 0.5).normalized(),
                          {0.4, -0.7, 0.2},
                          {1.1, -0.6, 0.9}};
  base.joints.Write(motion, base.data.get());
  ExpectSame(base.InMuJoCo(), motion);
  ExpectSame(base.joints.Read(*base.data), motion);
  EXPECT_EQ(base.joints.freedom(), BaseFreedom::kFree);
  EXPECT_EQ(base.joints.num_velocities(), 6);
}

TEST(BaseJointsTest, SagittalBaseIsWhereItWasWrittenToThoughTheModelsReferenceIsElsewhere) {
  Base base(kPlanarMjcf);
  const BaseMotion motion{{0.7, 0.0, 1.1}, Pitched(-0.4), {0.4, 0.0, 0.2}, {0.0, -0.6, 0.0}};
  base.joints.Write(motion, base.data.get());
  ExpectSame(base.InMuJoCo(), motion);
  ExpectSame(base.joints.Read(*base.data), motion);
  EXPECT_NEAR(base.data->qpos[0], 0.4, kRounding) << "from the body's 0.3";
  EXPECT_EQ(base.joints.freedom(), BaseFreedom::kSagittal);
  EXPECT_EQ(base.joints.num_velocities(), 3);
}

TEST(BaseJointsTest, VelocitiesAreTheComponentsThatAxesTell) {
  for (const char* mjcf : {kCrookedMjcf, kPlanarMjcf}) {
    Base base(mjcf);
    base.joints.Write({{0.0, 0.0, 1.0}, Pitched(0.3), {}, {}}, base.data.get());
    for (int i = 0; i < base.joints.num_velocities(); ++i) {
      mju_zero(base.data->qvel, base.model->nv);
      base.data->qvel[i] = 1.0;
      const BaseMotion moving = base.InMuJoCo();
      Vector6 twist;
      twist << moving.v_WB, moving.w_WB_B;
      const Eigen::VectorXd nu = Eigen::VectorXd::Unit(base.model->nv, i);
      EXPECT_LT((twist - base.joints.Spread(nu)).norm(), kRounding) << mjcf << i;
    }
  }
}

TEST(BaseJointsTest, LinearAndAngularAxesTogetherAreTheAxes) {
  for (const char* mjcf : {kCrookedMjcf, kPlanarMjcf}) {
    const Base base(mjcf);
    std::vector<int> axes;
    for (const int axis : base.joints.linear_axes()) axes.push_back(axis);
    for (const int axis : base.joints.angular_axes()) axes.push_back(3 + axis);
    EXPECT_EQ(axes, std::vector<int>(base.joints.axes().begin(), base.joints.axes().end()));
  }
}

TEST(BaseJointsTest, FreeBaseCanDoEverything) {
  const Base base(kCrookedMjcf);
  const BaseMotion motion{{1, 2, 3}, Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5), {4, 5, 6}, {7, 8, 9}};
  BaseMotion projected = motion;
  base.joints.Project(&projected);
  EXPECT_EQ(projected.p_WB, motion.p_WB);
  EXPECT_EQ(projected.q_WB.coeffs(), motion.q_WB.coeffs());
  EXPECT_EQ(projected.w_WB_B, motion.w_WB_B);
  Eigen::Vector3d force(1, 2, 3), moment(4, 5, 6);
  base.joints.ProjectWrench(&force, &moment);
  EXPECT_EQ(force, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(moment, Eigen::Vector3d(4, 5, 6));
}

TEST(BaseJointsTest, SagittalBaseKeepsWhatIsInItsPlane) {
  const Base base(kPlanarMjcf);
  BaseMotion motion{{1, 2, 3}, Pitched(0.4), {4, 5, 6}, {7, 8, 9}};
  const Eigen::AngleAxisd yaw(0.01, Eigen::Vector3d::UnitZ()),
      roll(-0.02, Eigen::Vector3d::UnitX());
  motion.q_WB = yaw * motion.q_WB * roll;
  base.joints.Project(&motion);
  EXPECT_EQ(motion.p_WB, Eigen::Vector3d(1, 0, 3));
  EXPECT_EQ(motion.v_WB, Eigen::Vector3d(4, 0, 6));
  EXPECT_EQ(motion.w_WB_B, Eigen::Vector3d(0, 8, 0));
  EXPECT_EQ(motion.q_WB.x(), 0.0);
  EXPECT_EQ(motion.q_WB.z(), 0.0);
  EXPECT_NEAR(motion.q_WB.angularDistance(Pitched(0.4)), 0.0, 3e-4) << "of the turns' product";
  EXPECT_NEAR(motion.q_WB.norm(), 1.0, kRounding);

  CentroidalMotion centroidal{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  base.joints.Project(&centroidal);
  EXPECT_EQ(centroidal.p_WC, Eigen::Vector3d(1, 0, 3));
  EXPECT_EQ(centroidal.v_WC, Eigen::Vector3d(4, 0, 6));
  EXPECT_EQ(centroidal.angular_momentum, Eigen::Vector3d(0, 8, 0));
  Eigen::Vector3d force(1, 2, 3), moment(4, 5, 6);
  base.joints.ProjectWrench(&force, &moment);
  EXPECT_EQ(force, Eigen::Vector3d(1, 0, 3));
  EXPECT_EQ(moment, Eigen::Vector3d(0, 5, 0));
}

TEST(BaseJointsTest, AWholeTurnDoesNotTurnTheBaseOver) {
  Base base(kPlanarMjcf);
  BaseMotion motion;
  motion.q_WB = Pitched(std::numbers::pi + 0.3);
  base.joints.Write(motion, base.data.get());
  EXPECT_LT(base.joints.Read(*base.data).q_WB.angularDistance(motion.q_WB), 1e-7);
  motion.q_WB.coeffs() *= -1.0;  // the same attitude
  base.joints.Write(motion, base.data.get());
  EXPECT_LT(base.joints.Read(*base.data).q_WB.angularDistance(motion.q_WB), 1e-7);
}

/// Why the planar robot's base is none after one edit.
std::string FaultOf(const std::string& from, const std::string& to) {
  try {
    const Base base(Edit(kPlanarMjcf, from, to));
  } catch (const ConfigError& thrown) {
    const std::string start = "toy.xml: error: 'base' can't be the base: ";
    const std::string text = thrown.what();
    EXPECT_EQ(text.substr(0, start.size()), start);
    return text.substr(start.size());
  }
  return "no fault";
}

TEST(BaseJointsTest, OtherBasesAreErrorsThatNameTheJoint) {
  const std::string order = " (1 0 0, 0 0 1 and the hinge, in this order)";
  const std::string along_x = "\"base_x\" type=\"slide\" axis=\"1 0 0\"";
  const std::string pitch = "\"base_pitch\" type=\"hinge\" axis=\"0 1 0\"";
  const std::string body = "<body name=\"base\" pos=\"0.3 0 0.9\"";
  for (const char* axis : {"0 1 0", "-1 0 0", "0 0 1"}) {
    EXPECT_EQ(FaultOf(along_x, "\"base_x\" type=\"slide\" axis=\"" + std::string(axis) + "\""),
              "joint 'base_x' of a base that moves in a plane must be a slide along 1 0 0" + order);
  }
  EXPECT_EQ(FaultOf("\"base_z\" type=\"slide\"", "\"base_z\" type=\"hinge\""),
            "joint 'base_z' of a base that moves in a plane must be a slide along 0 0 1" + order);
  EXPECT_EQ(FaultOf(pitch, pitch + " pos=\"0 0 0.1\""),
            "joint 'base_pitch' must go through the body's origin")
      << "the origin would move as it turns";
  EXPECT_EQ(FaultOf("\"base_z\" type=\"slide\" axis=\"0 0 1\"",
                    "\"base_z\" type=\"slide\" axis=\"0 0 1\" ref=\"0.3\""),
            "joint 'base_z' must have no ref");
  EXPECT_EQ(FaultOf(body, "<body name=\"base\" pos=\"0.3 0.1 0.9\""),
            "the body must be at y = 0 in the MJCF");
  EXPECT_EQ(FaultOf(body, body + " euler=\"0 0.1 0\""),
            "the body must not be turned where the MJCF has it");
  EXPECT_EQ(FaultOf("      <joint name=" + pitch + "/>\n", ""),
            "it has 2 joints, not a free one or the three of a plane");
}

TEST(BaseJointsTest, NothingMayHinderABase) {
  const std::string along_x = "\"base_x\" type=\"slide\" axis=\"1 0 0\"";
  const auto fault_with = [&](const std::string& attribute) {
    return FaultOf(along_x, along_x + " " + attribute);
  };
  const std::string start = "joint 'base_x' has ", end = ", and nothing may hinder a base";
  EXPECT_EQ(fault_with("range=\"-0.1 0.3\""), start + "a range" + end);
  EXPECT_EQ(fault_with("stiffness=\"5\""), start + "a stiffness" + end);
  EXPECT_EQ(fault_with("damping=\"5\""), start + "a damping" + end);
  EXPECT_EQ(fault_with("frictionloss=\"5\""), start + "a frictionloss" + end);
  EXPECT_EQ(fault_with("armature=\"5\""), start + "an armature" + end);
  EXPECT_EQ(FaultOf("<motor name=\"hip_l\"", "<motor joint=\"base_x\"/><motor name=\"hip_l\""),
            start + "an actuator" + end);
  const MjModelPtr model = CompileMjcf(
      Edit(kCrookedMjcf, "<freejoint/>", "<joint type=\"free\" damping=\"5\"/>"), "", "toy.xml");
  EXPECT_EQ(BaseFault(*model, RequireId(*model, mjOBJ_BODY, "base")),
            "joint number 1 has a damping, and nothing may hinder a base");
}

TEST(BaseJointsTest, LegsAreNoBases) {
  const Base base(kPlanarMjcf);
  EXPECT_FALSE(BaseFreedomOf(*base.model, RequireId(*base.model, mjOBJ_BODY, "leg_r")));
  EXPECT_FALSE(BaseFreedomOf(*base.model, 0)) << "the world";
}

}  // namespace
}  // namespace sidestep::base_joints_test
