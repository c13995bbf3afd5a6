// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/solution_shape.h"

namespace sidestep::mpc {

void ResetToShape(const CentroidalOcp& ocp, MpcSolution* solution) {
  const Eigen::Index num_states = ocp.knots + 1;
  solution->p_WC.setZero(3, num_states);
  solution->linear_momentum.setZero(3, num_states);
  solution->angular_momentum.setZero(3, num_states);
  solution->contacts.resize(ocp.contacts.size());
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    const OcpContact& contact = ocp.contacts[i];
    ContactSolution& part = solution->contacts[i];
    part.phase_p_WF.resize(contact.phases.size());
    for (std::size_t q = 0; q < contact.phases.size(); ++q) {
      const ContactPhase& phase = contact.phases[q];
      part.phase_p_WF[q] = phase.fixed ? phase.p_WF : phase.nominal_p_WF;
    }
    part.force_N.resize(static_cast<std::size_t>(ocp.knots));
    for (Eigen::Matrix3Xd& force : part.force_N) {
      force.setZero(3, contact.vertices_m.cols());
    }
  }
}

bool HasShape(const CentroidalOcp& ocp, const MpcSolution& solution) {
  const Eigen::Index num_states = ocp.knots + 1;
  bool matches = solution.p_WC.cols() == num_states &&
                 solution.linear_momentum.cols() == num_states &&
                 solution.angular_momentum.cols() == num_states &&
                 solution.contacts.size() == ocp.contacts.size();
  for (std::size_t i = 0; matches && i < ocp.contacts.size(); ++i) {
    const ContactSolution& part = solution.contacts[i];
    matches = part.phase_p_WF.size() == ocp.contacts[i].phases.size() &&
              part.force_N.size() == static_cast<std::size_t>(ocp.knots);
    for (std::size_t k = 0; matches && k < part.force_N.size(); ++k) {
      matches = part.force_N[k].cols() == ocp.contacts[i].vertices_m.cols();
    }
  }
  return matches;
}

bool IsFinite(const MpcSolution& solution) {
  bool finite = solution.p_WC.allFinite() && solution.linear_momentum.allFinite() &&
                solution.angular_momentum.allFinite();
  for (const ContactSolution& contact : solution.contacts) {
    for (const Eigen::Vector3d& p_WF : contact.phase_p_WF) {
      finite = finite && p_WF.allFinite();
    }
    for (const Eigen::Matrix3Xd& force_N : contact.force_N) {
      finite = finite && force_N.allFinite();
    }
  }
  return finite;
}

Eigen::Vector3d WeightShare(const CentroidalOcp& ocp, int k) {
  Eigen::Index num_vertices = 0;
  for (const OcpContact& contact : ocp.contacts) {
    if (ActivePhase(contact, k) >= 0) {
      num_vertices += contact.vertices_m.cols();
    }
  }
  if (num_vertices == 0) {
    return Eigen::Vector3d::Zero();
  }
  return -ocp.mass_kg * ocp.gravity_mps2 / static_cast<double>(num_vertices);
}

void ColdStart(const CentroidalOcp& ocp, MpcSolution* guess) {
  ResetToShape(ocp, guess);
  guess->p_WC = ocp.reference_p_WC;
  for (int k = 0; k < ocp.knots; ++k) {
    const Eigen::Vector3d share_N = WeightShare(ocp, k);
    for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
      if (ActivePhase(ocp.contacts[i], k) >= 0) {
        guess->contacts[i].force_N[static_cast<std::size_t>(k)].colwise() = share_N;
      }
    }
  }
}

}  // namespace sidestep::mpc
