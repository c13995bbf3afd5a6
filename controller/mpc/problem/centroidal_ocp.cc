// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/centroidal_ocp.h"

#include <cmath>

#include "models/support/require.h"

namespace sidestep::mpc {
namespace {

void CheckContact(const OcpContact& contact) {
  const Eigen::Index num_vertices = contact.vertices_m.cols();
  SIDESTEP_REQUIRE(num_vertices >= 1, num_vertices);
  if (contact.has_previous_force) {
    SIDESTEP_REQUIRE(contact.previous_force_N.cols() == num_vertices,
                     contact.previous_force_N.cols());
  }
  if (contact.force_shares.size() != 0) {
    SIDESTEP_REQUIRE(contact.force_shares.size() == num_vertices, contact.force_shares.size());
    const double excess = contact.force_shares.sum() - 1.0;
    SIDESTEP_REQUIRE(!(std::abs(excess) > kShareTolerance), excess);  // NaN: see CheckShapes().
  }
  int free_from = 0;  // The first knot that no earlier phase occupies.
  for (const ContactPhase& phase : contact.phases) {
    SIDESTEP_REQUIRE(phase.first_knot >= free_from, phase.first_knot);
    SIDESTEP_REQUIRE(phase.end_knot > phase.first_knot, phase.end_knot);
    free_from = phase.end_knot;
  }
}

bool IsFinite(const ContactPhase& phase) {
  return phase.R_WF.allFinite() &&
         (phase.fixed ? phase.p_WF.allFinite()
                      : phase.nominal_p_WF.allFinite() && phase.box_lower_m.allFinite() &&
                            phase.box_upper_m.allFinite());
}

bool IsFinite(const MpcWeights& weights) {
  return weights.com.allFinite() && std::isfinite(weights.leg_length) &&
         std::isfinite(weights.foot_load) && weights.angular_momentum.allFinite() &&
         weights.contact_position.allFinite() && weights.force_symmetry.allFinite() &&
         weights.force_rate.allFinite() && weights.new_contact_force.allFinite();
}

}  // namespace

double RelativeShare(const OcpContact& contact, Eigen::Index vertex) {
  if (contact.force_shares.size() == 0) return 1.0;
  return static_cast<double>(contact.force_shares.size()) * contact.force_shares(vertex);
}

double MeanSquareShare(const OcpContact& contact) {
  if (contact.force_shares.size() == 0) return 1.0;
  return static_cast<double>(contact.force_shares.size()) * contact.force_shares.squaredNorm();
}

int ActivePhase(const OcpContact& contact, int k) {
  for (std::size_t q = 0; q < contact.phases.size(); ++q) {
    if (contact.phases[q].first_knot <= k && k < contact.phases[q].end_knot) {
      return static_cast<int>(q);
    }
  }
  return -1;
}

void CheckShapes(const CentroidalOcp& ocp) {
  SIDESTEP_REQUIRE(ocp.knots >= 1, ocp.knots);
  // Written so that NaN and infinity pass: non-finite data are a status of the solver, not a broken
  // contract.
  SIDESTEP_REQUIRE(!(ocp.step_s <= 0.0), ocp.step_s);
  const double first_step_s = ocp.StepAt(0);
  SIDESTEP_REQUIRE(!(first_step_s <= 0.0), first_step_s);
  SIDESTEP_REQUIRE(!(first_step_s > ocp.step_s && std::isfinite(first_step_s)), first_step_s);
  SIDESTEP_REQUIRE(!(ocp.mass_kg <= 0.0), ocp.mass_kg);
  SIDESTEP_REQUIRE(!(ocp.foot_load_limit_N < 0.0), ocp.foot_load_limit_N);
  const Eigen::Index num_inputs = ocp.knots;
  SIDESTEP_REQUIRE(ocp.reference_p_WC.cols() == num_inputs + 1, ocp.reference_p_WC.cols());
  SIDESTEP_REQUIRE(ocp.reference_angular_momentum.cols() == num_inputs + 1,
                   ocp.reference_angular_momentum.cols());
  SIDESTEP_REQUIRE(ocp.external_force_N.cols() == num_inputs, ocp.external_force_N.cols());
  SIDESTEP_REQUIRE(ocp.external_torque_Nm.cols() == num_inputs, ocp.external_torque_Nm.cols());
  SIDESTEP_REQUIRE(ocp.friction_A.rows() == ocp.friction_b.size(), ocp.friction_b.size());
  for (const OcpContact& contact : ocp.contacts) {
    CheckContact(contact);
  }
}

bool IsFinite(const CentroidalOcp& ocp) {
  bool finite = std::isfinite(ocp.step_s) && std::isfinite(ocp.StepAt(0)) &&
                std::isfinite(ocp.mass_kg) && ocp.gravity_mps2.allFinite() &&
                ocp.initial_p_WC.allFinite() && ocp.initial_linear_momentum.allFinite() &&
                ocp.initial_angular_momentum.allFinite() && ocp.reference_p_WC.allFinite() &&
                ocp.reference_angular_momentum.allFinite() && ocp.external_force_N.allFinite() &&
                ocp.external_torque_Nm.allFinite() && IsFinite(ocp.weights) &&
                std::isfinite(ocp.foot_load_limit_N) && ocp.friction_A.allFinite() &&
                ocp.friction_b.allFinite();
  for (const OcpContact& contact : ocp.contacts) {
    finite = finite && contact.leg.offset_m.allFinite() && std::isfinite(contact.leg.length_m) &&
             contact.vertices_m.allFinite() && contact.force_shares.allFinite() &&
             (!contact.has_previous_force || contact.previous_force_N.allFinite());
    for (const ContactPhase& phase : contact.phases) {
      finite = finite && IsFinite(phase);
    }
  }
  return finite;
}

bool HasEmptyBox(const CentroidalOcp& ocp) {
  for (const OcpContact& contact : ocp.contacts) {
    for (const ContactPhase& phase : contact.phases) {
      if (!phase.fixed && phase.first_knot <= ocp.knots &&
          (phase.box_lower_m.array() > phase.box_upper_m.array()).any()) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace sidestep::mpc
