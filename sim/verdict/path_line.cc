// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/path_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sidestep {
namespace {

constexpr double kChord_s = 0.01;
constexpr double kAsNear_m = 1e-9;  // far above rounding, far below what matters

struct Nearest {
  double share;  // of the way along the chord
  double distance_m;
};

// The point of the chord from `a` to `b` nearest to (x, y); of a chord without length the one at
// `preferred_share`. In scalars: this is most of the judge's work.
Nearest NearestOfChord(double x_m, double y_m, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                       double preferred_share) {
  const double* const from = a.data();
  const double* const to = b.data();
  const double along_x = to[0] - from[0], along_y = to[1] - from[1];
  const double off_x = x_m - from[0], off_y = y_m - from[1];
  const double squared_m2 = along_x * along_x + along_y * along_y;
  const double wanted =
      squared_m2 > 0.0 ? (off_x * along_x + off_y * along_y) / squared_m2 : preferred_share;
  const double share = std::clamp(wanted, 0.0, 1.0);
  return {share, std::hypot(off_x - share * along_x, off_y - share * along_y)};
}

}  // namespace

PathLine::PathLine(const NominalMotion& nominal)
    : stride_(std::max<Tick>(1, TickAt(kChord_s, nominal.tick_s()))) {
  for (Tick tick = 0; points_.size() < 2 || tick <= nominal.end_tick(); tick += stride_) {
    points_.push_back(nominal.ComAt(tick).p_WC.head<2>());
  }
}

PathLine::Point PathLine::NearestTo(const Eigen::Vector2d& p_W, double around, double reach,
                                    Tick now) const {
  const auto stride = static_cast<double>(stride_);
  const auto last_chord = static_cast<double>(points_.size() - 2);
  const double first = std::clamp(std::floor((around - reach) / stride), 0.0, last_chord);
  const double last = std::clamp(std::floor((around + reach) / stride), first, last_chord);
  const auto now_tick = static_cast<double>(now);
  double best_tick = 0.0;
  double best_m = std::numeric_limits<double>::infinity();
  for (double chord = first; chord <= last; ++chord) {
    const Nearest nearest =
        NearestOfChord(p_W.x(), p_W.y(), points_[static_cast<std::size_t>(chord)],
                       points_[static_cast<std::size_t>(chord) + 1], now_tick / stride - chord);
    const double tick = stride * (chord + nearest.share);
    const bool is_sooner = std::abs(tick - now_tick) < std::abs(best_tick - now_tick);
    if (nearest.distance_m < best_m - kAsNear_m ||
        (nearest.distance_m <= best_m + kAsNear_m && is_sooner)) {
      best_tick = tick;
      best_m = nearest.distance_m;
    }
  }
  return {best_tick, At(best_tick)};
}

Eigen::Vector2d PathLine::At(double tick) const {
  const double chord =
      std::clamp(tick / static_cast<double>(stride_), 0.0, static_cast<double>(points_.size() - 1));
  const auto at = std::min(static_cast<std::size_t>(chord), points_.size() - 2);
  return points_[at] + (chord - static_cast<double>(at)) * (points_[at + 1] - points_[at]);
}

}  // namespace sidestep
