// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/decoration.h"

#include <algorithm>
#include <cmath>

namespace sidestep::render {
namespace {

// Shares of the robot's CoM height, chosen by eye on a hopper and a biped.
constexpr double kLongestPush = 0.95;
constexpr double kLongestContact = 0.75;
constexpr double kShortestPush = 0.25;  // so that a weak push is still seen
constexpr double kPushRadius = 0.028;
constexpr double kContactRadius = 0.010;
constexpr double kTraceRadius = 0.007;
constexpr double kShadowRadius = 0.30;

constexpr double kNoForce_N = 1e-9;      // logged zeros are exact; this only rejects them
constexpr double kShortestBar_m = 1e-6;  // a bar needs a direction
constexpr double kLoadedShare = 0.02;    // of the longest arrow; shorter ones are specks

}  // namespace

Color FootColor(std::size_t foot) { return Painted(palette::Foot(foot), 0.75F); }

DrawScale ScaleFor(const StateLog& log, double com_height_m) {
  double largest_push_N = 0.0;
  std::vector<double> contact_N;
  for (const StateRow& row : log.rows) {
    largest_push_N = std::max(largest_push_N, row.push_force_W.norm());
    for (const FootRow& foot : row.feet) {
      if (foot.f_F_W.norm() > kNoForce_N) contact_N.push_back(foot.f_F_W.norm());
    }
  }
  DrawScale scale;
  scale.com_height_m = com_height_m;
  if (largest_push_N > 0.0) scale.push_m_per_N = kLongestPush * com_height_m / largest_push_N;
  if (!contact_N.empty()) {
    // The 98th percentile: one hard touch-down must not shrink every other arrow to nothing.
    const auto at = contact_N.begin() + static_cast<std::ptrdiff_t>(contact_N.size() * 98 / 100);
    std::nth_element(contact_N.begin(), at, contact_N.end());
    scale.contact_m_per_N = kLongestContact * com_height_m / *at;
  }
  return scale;
}

std::vector<Decoration> PushArrow(const StateRow& row, const DrawScale& scale) {
  const double force_N = row.push_force_W.norm();
  if (!(force_N > kNoForce_N)) return {};
  const double length_m =
      std::max(force_N * scale.push_m_per_N, kShortestPush * scale.com_height_m);
  Decoration arrow;
  arrow.shape = Shape::kArrow;
  arrow.to = row.push_point_W;
  arrow.from = row.push_point_W - length_m * row.push_force_W / force_N;
  arrow.radius_m = kPushRadius * scale.com_height_m;
  arrow.color = kPushColor;
  arrow.label = std::to_string(std::lround(force_N)) + " N";
  if (force_N < 9.95) {  // one decimal where whole newtons are too coarse
    const long tenths = std::lround(10.0 * force_N);
    arrow.label = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " N";
  }
  return {arrow};
}

std::vector<Decoration> ContactForceArrows(const StateRow& row, const DrawScale& scale) {
  std::vector<Decoration> arrows;
  for (std::size_t i = 0; i < row.feet.size(); ++i) {
    const FootRow& foot = row.feet[i];
    const double length_m = std::min(foot.f_F_W.norm() * scale.contact_m_per_N,
                                     1.5 * kLongestContact * scale.com_height_m);
    if (!(length_m > kLoadedShare * scale.com_height_m)) continue;
    Decoration arrow;
    arrow.shape = Shape::kArrow;
    arrow.from = foot.p_WF;
    arrow.to = foot.p_WF + length_m * foot.f_F_W.normalized();
    arrow.radius_m = kContactRadius * scale.com_height_m;
    arrow.color = FootColor(i);
    arrows.push_back(arrow);
  }
  return arrows;
}

std::vector<Decoration> GroundShadow(const StateRow& row, const Eigen::Vector3d& p_WC,
                                     const DrawScale& scale) {
  if (row.feet.empty()) return {};
  double floor_m = row.feet.front().nominal_p_WF.z();
  for (const FootRow& foot : row.feet) floor_m = std::min(floor_m, foot.nominal_p_WF.z());
  if (!std::isfinite(floor_m)) return {};
  Decoration shadow;
  shadow.shape = Shape::kDisc;
  shadow.from = {p_WC.x(), p_WC.y(), floor_m};
  shadow.radius_m = kShadowRadius * scale.com_height_m;
  shadow.color = kShadowColor;
  return {shadow};
}

std::vector<Decoration> ComTrace(const std::vector<Eigen::Vector3d>& p_WC, const DrawScale& scale) {
  std::vector<Decoration> lines;
  for (std::size_t i = 1; i < p_WC.size(); ++i) {
    if ((p_WC[i] - p_WC[i - 1]).norm() <= kShortestBar_m) continue;
    Decoration line;
    line.shape = Shape::kLine;
    line.from = p_WC[i - 1];
    line.to = p_WC[i];
    line.radius_m = kTraceRadius * scale.com_height_m;
    line.color = kComTraceColor;
    line.color.w() *= static_cast<float>(i) / static_cast<float>(p_WC.size());
    lines.push_back(line);
    line.from.z() = kTraceRadius * scale.com_height_m;
    line.to.z() = kTraceRadius * scale.com_height_m;
    if ((line.to - line.from).norm() > kShortestBar_m) lines.push_back(line);
  }
  return lines;
}

}  // namespace sidestep::render
