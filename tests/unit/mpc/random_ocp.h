// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// random_ocp: seeded random problems of walking, running and hopping robots, pushed and not.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc {

/// What a random problem is about; drawn first so that a test can count kinds.
struct RandomKind {
  int feet{2};
  int vertices{4};
  bool has_flight{false};
  bool has_thin_boxes{false};
  bool has_empty_box{false};     ///< Infeasible.
  bool has_force_limits{false};  ///< Least and largest normal force; infeasible if they cross.
};

namespace random_ocp {

inline double Uniform(Numbers& numbers, double low, double high) {
  return low + 0.5 * (numbers.Next() + 1.0) * (high - low);
}

inline bool Chance(Numbers& numbers, double probability) {
  return Uniform(numbers, 0.0, 1.0) < probability;
}

inline int Integer(Numbers& numbers, int low, int high) {
  return std::min(high, low + static_cast<int>(Uniform(numbers, 0.0, high - low + 1.0)));
}

inline RandomKind DrawKind(Numbers& numbers) {
  RandomKind kind;
  kind.feet = Chance(numbers, 0.25) ? 1 : 2;
  kind.vertices = Chance(numbers, 0.3) ? 1 : 4;
  kind.has_flight = kind.feet == 1 || Chance(numbers, 0.25);
  kind.has_thin_boxes = Chance(numbers, 0.2);
  kind.has_empty_box = Chance(numbers, 0.03);
  kind.has_force_limits = Chance(numbers, 0.1);
  return kind;
}

/// Friction pyramid in the contact frame, and limits of the normal force if asked for.
inline void DrawFriction(Numbers& numbers, const RandomKind& kind, CentroidalOcp* ocp) {
  const double friction = Uniform(numbers, 0.1, 1.0);
  const int rows = kind.has_force_limits ? 6 : 4;
  ocp->friction_A = Eigen::MatrixX3d::Zero(rows, 3);
  ocp->friction_A.topRows(4) << 1, 1, -friction, -1, 1, -friction, -1, -1, -friction, 1, -1,
      -friction;
  ocp->friction_b = Eigen::VectorXd::Zero(rows);
  if (!kind.has_force_limits) return;
  const double share_N = ocp->mass_kg * 9.81 / (kind.feet * kind.vertices);
  ocp->friction_A(4, 2) = -1.0;
  ocp->friction_A(5, 2) = 1.0;
  ocp->friction_b(4) = -share_N * Uniform(numbers, 0.0, 0.8);
  ocp->friction_b(5) = share_N * Uniform(numbers, 0.6, 8.0);
}

inline ContactPhase DrawPhase(Numbers& numbers, const RandomKind& kind, int first, int end,
                              const Eigen::Vector3d& place, double size_m) {
  const double yaw = 0.3 * numbers.Next();
  const Eigen::Vector3d half =
      size_m * Eigen::Vector3d(Uniform(numbers, 0.02, 0.3), Uniform(numbers, 0.02, 0.2), 0.0);
  ContactPhase phase = first == 0 && Chance(numbers, 0.9) ? FixedPhase(first, end, place)
                                                          : FreePhase(first, end, place, half);
  phase.R_WF = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(0.1 * numbers.Next(), Eigen::Vector3d::UnitX()))
                   .toRotationMatrix();
  if (kind.has_thin_boxes && Chance(numbers, 0.5)) {
    phase.box_lower_m = phase.box_upper_m = 0.3 * half;
  }
  if (kind.has_empty_box && !phase.fixed) {
    phase.box_lower_m.x() = phase.box_upper_m.x() + 0.01;
  }
  return phase;
}

inline void DrawContacts(Numbers& numbers, const RandomKind& kind, double size_m, double speed_mps,
                         CentroidalOcp* ocp) {
  const int swing = Integer(numbers, 2, 6);
  const int stance = kind.has_flight ? Integer(numbers, 2, swing) : swing + Integer(numbers, 1, 6);
  const int period = swing + stance;
  const int start = Integer(numbers, 0, period - 1);
  for (int i = 0; i < kind.feet; ++i) {
    OcpContact foot = Foot(i == 0 ? "left" : "right", kind.vertices);
    foot.vertices_m *= size_m;
    const double side_m = kind.feet == 1 ? 0.0 : (i == 0 ? 0.12 : -0.12) * size_m;
    for (int first = -start + i * period / 2 - 2 * period; first <= ocp->knots; first += period) {
      const int end = first + stance;
      if (end <= 0) continue;
      const double ahead_m = speed_mps * ocp->step_s * (first + 0.5 * stance);
      const Eigen::Vector3d place(first < 0 ? 0.0 : ahead_m, side_m,
                                  Chance(numbers, 0.1) ? 0.03 * size_m : 0.0);
      foot.phases.push_back(DrawPhase(numbers, kind, std::max(0, first), end, place, size_m));
    }
    if (!foot.phases.empty() && foot.phases[0].fixed && Chance(numbers, 0.7)) {
      foot.has_previous_force = true;
      foot.previous_force_N = Eigen::Matrix3Xd::Zero(3, kind.vertices);
      foot.previous_force_N.row(2).setConstant(ocp->mass_kg * 9.81 / (kind.feet * kind.vertices));
    }
    ocp->contacts.push_back(foot);
  }
}

