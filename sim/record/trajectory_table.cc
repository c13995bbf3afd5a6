// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/trajectory_table.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "models/support/require.h"
#include "sim/record/column_digits.h"
#include "sim/record/output_file.h"
#include "sim/verdict/fall_meter.h"

namespace sidestep {

/// A walk under way: over the names of the columns, or over the values of a row.
class TrajectoryTable::Line {
 public:
  explicit Line(std::vector<std::string>& names) : names_(&names) {}
  /// @param decimals  Of every column; empty: all digits.
  Line(std::string& row, const std::vector<int>& decimals) : text_(&row), decimals_(&decimals) {}

  void Number(std::string_view stem, std::string_view name, std::string_view unit, double value,
              bool is_known = true) {
    if (names_ != nullptr) {
      names_->emplace_back(stem).append(name).append(unit);
    } else {
      AppendCell(value, is_known);
    }
  }

  void Vector(std::string_view stem, std::string_view name, std::string_view unit,
              const Eigen::Vector3d& value, bool is_known = true) {
    constexpr std::array<std::string_view, 3> kAxes{"_x", "_y", "_z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (names_ != nullptr) {
        names_->emplace_back(stem).append(name).append(kAxes[axis]).append(unit);
      } else {
        AppendCell(value[static_cast<Eigen::Index>(axis)], is_known);
      }
    }
  }

  void Quaternion(std::string_view stem, std::string_view name, const Eigen::Quaterniond& value,
                  bool is_known = true) {
    constexpr std::array<std::string_view, 4> kParts{"_w", "_x", "_y", "_z"};
    const std::array<double, 4> numbers{value.w(), value.x(), value.y(), value.z()};
    for (std::size_t part = 0; part < 4; ++part) {
      Number(stem, name, kParts[part], numbers[part], is_known);
    }
  }

  void Flag(std::string_view stem, std::string_view name, bool value, bool is_known = true) {
    Number(stem, name, {}, value ? 1.0 : 0.0, is_known);
  }

 private:
  void AppendCell(double value, bool is_known) {
    const std::size_t column = cells_++;
    if (column > 0) text_->push_back(',');
    if (!is_known) return;
    if (column > 0 && !decimals_->empty()) {  // the first is the time
      AppendRounded(*text_, value, (*decimals_)[column]);
    } else {
      AppendNumber(*text_, value);
    }
  }

  std::vector<std::string>* names_{nullptr};  ///< Null: values are walked over.
  std::string* text_{nullptr};
  const std::vector<int>* decimals_{nullptr};
  std::size_t cells_{0};  ///< So far.
};

namespace {

double Entry(const Eigen::VectorXd& vector, std::size_t at) {
  const auto index = static_cast<Eigen::Index>(at);
  return index < vector.size() ? vector[index] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

TrajectoryTable::TrajectoryTable(const RobotDescription& robot, Plant plant, ControlMode mode,
                                 std::vector<JointInfo> joints, LogDetail detail)
    : joints_(std::move(joints)),
      has_references_(mode == ControlMode::kPosition),
      up_B_(UprightAxis(robot, plant)) {
  for (const FootDescription& foot : robot.feet) feet_.push_back(foot.name);
  if (detail == LogDetail::kFull) return;
  for (const std::string& column : Columns()) decimals_.push_back(DecimalsOf(column));
}

std::string TrajectoryTable::Header() const {
  std::string text;
  for (const std::string& column : Columns()) text.append(text.empty() ? "" : ",").append(column);
  return text + "\n";
}

std::vector<std::string> TrajectoryTable::Columns() const {
  WorldTruth truth;
  truth.feet.resize(feet_.size());
  truth.joint_position.setZero(static_cast<Eigen::Index>(joints_.size()));
  truth.joint_torque_Nm = truth.joint_position;
  const ControlTick control;
  std::vector<std::string> names;
  Line line(names);
  Walk({0.0, truth, control, {}}, line);
  return names;
}

void TrajectoryTable::AppendRow(const TrajectoryRow& row, std::string& text) const {
  SIDESTEP_REQUIRE(row.truth.feet.size() == feet_.size(), row.truth.feet.size());
  SIDESTEP_REQUIRE(row.truth.joint_position.size() == static_cast<Eigen::Index>(joints_.size()),
                   row.truth.joint_position.size());
  Line line(text, decimals_);
  Walk(row, line);
  text.push_back('\n');
}

void TrajectoryTable::Walk(const TrajectoryRow& row, Line& line) const {
  line.Number("time_s", {}, {}, row.time_s);
  WalkTruth(row.truth, line);
  WalkBelief(row.control, line);
  WalkPlan(row.control, line);
  WalkJoints(row, line);
  const bool plans = !row.control.feet.empty();
  const bool thinks = plans || !row.control.state.feet.empty();
  line.Number("wbc_status", {}, {}, static_cast<int>(row.control.wbc.status), thinks);
  line.Number("mpc_age_s", {}, {}, row.control.mpc_age_s, plans);
  line.Number("wall_control_ms", {}, {}, row.times.control.wall_ms);
  line.Number("wall_whole_body_ms", {}, {}, row.times.whole_body.wall_ms);
  line.Number("wall_mpc_ms", {}, {}, row.times.mpc.wall_ms);
}

void TrajectoryTable::WalkJoints(const TrajectoryRow& row, Line& line) const {
  const ActuatorCommand& command = row.control.command;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const std::string& name = joints_[i].name;
    const bool is_slide = joints_[i].is_slide;
    const auto at = static_cast<Eigen::Index>(i);
    if (has_references_) {
      const bool is_known = at < command.joint_position.size();
      line.Number("command_", name, is_slide ? "_m" : "_rad", Entry(command.joint_position, i),
                  is_known);
      line.Number("command_", name, is_slide ? "_mps" : "_radps", Entry(command.joint_velocity, i),
                  is_known);
    } else {
      line.Number("command_", name, is_slide ? "_N" : "_Nm", Entry(command.torque_Nm, i),
                  at < command.torque_Nm.size());
    }
    line.Number("joint_", name, is_slide ? "_m" : "_rad", Entry(row.truth.joint_position, i));
    line.Number("joint_", name, is_slide ? "_N" : "_Nm", Entry(row.truth.joint_torque_Nm, i));
  }
}

void TrajectoryTable::WalkTruth(const WorldTruth& truth, Line& line) const {
  line.Vector("truth_p_WC", {}, "_m", truth.p_WC);
  line.Vector("truth_v_WC", {}, "_mps", truth.v_WC);
  line.Vector("truth_h_C_W", {}, "_kgm2ps", truth.angular_momentum);
  line.Vector("truth_p_WB", {}, "_m", truth.p_WB);
  line.Quaternion("truth_q_WB", {}, truth.q_WB);
  line.Number("truth_tilt_rad", {}, {}, TiltRad(truth.q_WB, up_B_));
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    line.Vector("truth_p_WF_", feet_[i], "_m", truth.feet[i].p_WF);
    line.Quaternion("truth_q_WF_", feet_[i], Eigen::Quaterniond(truth.feet[i].R_WF));
    line.Vector("truth_f_F_W_", feet_[i], "_N", truth.feet[i].f_F_W);
    line.Vector("truth_m_F_W_", feet_[i], "_Nm", truth.feet[i].m_F_W);
    line.Flag("truth_contact_", feet_[i], truth.feet[i].in_contact);
  }
  Eigen::Vector3d push_force_W_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d push_torque_C_W_Nm = Eigen::Vector3d::Zero();
  for (const PushTruth& push : truth.pushes) {
    push_force_W_N += push.force_W_N;
    push_torque_C_W_Nm += (push.p_W - truth.p_WC).cross(push.force_W_N);
  }
  line.Vector("push_force_W", {}, "_N", push_force_W_N);
  line.Vector("push_torque_C_W", {}, "_Nm", push_torque_C_W_Nm);
}

