// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/foothold_marks.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace sidestep::render {
namespace {

// Shares of the CoM height, chosen by eye.
constexpr double kOutlineHalfWidth = 0.006;
constexpr double kPointHalfSize = 0.05;  // half side of a point foot's mark
constexpr double kPlateHalfThickness = 0.0015;

constexpr double kSamePlace_m = 1e-4;  // a foothold closer than this is the same one
constexpr double kMoved_m = 0.003;     // less than this is not worth a line
constexpr double kOldestAlpha = 0.15;  // of a mark about to vanish

struct Mark {
  std::size_t foot{0};
  Eigen::Vector3d nominal_p_WF;
  Eigen::Vector3d adjusted_p_WF;
  double yaw_rad{0.0};
  double alpha{1.0};
};

struct Rectangle {
  Eigen::Vector3d center;  // relative to F, on the floor
  Eigen::Vector2d half_m;
};

Rectangle RectangleOf(const std::string& foot, const std::vector<Sole>& soles,
                      const DrawScale& scale) {
  const double point_half_m = kPointHalfSize * scale.com_height_m;
  for (const Sole& sole : soles) {
    if (sole.foot != foot) continue;
    const Eigen::Vector2d half_m = 0.5 * (sole.upper_m - sole.lower_m);
    const Eigen::Vector2d middle_m = 0.5 * (sole.upper_m + sole.lower_m);
    return {{middle_m.x(), middle_m.y(), -sole.height_m}, half_m.cwiseMax(0.5 * point_half_m)};
  }
  return {Eigen::Vector3d::Zero(), Eigen::Vector2d::Constant(point_half_m)};
}

Decoration Slab(const Eigen::Vector3d& center, const Eigen::Vector3d& half_m, double yaw_rad,
                const Color& color) {
  Decoration slab;
  slab.shape = Shape::kSlab;
  slab.from = center;
  slab.half_m = half_m;
  slab.yaw_rad = yaw_rad;
  slab.color = color;
  return slab;
}

Eigen::AngleAxisd About(double yaw_rad) { return {yaw_rad, Eigen::Vector3d::UnitZ()}; }

// Four bars that together are the rectangle's outline.
void AddOutline(const Eigen::Vector3d& center, const Eigen::Vector2d& half_m, double yaw_rad,
                const Color& color, const DrawScale& scale, std::vector<Decoration>* marks) {
  const double bar_m = kOutlineHalfWidth * scale.com_height_m;
  const double up_m = 2.0 * kPlateHalfThickness * scale.com_height_m;  // above adjusted plates
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d across = About(yaw_rad) * Eigen::Vector3d(0.0, side * half_m.y(), 0.0);
    const Eigen::Vector3d along = About(yaw_rad) * Eigen::Vector3d(side * half_m.x(), 0.0, 0.0);
    marks->push_back(Slab(center + across, {half_m.x() + bar_m, bar_m, up_m}, yaw_rad, color));
    marks->push_back(Slab(center + along, {bar_m, half_m.y() - bar_m, up_m}, yaw_rad, color));
  }
}

void AddMark(const Mark& mark, const Rectangle& sole, const DrawScale& scale,
             std::vector<Decoration>* marks) {
  const double thick_m = kPlateHalfThickness * scale.com_height_m;
  Color grey = kNominalColor;
  Color tint = FootColor(mark.foot);
  grey.w() *= static_cast<float>(mark.alpha);
  tint.w() *= static_cast<float>(mark.alpha);
  const Eigen::Vector3d middle = About(mark.yaw_rad) * sole.center;
  const Eigen::Vector3d nominal = mark.nominal_p_WF + middle;
  const Eigen::Vector3d adjusted = mark.adjusted_p_WF + middle;
  AddOutline(nominal, sole.half_m, mark.yaw_rad, grey, scale, marks);
  marks->push_back(Slab(adjusted, {sole.half_m.x(), sole.half_m.y(), thick_m}, mark.yaw_rad, tint));
  if ((adjusted - nominal).norm() > kMoved_m) {
    Decoration line;
    line.shape = Shape::kLine;
    line.from = nominal;
    line.to = adjusted;
    line.radius_m = kOutlineHalfWidth * scale.com_height_m;
    line.color = tint;
    marks->push_back(line);
  }
}

// Yaw of the foot's contact that lasts at `time_s` or comes next; the log's rows don't tell it.
double YawFrom(double time_s, const std::string& foot, const std::vector<Footstep>& footsteps) {
  for (const Footstep& step : footsteps) {
    if (step.foot == foot && step.end_s > time_s) return step.yaw_rad;
  }
  return 0.0;
}

// Contacts of the past, then each foot's current or next one unless it is among them.
std::vector<Mark> MarksAt(const StateRow& row, const std::vector<std::string>& feet,
                          const std::vector<Footstep>& footsteps, double memory_s) {
  std::vector<Mark> marks;
  for (const Footstep& step : footsteps) {
    const double age_s = row.time_s - step.end_s;
    if (step.start_s > row.time_s || age_s > memory_s) continue;
    Mark mark;
    const auto foot = std::find(feet.begin(), feet.end(), step.foot);
    mark.foot = static_cast<std::size_t>(foot - feet.begin());
    mark.nominal_p_WF = step.nominal_p_WF;
    mark.adjusted_p_WF = step.adjusted_p_WF;
    mark.yaw_rad = step.yaw_rad;
    if (age_s > 0.0) mark.alpha = std::max(kOldestAlpha, 1.0 - age_s / memory_s);
    marks.push_back(mark);
  }
  const std::size_t past = marks.size();
  for (std::size_t i = 0; i < row.feet.size(); ++i) {
    const FootRow& foot = row.feet[i];
    const auto is_same = [&](const Mark& mark) {
      return mark.foot == i && (mark.nominal_p_WF - foot.nominal_p_WF).norm() < kSamePlace_m &&
             (mark.adjusted_p_WF - foot.adjusted_p_WF).norm() < kSamePlace_m;
    };
    const auto end = marks.begin() + static_cast<std::ptrdiff_t>(past);
    const auto same = std::find_if(marks.begin(), end, is_same);
    if (same != end) {
      same->alpha = 1.0;
    } else {
      const double yaw_rad = i < feet.size() ? YawFrom(row.time_s, feet[i], footsteps) : 0.0;
      marks.push_back({i, foot.nominal_p_WF, foot.adjusted_p_WF, yaw_rad, 1.0});
    }
  }
  return marks;
}

}  // namespace

std::vector<Decoration> FootholdMarks(const StateRow& row, const std::vector<std::string>& feet,
                                      const std::vector<Footstep>& footsteps,
                                      const std::vector<Sole>& soles, double memory_s,
                                      const DrawScale& scale) {
  std::vector<Decoration> decorations;
  for (const Mark& mark : MarksAt(row, feet, footsteps, memory_s)) {
    const std::string name = mark.foot < feet.size() ? feet[mark.foot] : std::string();
    AddMark(mark, RectangleOf(name, soles, scale), scale, &decorations);
  }
  return decorations;
}

}  // namespace sidestep::render