/// Legs that a step of some length or a CoM that rises stretches to their ends.
inline void DrawLegs(Numbers& numbers, double size_m, CentroidalOcp* ocp) {
  ocp->weights.leg_length = std::pow(10.0, Uniform(numbers, 3.0, 6.0));
  for (OcpContact& contact : ocp->contacts) {
    contact.leg.offset_m = 0.05 * size_m * numbers.Vector3();
    contact.leg.length_m = size_m * Uniform(numbers, 0.55, 0.65);
  }
}

/// Limits between what standing on every foot takes and what running does.
inline void DrawLoads(Numbers& numbers, CentroidalOcp* ocp) {
  ocp->weights.foot_load = std::pow(10.0, Uniform(numbers, -2.0, 3.0));
  ocp->foot_load_limit_N = ocp->mass_kg * 9.81 * Uniform(numbers, 0.5, 2.0);
}

inline void DrawMotion(Numbers& numbers, double size_m, double speed_mps, CentroidalOcp* ocp) {
  const double height_m = 0.55 * size_m;
  const double mass_kg = ocp->mass_kg;
  ocp->initial_p_WC = Eigen::Vector3d(0.0, 0.0, height_m) + 0.04 * size_m * numbers.Vector3();
  ocp->initial_linear_momentum =
      mass_kg * (Eigen::Vector3d(speed_mps, 0.0, 0.0) + 0.25 * numbers.Vector3());
  ocp->initial_angular_momentum = 0.02 * mass_kg * size_m * numbers.Vector3();
  for (int k = 0; k <= ocp->knots; ++k) {
    ocp->reference_p_WC.col(k) << speed_mps * ocp->step_s * k, 0.0, height_m;
  }
  if (!Chance(numbers, 0.6)) return;
  // A push of up to the weight's share that robots of this kind are tested with.
  const Eigen::Vector3d push_N = mass_kg * Uniform(numbers, 0.0, 1.5) * numbers.Vector3();
  const int first = Integer(numbers, 0, ocp->knots - 1);
  const int last = std::min(ocp->knots - 1, first + Integer(numbers, 0, 9));
  for (int k = first; k <= last; ++k) {
    ocp->external_force_N.col(k) = push_N;
    ocp->external_torque_Nm.col(k) = Eigen::Vector3d(0.0, 0.1, 0.2 * size_m).cross(push_N);
  }
}

}  // namespace random_ocp

/// The kind of the problem that RandomOcp() makes of `seed`.
inline RandomKind KindOf(unsigned seed) {
  Numbers numbers(seed);
  return random_ocp::DrawKind(numbers);
}

/// A problem that a controller might meet on a bad day. Equal on every platform.
inline CentroidalOcp RandomOcp(unsigned seed) {
  namespace draw = random_ocp;
  Numbers numbers(seed);
  const RandomKind kind = draw::DrawKind(numbers);
  CentroidalOcp ocp = FloatingProblem(draw::Integer(numbers, 5, 20));
  ocp.name = "random_" + std::to_string(seed);
  ocp.mass_kg = std::exp(draw::Uniform(numbers, 0.0, 4.2));  // 1 to 67 kg.
  ocp.external_force_N.setZero();
  const double size_m = draw::Uniform(numbers, 0.7, 1.5);
  const double speed_mps = draw::Uniform(numbers, -0.2, 0.5);
  if (draw::Chance(numbers, 0.3)) {  // The two-legged test robots' weights.
    ocp.weights.com << 2.0, 2.0, 2000.0;
    ocp.weights.angular_momentum.setConstant(2e5);
    ocp.weights.contact_position.setConstant(2000.0);
  }
  draw::DrawFriction(numbers, kind, &ocp);
  draw::DrawContacts(numbers, kind, size_m, speed_mps, &ocp);
  draw::DrawMotion(numbers, size_m, speed_mps, &ocp);
  if (draw::Chance(numbers, 0.3)) draw::DrawLegs(numbers, size_m, &ocp);
  // Half of the solves are off the grid; a tick of a millisecond is the hundredth part of a step.
  if (draw::Chance(numbers, 0.5)) {
    ocp.first_step_s = draw::Uniform(numbers, 0.01, 1.0) * ocp.step_s;
  }
  if (draw::Chance(numbers, 0.3)) draw::DrawLoads(numbers, &ocp);
  return ocp;
}

}  // namespace sidestep::mpc
