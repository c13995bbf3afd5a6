// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/centroidal_ocp.h"

#include <gtest/gtest.h>

#include "models/support/require.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::centroidal_ocp_test {
namespace {

CentroidalOcp WithOneFoot() {
  CentroidalOcp ocp = FloatingProblem(5);
  OcpContact foot = Foot("foot", 4);
  foot.phases = {FixedPhase(0, 2, Eigen::Vector3d::Zero()),
                 FreePhase(4, 9, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero())};
  ocp.contacts = {foot};
  return ocp;
}

TEST(CentroidalOcpTest, APhaseIsActiveFromItsFirstKnotUntilBeforeItsEnd) {
  const OcpContact foot = WithOneFoot().contacts[0];
  const std::vector<int> expected = {0, 0, -1, -1, 1, 1, 1, 1, 1, -1};
  for (int k = 0; k < static_cast<int>(expected.size()); ++k) {
    EXPECT_EQ(ActivePhase(foot, k), expected[static_cast<std::size_t>(k)]) << k;
  }
  EXPECT_EQ(ActivePhase(foot, -1), -1);
}

TEST(CentroidalOcpTest, OnlyTheFirstStepMayBeItsOwn) {
  CentroidalOcp ocp = WithOneFoot();
  ocp.step_s = 0.2;
  for (int k = 0; k < ocp.knots; ++k) EXPECT_EQ(ocp.StepAt(k), 0.2) << k;
  ocp.first_step_s = 0.05;
  EXPECT_NO_THROW(CheckShapes(ocp));
  for (int k = 0; k < ocp.knots; ++k) EXPECT_EQ(ocp.StepAt(k), k == 0 ? 0.05 : 0.2) << k;
}

TEST(CentroidalOcpTest, ConsistentShapesPassEvenWithAnEmptyBoxOrNan) {
  CentroidalOcp ocp = WithOneFoot();
  EXPECT_NO_THROW(CheckShapes(ocp));
  ocp.contacts[0].phases[1].box_lower_m.setOnes();
  ocp.mass_kg = std::nan("");
  ocp.first_step_s = std::nan("");
  EXPECT_NO_THROW(CheckShapes(ocp));
}

TEST(CentroidalOcpTest, EveryInconsistencyBreaksTheContract) {
  const std::vector<void (*)(CentroidalOcp&)> breakers = {
      [](CentroidalOcp& ocp) { ocp.knots = 0; },
      [](CentroidalOcp& ocp) { ocp.step_s = 0.0; },
      [](CentroidalOcp& ocp) { ocp.first_step_s = 0.0; },
      [](CentroidalOcp& ocp) { ocp.first_step_s = 1.001 * ocp.step_s; },
      [](CentroidalOcp& ocp) { ocp.mass_kg = -1.0; },
      [](CentroidalOcp& ocp) { ocp.foot_load_limit_N = -1.0; },
      [](CentroidalOcp& ocp) { ocp.reference_p_WC.resize(3, 5); },
      [](CentroidalOcp& ocp) { ocp.reference_angular_momentum.resize(3, 7); },
      [](CentroidalOcp& ocp) { ocp.external_force_N.resize(3, 6); },
      [](CentroidalOcp& ocp) { ocp.external_torque_Nm.resize(3, 4); },
      [](CentroidalOcp& ocp) { ocp.friction_b.resize(3); },
      [](CentroidalOcp& ocp) { ocp.contacts[0].vertices_m.resize(3, 0); },
      [](CentroidalOcp& ocp) { ocp.contacts[0].has_previous_force = true; },
      [](CentroidalOcp& ocp) { ocp.contacts[0].phases[0].first_knot = -1; },
      [](CentroidalOcp& ocp) { ocp.contacts[0].phases[0].end_knot = 0; },
      [](CentroidalOcp& ocp) { ocp.contacts[0].phases[1].first_knot = 1; },
      [](CentroidalOcp& ocp) { std::swap(ocp.contacts[0].phases[0], ocp.contacts[0].phases[1]); },
  };
  for (std::size_t b = 0; b < breakers.size(); ++b) {
    CentroidalOcp ocp = WithOneFoot();
    breakers[b](ocp);
    EXPECT_THROW(CheckShapes(ocp), ContractViolation) << b;
  }
}

}  // namespace
}  // namespace sidestep::mpc::centroidal_ocp_test
