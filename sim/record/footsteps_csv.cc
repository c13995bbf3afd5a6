// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/footsteps_csv.h"

#include <cmath>
#include <limits>

#include "controller/types/tick.h"
#include "sim/record/output_file.h"

namespace sidestep {
namespace {

constexpr char kHeader[] =
    "foot,index,start_s,end_s,nominal_x_m,nominal_y_m,nominal_z_m,adjusted_x_m,adjusted_y_m,"
    "adjusted_z_m,realised_x_m,realised_y_m,realised_z_m,slip_m,box_lower_x_m,box_lower_y_m,"
    "box_upper_x_m,box_upper_y_m,yaw_rad\n";

void AppendCell(double value, std::string& text) {
  text.push_back(',');
  AppendNumber(text, value);
}

void AppendCells(const Eigen::Ref<const Eigen::VectorXd>& values, std::string& text) {
  for (Eigen::Index i = 0; i < values.size(); ++i) AppendCell(values[i], text);
}

}  // namespace

std::string FootstepsCsv(const std::vector<FootstepRecord>& footsteps,
                         const std::vector<std::string>& feet, double tick_s) {
  std::string text = kHeader;
  for (const FootstepRecord& step : footsteps) {
    const PlannedContact& contact = step.contact;
    text.append(feet.at(static_cast<std::size_t>(step.foot)));
    AppendCell(contact.index, text);
    AppendCell(SecondsAt(contact.start_tick, tick_s), text);
    AppendCell(contact.end_is_known ? SecondsAt(contact.end_tick, tick_s)
                                    : std::numeric_limits<double>::infinity(),
               text);
    AppendCells(contact.nominal_p_WF, text);
    AppendCells(contact.adjusted_p_WF, text);
    if (step.realised_p_WF) {
      AppendCells(*step.realised_p_WF, text);
    } else {
      text.append(",,,");
    }
    AppendCell(step.slip_m, text);
    if (step.is_planned) {
      AppendCells(contact.box_lower_m.head<2>(), text);
      AppendCells(contact.box_upper_m.head<2>(), text);
    } else {
      text.append(",,,,");
    }
    AppendCell(std::atan2(contact.R_WF(1, 0), contact.R_WF(0, 0)), text);
    text.push_back('\n');
  }
  return text;
}

}  // namespace sidestep
