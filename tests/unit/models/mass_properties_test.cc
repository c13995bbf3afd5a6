// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/mass_properties.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sidestep::mass_properties_test {
namespace {

/// Two point masses make the simplest body: of 2 kg at +y and 1 kg at -2 y, 3 kg at the origin.
const MassProperties kHeavy{2.0, {0, 1, 0}, Eigen::Vector3d(0.1, 0.2, 0.15).asDiagonal()};

MassProperties Whole() {
  // By hand: the CoM is the origin; 2 * 1^2 + 1 * 2^2 = 6 about x and z, nothing about y.
  return {3.0, {0, 0, 0}, Eigen::Vector3d(0.1 + 0.3 + 6, 0.2 + 0.1, 0.15 + 0.3 + 6).asDiagonal()};
}

TEST(MassPropertiesTest, WhatRemainsIsTheOtherHalf) {
  const MassProperties rest = Without(Whole(), kHeavy);
  EXPECT_NEAR(rest.mass_kg, 1.0, 1e-15);
  EXPECT_LT((rest.com_m - Eigen::Vector3d(0, -2, 0)).norm(), 1e-15);
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.3, 0.1, 0.3).asDiagonal();
  EXPECT_LT((rest.inertia_kgm2 - expected).norm(), 1e-14);
}

TEST(MassPropertiesTest, ATurnedFrameTurnsComAndInertia) {
  // A quarter turn about z takes y to -x.
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()));
  X.pretranslate(Eigen::Vector3d(0, 0, 5));
  const MassProperties turned = InFrame(X, kHeavy);
  EXPECT_LT((turned.com_m - Eigen::Vector3d(-1, 0, 5)).norm(), 1e-15);
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.2, 0.1, 0.15).asDiagonal();
  EXPECT_LT((turned.inertia_kgm2 - expected).norm(), 1e-15);
  EXPECT_EQ(turned.mass_kg, 2.0);
}

TEST(MassPropertiesTest, OnlyPossibleInertiasArePhysical) {
  const auto is_physical = [](double mass_kg, double x, double y, double z) {
    return IsPhysical({mass_kg, {0, 0, 0}, Eigen::Vector3d(x, y, z).asDiagonal()});
  };
  EXPECT_TRUE(is_physical(1, 1, 1, 1));
  EXPECT_TRUE(is_physical(1, 1, 2, 3)) << "a plate";
  EXPECT_FALSE(is_physical(1, 1, 2, 3.01)) << "more than the sum of the others";
  EXPECT_FALSE(is_physical(1, 0, 1, 1));
  EXPECT_FALSE(is_physical(1, -1, 1, 1));
  EXPECT_FALSE(is_physical(0, 1, 1, 1));
  EXPECT_FALSE(is_physical(-1, 1, 1, 1));
  EXPECT_FALSE(is_physical(std::nan(""), 1, 1, 1));
  EXPECT_FALSE(is_physical(1, std::nan(""), 1, 1));
}

TEST(MassPropertiesTest, TogetherUndoesWithout) {
  const MassProperties part{1.0, {0.1, -0.2, 0.3}, Eigen::Vector3d(0.01, 0.02, 0.025).asDiagonal()};
  const MassProperties other{3.0, {-0.1, 0.4, 0.0}, Eigen::Vector3d(0.04, 0.03, 0.05).asDiagonal()};
  const MassProperties back = Without(Together(part, other), part);
  EXPECT_NEAR(back.mass_kg, other.mass_kg, 1e-14);
  EXPECT_TRUE(back.com_m.isApprox(other.com_m, 1e-13));
  EXPECT_TRUE(back.inertia_kgm2.isApprox(other.inertia_kgm2, 1e-12));
}

TEST(MassPropertiesTest, WhyABodyIsImpossibleIsToldInNumbers) {
  const auto why = [](double mass_kg, const Eigen::Vector3d& moments) {
    return WhyNotPhysical({mass_kg, Eigen::Vector3d::Zero(), moments.asDiagonal()});
  };
  EXPECT_EQ(why(1.0, {1, 2, 3}), "") << "a flat body";
  EXPECT_EQ(why(1.0, {4, 1, 2}),
            "of 1 kg has the principal moments 1, 2 and 4 kg m^2; none may be greater than the "
            "other two together, and 4 > 1 + 2");
  EXPECT_EQ(why(1.0, {0, 1, 1}),
            "of 1 kg has the principal moments 0, 1 and 1 kg m^2; each must be greater than 0");
  EXPECT_EQ(why(0.0, {1, 1, 1}),
            "of 0 kg has the principal moments 1, 1 and 1 kg m^2, and no body has a mass that is "
            "not positive");
}

}  // namespace
}  // namespace sidestep::mass_properties_test
