// SPDX-License-Identifier: BSD-3-Clause
// What public URDFs hold that is harmless is taken, and told as a notice.
#include "models/urdf_to_mjcf/read_urdf.h"

#include <gtest/gtest.h>

#include "models/support/config_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep::read_urdf_test {
namespace {

using Lines = std::vector<std::string>;

const std::filesystem::path kMini =
    std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/models/mini_urdf";
constexpr char kInertia[] =
    R"(<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>)";

std::string Link(const std::string& name, const std::string& mass) {
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + mass + "\"/>" + kInertia +
         "</inertial></link>";
}

std::string Joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& more = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + more + "</joint>";
}

class ReadUrdfTest : public testing::Test {
 protected:
  UrdfTree Read(const std::string& parts, const std::vector<std::string>& locked = {}) const {
    return ReadUrdf(folder_.Write("a.urdf", "<robot name=\"a\">" + parts + "</robot>"), locked);
  }

  /// The fixture's URDF with one edit.
  UrdfTree ReadEdited(const std::string& from, const std::string& to,
                      const std::vector<std::string>& locked = {}) const {
    const std::string text = Edit(ReadConfigText(kMini / "mini.urdf"), from, to);
    return ReadUrdf(folder_.Write("a.urdf", text), locked);
  }

  Lines NoticesOf(const UrdfTree& tree) const {
    Lines lines;
    for (const std::string& line : tree.notes.notices()) lines.push_back(folder_.Shorten(line));
    return lines;
  }

  const TempFolder folder_;
};

bool HasFrame(const Body& body, const std::string& name, const Eigen::Vector3d& p_BF) {
  for (const Frame& frame : body.frames) {
    if (frame.name == name) return (frame.X_BF.translation() - p_BF).norm() < 1e-12;
  }
  return false;
}

TEST_F(ReadUrdfTest, AUsualUrdfHasNoNotices) {
  EXPECT_EQ(NoticesOf(ReadUrdf(kMini / "mini.urdf", {})), Lines{});
}

TEST_F(ReadUrdfTest, AWorldOnAFloatingJointIsLeftOut) {
  const UrdfTree tree = Read("<link name=\"world\"/>" + Link("pelvis", "3") +
                             Joint("free", "floating", "world", "pelvis"));
  EXPECT_EQ(tree.base.name, "pelvis");
  EXPECT_TRUE(tree.base.frames.empty());
  EXPECT_TRUE(tree.joints.empty());
  EXPECT_EQ(NoticesOf(tree),
            Lines{"a.urdf:1:169: notice: joint 'free' is taken as the base's freedom to float, and "
                  "link 'world' as the world"});
}

TEST_F(ReadUrdfTest, AFloatingJointElsewhereIsRefused) {
  EXPECT_EQ(folder_.ErrorOf([&] {
    Read(Link("pelvis", "3") + Link("ball", "1") + Joint("free", "floating", "pelvis", "ball"));
  }),
            "a.urdf:1:279: error: joint 'free' is neither fixed, revolute, continuous nor "
            "prismatic; list it in locked_joints of robot.yaml, or mend it here");
}

TEST_F(ReadUrdfTest, TheHeaviestLinkOfAMasslessRootIsTheBase) {
  const std::string above = "<origin xyz=\"0 0 0.5\"/>", behind = "<origin xyz=\"-0.1 0 0\"/>";
  const UrdfTree tree =
      Read("<link name=\"root\"/><link name=\"gps\"/>" + Link("battery", "1") +
           Link("pelvis", "3") + Joint("b", "fixed", "root", "battery", behind) +
           Joint("g", "fixed", "root", "gps") + Joint("p", "fixed", "root", "pelvis", above));
  EXPECT_EQ(tree.base.name, "pelvis");
  EXPECT_TRUE(HasFrame(tree.base, "root", {0, 0, -0.5}));
  EXPECT_TRUE(HasFrame(tree.base, "gps", {0, 0, -0.5}));
  ASSERT_EQ(tree.base.children.size(), 1U);
  EXPECT_EQ(tree.base.children[0].name, "battery");
  EXPECT_FALSE(tree.base.children[0].joint);
  EXPECT_TRUE(tree.base.children[0].X_PB.translation().isApprox(Eigen::Vector3d(-0.1, 0, -0.5)));
  EXPECT_EQ(NoticesOf(tree),
            Lines{"a.urdf:1:17: notice: link 'root' at the root has no mass; the base is 'pelvis', "
                  "the heaviest of the links fixed to it"});
}

