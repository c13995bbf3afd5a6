// SPDX-License-Identifier: BSD-3-Clause
#include "sim/export/column_path.h"

#include <algorithm>
#include <array>
#include <optional>

#include "sim/record/column_digits.h"

namespace sidestep {
namespace {

// What stands after the stem (and the foot's name) of a column.
enum class Ending {
  kVector,      // _x, _y or _z, and a unit
  kQuaternion,  // _w, _x, _y or _z
  kScalar,      // a unit
  kPlain        // nothing
};

// Columns of one group; a `*` of the group stands for the foot's name, which follows the stem.
struct Rule {
  std::string_view stem;
  std::string_view group;
  Ending ending;
};

constexpr std::array<Rule, 36> kRules{
    {{"truth_p_WC", "truth/com/position", Ending::kVector},
     {"truth_v_WC", "truth/com/velocity", Ending::kVector},
     {"truth_h_C_W", "truth/com/angular_momentum", Ending::kVector},
     {"truth_p_WB", "truth/base/position", Ending::kVector},
     {"truth_q_WB", "truth/base/orientation", Ending::kQuaternion},
     {"truth_tilt", "truth/base/tilt", Ending::kScalar},
     {"truth_p_WF_", "truth/feet/*/position", Ending::kVector},
     {"truth_q_WF_", "truth/feet/*/orientation", Ending::kQuaternion},
     {"truth_f_F_W_", "truth/feet/*/force", Ending::kVector},
     {"truth_m_F_W_", "truth/feet/*/torque", Ending::kVector},
     {"truth_contact_", "truth/feet/*/contact", Ending::kPlain},
     {"push_force_W", "truth/push/force", Ending::kVector},
     {"push_torque_C_W", "truth/push/torque", Ending::kVector},
     {"belief_p_WC", "belief/com/position", Ending::kVector},
     {"belief_v_WC", "belief/com/velocity", Ending::kVector},
     {"belief_h_C_W", "belief/com/angular_momentum", Ending::kVector},
     {"belief_p_WB", "belief/base/position", Ending::kVector},
     {"belief_push_force_W", "belief/push/force", Ending::kVector},
     {"belief_push_torque_C_W", "belief/push/torque", Ending::kVector},
     {"belief_p_WF_", "belief/feet/*/position", Ending::kVector},
     {"belief_q_WF_", "belief/feet/*/orientation", Ending::kQuaternion},
     {"belief_f_F_W_", "belief/feet/*/force", Ending::kVector},
     {"belief_m_F_W_", "belief/feet/*/torque", Ending::kVector},
     {"belief_contact_", "belief/feet/*/contact", Ending::kPlain},
     {"reference_p_WC", "reference/com/position", Ending::kVector},
     {"reference_v_WC", "reference/com/velocity", Ending::kVector},
     {"mpc_p_WC", "mpc/com/position", Ending::kVector},
     {"mpc_v_WC", "mpc/com/velocity", Ending::kVector},
     {"mpc_f_F_W_", "mpc/feet/*/force", Ending::kVector},
     {"mpc_age", "mpc/age", Ending::kScalar},
     {"planned_contact_", "plan/feet/*/contact", Ending::kPlain},
     {"nominal_p_WF_", "plan/feet/*/nominal_position", Ending::kVector},
     {"adjusted_p_WF_", "plan/feet/*/adjusted_position", Ending::kVector},
     {"swing_p_WF_", "plan/feet/*/swing_position", Ending::kVector},
     {"wbc_status", "wbc/status", Ending::kPlain},
     {"wall_", "wall/*", Ending::kScalar}}};

// Takes `_` and one of `letters` from the end of `rest`.
std::optional<std::string> TakeAxis(std::string_view* rest, std::string_view letters) {
  if (rest->size() < 2 || (*rest)[rest->size() - 2] != '_' ||
      letters.find(rest->back()) == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string axis(1, rest->back());
  rest->remove_suffix(2);
  return axis;
}

std::vector<std::string> SplitGroup(std::string_view group, std::string_view foot) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= group.size();) {
    const std::size_t end = std::min(group.find('/', begin), group.size());
    const std::string_view part = group.substr(begin, end - begin);
    parts.emplace_back(part == "*" ? foot : part);
    begin = end + 1;
  }
  return parts;
}

// The path if all of the column is as the rule has it.
std::optional<ColumnPath> Apply(const Rule& rule, std::string_view column) {
  if (!column.starts_with(rule.stem)) return std::nullopt;
  std::string_view rest = column.substr(rule.stem.size());
  ColumnPath path;
  if (rule.ending == Ending::kVector || rule.ending == Ending::kScalar) {
    path.unit = ColumnUnit(column);
    if (path.unit.empty() || rest.size() < path.unit.size() + 1) return std::nullopt;
    rest.remove_suffix(path.unit.size() + 1);
  }
  if (rule.ending == Ending::kVector || rule.ending == Ending::kQuaternion) {
    const auto axis = TakeAxis(&rest, rule.ending == Ending::kVector ? "xyz" : "wxyz");
    if (!axis) return std::nullopt;
    path.element = *axis;
  }
  const bool has_foot = rule.group.find('*') != std::string_view::npos;
  if (rest.empty() == has_foot) return std::nullopt;
  path.group = SplitGroup(rule.group, rest);
  return path;
}

// command_<joint>_<unit> and joint_<joint>_<unit>; slides have m, mps and N.
std::optional<ColumnPath> JointPath(std::string_view column) {
  const bool is_command = column.starts_with("command_");
  if (!is_command && !column.starts_with("joint_")) return std::nullopt;
  const std::string_view rest = column.substr(column.find('_') + 1);
  const std::string_view unit = ColumnUnit(rest);
  if (unit.empty() || rest.size() < unit.size() + 2) return std::nullopt;
  const char* kind = unit == "rad" || unit == "m"       ? "positions"
                     : unit == "radps" || unit == "mps" ? "velocities"
                     : unit == "Nm" || unit == "N"      ? "torques"
                                                        : nullptr;
  if (kind == nullptr) return std::nullopt;
  return ColumnPath{{is_command ? "commands" : "joints_state", kind},
                    std::string(rest.substr(0, rest.size() - unit.size() - 1)),
                    std::string(unit)};
}

}  // namespace

ColumnPath PathOf(std::string_view column) {
  if (const auto joint = JointPath(column)) return *joint;
  for (const Rule& rule : kRules) {
    if (const auto path = Apply(rule, column)) return *path;
  }
  return {{"other", std::string(column)}, "", ""};
}

std::string PathText(const ColumnPath& path) {
  std::string text;
  for (const std::string& part : path.group) text += (text.empty() ? "" : "/") + part;
  if (!path.element.empty()) text += "/" + path.element;
  return path.unit.empty() ? text : text + "_" + path.unit;
}

}  // namespace sidestep
