// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// pendulum: closed forms of a linear inverted pendulum that walks.
//
//   dxi/dt = w (xi - p)      xi: its DCM, p: the ground's force on it acts there (VRP)
//
// Horizontal, in m. A step lasts T from one support's begin to the next's; E = e^(wT). The offset
// of a step is the DCM less the new foothold, b = xi(T) - u.
// Source: Khadiv, Herzog, Moosavian, Righetti, "Walking control based on step timing adaptation",
// IEEE Transactions on Robotics 36 (2020), arXiv:1704.01271; double support after Englsberger, Ott,
// Albu-Schaeffer, "Three-dimensional bipedal walking control based on divergent component of
// motion", IEEE Transactions on Robotics 31 (2015).

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace sidestep::dcm {

/// The offset of a gait that repeats itself every two steps: `advance_m` the part of each step that
/// is the same, `across_m` the part that changes its sign, of the step to come.
///   b = advance / (E - 1) + across / (E + 1)
Eigen::Vector2d NominalOffset(const Eigen::Vector2d& advance_m, const Eigen::Vector2d& across_m,
                              double growth);

/// From `least` to `most`.
struct Interval {
  double least{0.0};
  double most{0.0};
};

/// Forward offsets from which steps of `length_m` can still catch the pendulum, E being the
/// quickest step's: those that the farthest step forwards, or backwards, brings back to themselves.
Interval ViableForward(const Interval& length_m, double growth);

/// Sideways offsets, positive towards the other foot, from which steps of a `width_m` (of the
/// feet, > 0 so that they don't cross) can: b' = width - E b, alternating between the two bounds.
Interval ViableSideways(const Interval& width_m, double growth);

/// How long (s) after the begin of a double support of `time_s`, in which the pressure goes
/// evenly from one foot to the other, the pendulum's support might as well have jumped across.
double SwitchDelay_s(double time_s, double omega_per_s);

/// A piecewise linear path of the VRP. A value of fixed size.
class VrpPath {
 public:
  static constexpr std::size_t kMost = 24;

  void Clear() { size_ = 0; }
  /// Straight on to `p_m` at `time_s`, which is brought up to the last knot's if before it. Knots
  /// beyond kMost are a ContractViolation.
  void Add(double time_s, const Eigen::Vector2d& p_m);

  /// Where the path is; its ends hold on. At least one knot.
  Eigen::Vector2d At(double time_s) const;

  /// The DCM at `time_s` of the pendulum that arrives at `end_m` at the last knot's time, or after
  /// which rests there.
  Eigen::Vector2d DcmAt(double time_s, const Eigen::Vector2d& end_m, double omega_per_s) const;

  double end_s() const { return knots_[size_ - 1].time_s; }

 private:
  struct Knot {
    double time_s{0.0};
    Eigen::Vector2d p_m{Eigen::Vector2d::Zero()};
  };

  std::array<Knot, kMost> knots_;
  std::size_t size_{0};
};

}  // namespace sidestep::dcm
