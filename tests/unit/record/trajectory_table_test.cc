// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/trajectory_table.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "models/support/require.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::trajectory_table_test {
namespace {

std::vector<std::string> CellsOf(const std::string& line) {
  EXPECT_EQ(line.find('\n'), line.size() - 1) << "one line, with its end";
  std::vector<std::string> cells(1);
  for (const char c : line.substr(0, line.size() - 1)) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

TrajectoryTable TableOf(const Scenario& scenario, const std::vector<JointInfo>& joints) {
  return {scenario.robot, scenario.plant, scenario.control.mode, joints};
}

// The cells of the row that `world` and `control` make, by their columns' names.
std::map<std::string, std::string> RowOf(const ScriptedWorld& world, const ControlTick& control) {
  const TrajectoryTable table = TableOf(TwoFeetScenario(), world.joints());
  const std::vector<std::string> names = CellsOf(table.Header());
  std::string line;
  table.AppendRow({0.5, world.truth(), control, {}}, line);
  const std::vector<std::string> cells = CellsOf(line);
  EXPECT_EQ(names.size(), cells.size());
  std::map<std::string, std::string> row;
  for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) row[names[i]] = cells[i];
  EXPECT_EQ(row.size(), names.size()) << "two columns share a name";
  return row;
}

// The same in a world of two joints at rest.
std::map<std::string, std::string> RowOf(const ControlTick& control) {
  return RowOf(ScriptedWorld(TwoFeetScenario(), {{"hip"}, {"leg", true}}), control);
}

bool IsThought(const std::string& name) {
  for (const char* stem : {"belief_", "reference_", "mpc_", "planned_", "nominal_", "adjusted_",
                           "swing_", "command_", "wbc_"}) {
    if (name.starts_with(stem)) return true;
  }
  return false;
}

bool IsBelief(const std::string& name) { return name.starts_with("belief_"); }

TEST(TrajectoryTableTest, AControllerThatSaysNothingHasNoCellThatLooksLikeAThought) {
  int num_thoughts = 0;
  for (const auto& [name, cell] : RowOf({})) {
    if (IsThought(name)) {
      EXPECT_EQ(cell, "") << name;
      ++num_thoughts;
    } else {
      EXPECT_NE(cell, "") << name << ": truth and clock are known whoever controls";
    }
  }
  EXPECT_GT(num_thoughts, 50) << "two feet have more columns than that";
}

TEST(TrajectoryTableTest, AThoughtOfZeroIsNoEmptyCell) {
  ControlTick control;
  control.state.feet.resize(2);
  control.feet.resize(2);
  control.command.torque_Nm.setZero(2);
  for (const auto& [name, cell] : RowOf(control)) EXPECT_NE(cell, "") << name;
}

TEST(TrajectoryTableTest, ABeliefWithoutAPlanAndAPlanWithoutABeliefAreToldApart) {
  ControlTick believer;
  believer.state.feet.resize(2);
  ControlTick planner;
  planner.feet.resize(2);
  const auto believed = RowOf(believer);
  const auto planned = RowOf(planner);
  for (const auto& [name, cell] : believed) {
    if (!IsThought(name) || name.starts_with("command_")) continue;
    if (name == "wbc_status") {
      EXPECT_NE(cell + planned.at(name), "") << "either tells of a controller that thinks";
      continue;
    }
    EXPECT_EQ(!cell.empty(), IsBelief(name)) << name;
    EXPECT_EQ(!planned.at(name).empty(), !IsBelief(name)) << name;
  }
}

TEST(TrajectoryTableTest, TheTorqueOfAPushIsAboutTheCom) {
  ScriptedWorld world(TwoFeetScenario());
  world.written.p_WC = {0.0, 0.0, 0.5};
  // 2 N along y, 0.25 m above the CoM: (0, 0, 0.25) x (0, 2, 0) = (-0.5, 0, 0). The other push, at
  // the CoM itself, turns nothing.
  world.written.pushes[0] = {{0.0, 2.0, 0.0}, {0.0, 0.0, 0.75}};
  world.written.pushes[1] = {{0.0, 3.0, 0.0}, {0.0, 0.0, 0.5}};
  const auto row = RowOf(world, {});
  EXPECT_EQ(std::stod(row.at("push_torque_C_W_x_Nm")), -0.5);
  EXPECT_EQ(std::stod(row.at("push_torque_C_W_y_Nm")), 0.0);
  EXPECT_EQ(std::stod(row.at("push_torque_C_W_z_Nm")), 0.0);
  EXPECT_EQ(std::stod(row.at("push_force_W_y_N")), 5.0);
}

TEST(TrajectoryTableTest, ATruthOfAnotherRobotBreaksTheContract) {
  const Scenario scenario = TwoFeetScenario();
  ScriptedWorld world(scenario);
  const TrajectoryTable table = TableOf(scenario, {});
  std::string line;
  world.written.feet.resize(1);
  EXPECT_THROW(table.AppendRow({0.0, world.truth(), {}, {}}, line), ContractViolation);
  world.written.feet.resize(2);
  world.written.joint_position.setZero(1);
  EXPECT_THROW(table.AppendRow({0.0, world.truth(), {}, {}}, line), ContractViolation);
}

}  // namespace
}  // namespace sidestep::trajectory_table_test