// A joint moves a link without mass, to which one with mass is fixed, turned a quarter about z.
TEST_F(ReadUrdfTest, AMovingLinkWithoutMassIsAFrameOfTheOneFixedToIt) {
  const UrdfTree tree = Read(Link("pelvis", "3") + "<link name=\"dummy\"/>" + Link("thigh", "1") +
                             Joint("hip", "continuous", "pelvis", "dummy",
                                   "<origin xyz=\"0 0 -1\"/><axis xyz=\"1 0 0\"/>") +
                             Joint("fix", "fixed", "dummy", "thigh",
                                   "<origin xyz=\"0 0.2 0\" rpy=\"0 0 1.5707963267948966\"/>"));
  ASSERT_EQ(tree.base.children.size(), 1U);
  const Body& thigh = tree.base.children[0];
  EXPECT_EQ(thigh.name, "thigh");
  EXPECT_TRUE(thigh.X_PB.translation().isApprox(Eigen::Vector3d(0, 0.2, -1)));
  EXPECT_TRUE(HasFrame(thigh, "dummy", {-0.2, 0, 0}));
  ASSERT_TRUE(thigh.joint);
  EXPECT_TRUE(thigh.joint->p_BJ.isApprox(Eigen::Vector3d(-0.2, 0, 0)));
  EXPECT_TRUE(thigh.joint->axis.isApprox(Eigen::Vector3d(0, -1, 0)));
}

TEST_F(ReadUrdfTest, WeldedLinksOfAFewGramsArePointMasses) {
  const std::string lamp =
      "<link name=\"lamp\"><inertial><origin xyz=\"0 0 0.1\"/><mass value=\"0.02\"/><inertia "
      "ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial></link>";
  const UrdfTree tree = Read(Link("pelvis", "0.02") + lamp +
                             Joint("f", "fixed", "pelvis", "lamp", "<origin xyz=\"0 0 0.1\"/>"));
  EXPECT_DOUBLE_EQ(tree.base.mass.mass_kg, 0.04);
  EXPECT_TRUE(tree.base.mass.com_m.isApprox(Eigen::Vector3d(0, 0, 0.1)));
  // By hand: 0.01 of the pelvis, and twice 0.02 kg at 0.1 m from the CoM.
  EXPECT_NEAR(tree.base.mass.inertia_kgm2(0, 0), 0.01 + 2 * 0.02 * 0.01, 1e-12);
  EXPECT_NEAR(tree.base.mass.inertia_kgm2(2, 2), 0.01, 1e-12);
  EXPECT_TRUE(HasFrame(tree.base, "lamp", {0, 0, 0.1}));
  EXPECT_EQ(NoticesOf(tree),
            Lines{"a.urdf:1:170: notice: welded links of a few grams with the inertia of no body "
                  "are taken as point masses, and as frames: lamp"});
}

TEST_F(ReadUrdfTest, LinksOfMoreThanAFewGramsNeedAnInertia) {
  EXPECT_EQ(folder_.ErrorOf([&] {
    Read(Link("pelvis", "3") +
         "<link name=\"a\"><inertial><mass value=\"0.021\"/></inertial></link>" +
         "<link name=\"b\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"2\" ixz=\"0\" "
         "iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>" +
         Joint("f", "fixed", "pelvis", "a") + Joint("g", "fixed", "pelvis", "b"));
  }),
            "a.urdf:1:164: error: link 'a' of 0.021 kg has the principal moments 0, 0 and 0 kg "
            "m^2; each must be greater than 0; mend its <inertial>\n"
            "a.urdf:1:228: error: link 'b' of 1 kg has the principal moments -1, 1 and 3 kg m^2; "
            "each must be greater than 0; mend its <inertial>");
}

TEST_F(ReadUrdfTest, LockedJointsMayMimicAndCarryNothing) {
  const std::string parts = Link("pelvis", "3") + Link("finger", "0.1") + "<link name=\"tip\"/>" +
                            Joint("bend", "revolute", "pelvis", "finger",
                                  "<limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"
                                  "<mimic joint=\"thumb\"/>") +
                            Joint("twist", "continuous", "finger", "tip");
  const UrdfTree tree = Read(parts, {"bend", "twist"});
  ASSERT_EQ(tree.joints.size(), 2U);
  EXPECT_EQ(tree.joints[0].fault, "mimics 'thumb', which can't be simulated");
  ASSERT_EQ(tree.base.children.size(), 1U);
  EXPECT_FALSE(tree.base.children[0].joint);
  EXPECT_TRUE(HasFrame(tree.base.children[0], "tip", {0, 0, 0}));
  EXPECT_EQ(NoticesOf(tree),
            Lines{"a.urdf:1:301: notice: locked joints, which could not move here anyway: bend "
                  "mimics 'thumb', which can't be simulated; twist moves a link without mass, "
                  "'tip', to which none with mass is fixed"});
}

