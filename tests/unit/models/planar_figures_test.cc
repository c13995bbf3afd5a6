// SPDX-License-Identifier: BSD-3-Clause
// The planar bipeds against the figures that their READMEs give, as MuJoCo compiles them.
#include <gtest/gtest.h>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/home_pose.h"
#include "models/robot_description/robot_description.h"

namespace sidestep::planar_figures_test {
namespace {

constexpr double kRounding = 1e-12;

/// A shipped robot at home, without ground.
struct AtHome {
  explicit AtHome(const std::string& name)
      : robot(ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models" / name /
                                   "robot.yaml")),
        model(CompileMjcf("<mujoco><include file=\"robot.xml\"/></mujoco>",
                          robot.model->simulated_mjcf, robot.model->file)),
        data(MakeData(*model)) {
    PlaceAtHome(*model, robot, data.get());
    mj_comPos(model.get(), data.get());
  }

  Eigen::Vector3d Site(const std::string& name) const {
    return Eigen::Map<const Eigen::Vector3d>(data->site_xpos +
                                             3 * RequireId(*model, mjOBJ_SITE, name));
  }
  Eigen::Vector3d Com() const { return Eigen::Map<const Eigen::Vector3d>(data->subtree_com); }
  double Mass(const std::string& body) const {
    return model->body_mass[RequireId(*model, mjOBJ_BODY, body)];
  }
  /// About y, of the body's own CoM.
  double Inertia(const std::string& body) const {
    return model->body_inertia[3 * RequireId(*model, mjOBJ_BODY, body) + 1];
  }

  RobotDescription robot;
  MjModelPtr model;
  MjDataPtr data;
};

class PlanarFiguresTest : public testing::TestWithParam<const char*> {
 protected:
  AtHome at_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Robots, PlanarFiguresTest, testing::Values("rabbit", "biped"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(PlanarFiguresTest, FeetStandOnTheGroundWithTheComOverTheirMiddle) {
  for (const FootDescription& foot : at_.robot.feet) {
    EXPECT_NEAR(at_.Site(foot.frame).z(), foot.sole_height_m, 2e-4) << "pressed in by its weight";
  }
  EXPECT_NEAR(at_.Com().x(), 0.0, 1e-6);
  EXPECT_NEAR(at_.Com().y(), 0.0, kRounding);
  EXPECT_NEAR(at_.Com().z(), at_.robot.com_height_m, 0.005) << "the description rounds to 1 cm";
}

TEST_P(PlanarFiguresTest, LegsAreMirrorImages) {
  for (const char* part : {"femur", "tibia"}) {
    const std::string left = std::string("left_") + part, right = std::string("right_") + part;
    EXPECT_EQ(at_.Mass(left), at_.Mass(right));
    EXPECT_EQ(at_.Inertia(left), at_.Inertia(right));
  }
  for (const FootDescription& foot : at_.robot.feet) {
    EXPECT_NEAR(std::abs(foot.lateral_m), 0.06, kRounding);
  }
}

TEST_P(PlanarFiguresTest, LegsDoNotTouchEachOther) {
  for (int a = 0; a < at_.model->ngeom; ++a) {
    for (int b = a + 1; b < at_.model->ngeom; ++b) {
      EXPECT_EQ(at_.model->geom_contype[a] & at_.model->geom_conaffinity[b], 0) << a << " " << b;
    }
  }
}

TEST(RabbitFiguresTest, LinksAreAsPublished) {
  const AtHome rabbit("rabbit");
  EXPECT_NEAR(mj_getTotalmass(rabbit.model.get()), 40.0, kRounding);
  EXPECT_EQ(rabbit.Mass("torso"), 20.0);
  EXPECT_EQ(rabbit.Inertia("torso"), 2.22);
  EXPECT_EQ(rabbit.Mass("left_femur"), 6.8);
  EXPECT_EQ(rabbit.Inertia("left_femur"), 1.08);
  EXPECT_EQ(rabbit.Mass("left_tibia"), 3.2);
  EXPECT_EQ(rabbit.Inertia("left_tibia"), 0.93);
  EXPECT_EQ(rabbit.model->nu, 4);
}

TEST(BipedFiguresTest, ItWeighsOneKilogramAndItsFeetAreFlat) {
  const AtHome biped("biped");
  EXPECT_NEAR(mj_getTotalmass(biped.model.get()), 1.0, kRounding);
  for (const FootDescription& foot : biped.robot.feet) {
    const int site = RequireId(*biped.model, mjOBJ_SITE, foot.frame);
    EXPECT_NEAR(biped.data->site_xmat[9 * site + 8], 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace sidestep::planar_figures_test