void TrajectoryTable::WalkBelief(const ControlTick& control, Line& line) const {
  const RobotState& state = control.state;
  const bool believes = !state.feet.empty();
  line.Vector("belief_p_WC", {}, "_m", state.p_WC, believes);
  line.Vector("belief_v_WC", {}, "_mps", state.v_WC, believes);
  line.Vector("belief_h_C_W", {}, "_kgm2ps", state.angular_momentum, believes);
  line.Vector("belief_p_WB", {}, "_m", state.p_WB, believes);
  line.Vector("belief_push_force_W", {}, "_N", state.external_wrench.force_N, believes);
  line.Vector("belief_push_torque_C_W", {}, "_Nm", state.external_wrench.torque_Nm, believes);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const bool is_known = i < state.feet.size();
    const FootState foot = is_known ? state.feet[i] : FootState{};
    line.Vector("belief_p_WF_", feet_[i], "_m", foot.p_WF, is_known);
    line.Quaternion("belief_q_WF_", feet_[i], Eigen::Quaterniond(foot.R_WF), is_known);
    line.Vector("belief_f_F_W_", feet_[i], "_N", foot.wrench.force_N, is_known);
    line.Vector("belief_m_F_W_", feet_[i], "_Nm", foot.wrench.torque_Nm, is_known);
    line.Flag("belief_contact_", feet_[i], foot.in_contact, is_known);
  }
}

void TrajectoryTable::WalkPlan(const ControlTick& control, Line& line) const {
  const FootTarget no_target;
  const bool plans = !control.feet.empty();
  line.Vector("reference_p_WC", {}, "_m", control.reference.p_WC, plans);
  line.Vector("reference_v_WC", {}, "_mps", control.reference.v_WC, plans);
  line.Vector("mpc_p_WC", {}, "_m", control.com.p_WC, plans);
  line.Vector("mpc_v_WC", {}, "_mps", control.com.v_WC, plans);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const bool is_known = i < control.feet.size();
    const FootTarget& foot = is_known ? control.feet[i] : no_target;
    line.Flag("planned_contact_", feet_[i], foot.planned_contact, is_known);
    line.Vector("mpc_f_F_W_", feet_[i], "_N", foot.force_N, is_known);
    line.Vector("nominal_p_WF_", feet_[i], "_m", foot.contact.nominal_p_WF, is_known);
    line.Vector("adjusted_p_WF_", feet_[i], "_m", foot.contact.adjusted_p_WF, is_known);
    line.Vector("swing_p_WF_", feet_[i], "_m", foot.p_WF, is_known);
  }
}

}  // namespace sidestep