TEST_F(ReadUrdfTest, ColoursAreTakenWithoutNamesAndLeftOutWhereThereIsNone) {
  const std::string mini = "<material name=\"red\"/></visual>";
  const auto color_of = [&](const std::string& material, Lines* notices) {
    const UrdfTree tree = ReadEdited(mini, material + "</visual>");
    *notices = NoticesOf(tree);
    return Eigen::Vector4d(tree.base.shapes[0].rgba);
  };
  const Eigen::Vector4d grey = Shape().rgba;
  Lines notices;
  EXPECT_EQ(color_of("<material><color rgba=\"0 0.5 1 1\"/></material>", &notices),
            Eigen::Vector4d(0, 0.5, 1, 1));
  EXPECT_EQ(notices,
            Lines{"a.urdf:9:72: notice: materials without a name are taken by their colours: 1"});
  EXPECT_EQ(color_of("<material name=\"blue\"/>", &notices), grey);
  EXPECT_EQ(notices, Lines{"a.urdf:9:72: notice: materials without a colour are drawn grey: blue"});
  EXPECT_EQ(color_of("<material name=\"x\"><color rgba=\"255 0 0 255\"/></material>", &notices),
            grey);
  EXPECT_EQ(notices.size(), 2U);
  EXPECT_EQ(color_of("<material/>", &notices), grey);
}

TEST_F(ReadUrdfTest, WhatOnlyOtherProgramsReadIsLeftOut) {
  const UrdfTree tree = ReadEdited(
      "</robot>",
      "<transmission name=\"t\"><type/></transmission><gazebo reference=\"leg\"/><gazebo/>"
      "<mujoco><compiler meshdir=\"x\"/></mujoco></robot>");
  EXPECT_EQ(NoticesOf(tree), Lines{"a.urdf: notice: elements that only other programs read: "
                                   "<gazebo> (2), <mujoco> (1), <transmission> (1)"});
}

TEST_F(ReadUrdfTest, WhatUrdfdomIsStrictAboutIsMended) {
  const std::string limit = "<limit effort=\"10\" velocity=\"3\"/>";
  EXPECT_NO_THROW(
      ReadEdited(limit, limit + "<dynamics/><safety_controller/><calibration x=\"\"/>"));
  EXPECT_NO_THROW(ReadEdited("<robot name=\"mini\">", "<robot name=\"mini\" version=\"2.1a\">"));
  EXPECT_NO_THROW(ReadEdited("<origin xyz=\"0.05 0 0.1\"/>", "<origin xyz=\" 0.05\n0\t0.1 \"/>"));
  EXPECT_EQ(ReadEdited(limit, "<limit lower=\"-1\" upper=\"1\"/>").joints.size(), 4U);
}

TEST_F(ReadUrdfTest, ACapsuleIsOneAndABadVisualIsNotDrawn) {
  const UrdfTree tree =
      ReadEdited("<sphere radius=\"0.15\"/>", "<capsule radius=\"0.1\" length=\"0.3\"/>");
  const Shape& capsule = tree.base.shapes.back();
  EXPECT_EQ(capsule.kind, ShapeKind::kCapsule);
  EXPECT_NEAR(capsule.size_m.x(), 0.1, 1e-15);
  EXPECT_NEAR(capsule.size_m.y(), 0.15, 1e-15) << "half length without the caps";
  EXPECT_EQ(NoticesOf(ReadEdited("<box size=\"0.2 0.3 0.4\"/>", "<box size=\"0.2 0.3\"/>")),
            Lines{"a.urdf:9:5: notice: link 'trunk' has size = '0.2 0.3' in <box>, which must be 3 "
                  "finite numbers; it is not drawn"});
}

TEST_F(ReadUrdfTest, MeshesDontCollideAndAreNamedAtOnce) {
  UrdfTree tree = ReadEdited("<sphere radius=\"0.15\"/>", "<mesh filename=\"a.stl\"/>");
  NoteMeshCollisions({"sole"}, &tree);
  EXPECT_FALSE(tree.notes.has_problems());
  EXPECT_EQ(NoticesOf(tree),
            Lines{"a.urdf:11:5: notice: meshes don't collide here; they are left out of the links "
                  "trunk"});
}

}  // namespace
}  // namespace sidestep::read_urdf_test
