// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/centroidal_command.h"

#include <gtest/gtest.h>

namespace sidestep::wbc::centroidal_command_test {
namespace {

/// Two feet of four vertices; the left one is meant to stand and pushes.
std::vector<FootTarget> TwoFeet() {
  std::vector<FootTarget> feet(2);
  for (FootTarget& foot : feet) foot.vertex_force_N.setZero(3, 4);
  feet[0].planned_contact = true;
  feet[0].p_WF = {0.1, 0.2, 0.0};
  feet[0].vertex_force_N.row(2) << 1.0, 2.0, 3.0, 4.0;
  feet[1].p_WF = {0.3, -0.2, 0.05};
  return feet;
}

TEST(CentroidalCommandTest, HandsTheTargetsOn) {
  const std::vector<FootTarget> feet = TwoFeet();
  ActuatorCommand command;
  command.centroidal_feet.resize(3);  // of another robot
  WriteCentroidalCommand(feet, &command);
  ASSERT_EQ(command.centroidal_feet.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(command.centroidal_feet[i].in_contact, i == 0);
    EXPECT_EQ(command.centroidal_feet[i].p_WF, feet[i].p_WF);
    EXPECT_EQ(command.centroidal_feet[i].force_N, feet[i].vertex_force_N);
  }
}

}  // namespace
}  // namespace sidestep::wbc::centroidal_command_test
