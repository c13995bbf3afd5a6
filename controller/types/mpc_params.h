// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mpc_params: what a human may tune in the centroidal MPC.

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <utility>

#include "controller/types/field.h"

namespace sidestep {

/// Diagonals of the cost's weights, world axes; momentum and force are divided by the mass first.
/// Source: Romualdi et al. (ICRA 2022), section III-B; values as its iCub experiment, doubled
/// where its program sums without the factor 1/2.
struct MpcWeights {
  Eigen::Vector3d com{2.0, 2.0, 400.0};  ///< Per m^2. High in z: the height is to be kept.
  Eigen::Vector3d angular_momentum{200.0, 200.0, 200.0};  ///< Per (m^2/s)^2, about C.
  Eigen::Vector3d contact_position{400.0, 400.0, 400.0};  ///< Per m^2 and knot.
  Eigen::Vector3d force_symmetry{20.0, 20.0, 20.0};       ///< Per (m/s^2)^2.
  Eigen::Vector3d force_rate{0.2, 0.2, 0.2};  ///< Per (m/s^3)^2: of the change over step_s.
  /// On the force of a contact that touches down at the last input, N - 1, where nothing else
  /// makes the optimum unique.
  Eigen::Vector3d new_contact_force{0.01, 0.01, 0.01};
  double leg_length{0.0};  ///< Per m^2 and knot of a leg too short. 0, as in the paper: none.
  double foot_load{0.0};   ///< Per (m/s^2)^2 and knot above the limit. 0, as in the paper: none.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    const Range weight{0.0, 1e9};
    visit("com", self.com, weight, "CoM against its reference, per axis");
    visit("angular_momentum", self.angular_momentum, weight,
          "angular momentum about the CoM against its reference, per axis");
    visit("contact_position", self.contact_position, weight,
          "footholds against their nominal ones, per axis");
    visit("force_symmetry", self.force_symmetry, weight,
          "forces of a foot's vertices against their mean, per axis");
    visit("force_rate", self.force_rate, weight,
          "change of the forces from knot to knot, per axis");
    visit("new_contact_force", self.new_contact_force, weight,
          "forces of a foot that touches down at the last knot, per axis");
    visit("leg_length", self.leg_length, weight,
          "what a standing foot's leg lacks in length, from ankle to hip");
    visit("foot_load", self.foot_load, weight, "what a foot bears above foot_load_ratio");
  }
};

/// The solvers of the optimal control problem.
enum class MpcBackend {
  kIpopt,       ///< The reference: Ipopt with exact derivatives.
  kStructured,  ///< An interior point method of our own that exploits the stages.
};

template <>
struct EnumNames<MpcBackend> {
  static constexpr std::array<std::pair<MpcBackend, std::string_view>, 2> kNames{
      {{MpcBackend::kIpopt, "ipopt"}, {MpcBackend::kStructured, "structured"}}};
};

/// The horizon, its solver and what the controller assumes; key by key in VisitFields.
/// The horizon is knots * step_s long (1.5 s by default) and should hold at least one landing, or
/// no foothold is decided. Solves need not be on the gait's grid of steps step_s, by which contacts
/// change: the first knot lasts from the solve until the grid's next point (knot_grid.h), so that
/// solving more often than once a knot (rate_hz > 1 / step_s) and landings off their time leave
/// contact changes on knots. Times of the gait that are no multiple of step_s are rounded to the
/// nearest knot. `friction` is that of the plan alone; by default it is smaller than the world's
/// and than InverseDynamicsParams's, which leaves the forces that are realised room about the
/// planned ones. external_wrench_hold_s counts only if ControlParams::external_wrench tells of
/// pushes; a hold that ends between knots gives the last knot its share. Whoever feels a push does
/// not know how long it will last: 0.15 s of decay serves a shove and a push of a second alike.
/// plan_memory_s is for a robot that is told velocities and follows them with a lag: if every solve
/// starts from the velocity that is measured, what was asked for and is still to come is forgotten,
/// the more often the MPC solves the more of it.
struct MpcParams {
  double rate_hz{10.0};  ///< Its period is whole control periods.
  int knots{15};         ///< Cost and memory grow in proportion.
  double step_s{0.1};    ///< A whole number of physics steps.
  MpcBackend backend{MpcBackend::kStructured};
  double latency_s{0.0};   ///< Simulates the time that a solve would take; the first plan has none.
  double tolerance{1e-6};  ///< Handed to the back end as it is.
  int max_iterations{100};                       ///< Solvers stop by this, never by the clock.
  double friction{0.33};                         ///< Of the pyramid in axes of F.
  Eigen::Vector3d box_lower_m{-0.1, -0.1, 0.0};  ///< z = 0 keeps footholds on the floor.
  Eigen::Vector3d box_upper_m{0.1, 0.1, 0.0};    ///< Never below box_lower_m.
  double leg_stretch{0.97};                      ///< Counts only with weights.leg_length.
  double foot_load_ratio{1.3};                   ///< Counts only with weights.foot_load.
  double external_wrench_hold_s{0.1};
  double external_wrench_decay_s{0.0};  ///< A time constant: 1/e is left so long after the hold.
  double attitude_rate_radps{0.0};      ///< 0, as in the paper: no levelling.
  double plan_memory_s{0.0};            ///< For joints that follow the plan late.
  MpcWeights weights;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("rate_hz", self.rate_hz, Range{1.0, 1000.0}, "solves a second");
    visit("knots", self.knots, Range{2.0, 200.0}, "knots of the horizon (N of the paper)");
    visit("step_s", self.step_s, Range{0.005, 0.5}, "time between knots (T of the paper)");
    visit("backend", self.backend, "solver; both reach the same optimum");
    visit("latency_s", self.latency_s, Range{0.0, 1.0},
          "a solution is used this long after the measurement it started from");
    visit("tolerance", self.tolerance, Range{1e-12, 1e-2}, "of the scaled optimality conditions");
    visit("max_iterations", self.max_iterations, Range{1.0, 10000.0},
          "limit of iterations a solve");
    visit("friction", self.friction, Range{0.01, 10.0}, "coefficient that the MPC plans with");
    visit("box_lower_m", self.box_lower_m, Range{-2.0, 2.0},
          "least step adjustment, in the axes of the contact; y is mirrored for a right foot");
    visit("box_upper_m", self.box_upper_m, Range{-2.0, 2.0},
          "largest step adjustment, in the axes of the contact; y is mirrored for a right foot");
    visit("leg_stretch", self.leg_stretch, Range{0.1, 1.0},
          "share of a stretched leg's length that weights.leg_length takes for the longest");
    visit("foot_load_ratio", self.foot_load_ratio, Range{0.0, 100.0},
          "share of the robot's weight that weights.foot_load lets a foot bear");
    visit("external_wrench_hold_s", self.external_wrench_hold_s, Range{0.0, 10.0},
          "a measured or known external wrench is assumed to last this long");
    visit("external_wrench_decay_s", self.external_wrench_decay_s, Range{0.0, 10.0},
          "time constant with which it is assumed to fade after that (0: at once)");
    visit("attitude_rate_radps", self.attitude_rate_radps, Range{0.0, 100.0},
          "k of the angular momentum reference I k theta, which levels a base tilted by theta");
    visit(
        "plan_memory_s", self.plan_memory_s, Range{0.0, 10.0},
        "time constant with which the plan's CoM velocity gives way to the belief's (0: at once)");
    visit("weights", self.weights,
          "weights of the tasks, world axes; momentum and force are divided by the mass");
  }
};

}  // namespace sidestep
