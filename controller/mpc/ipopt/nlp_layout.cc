// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/ipopt/nlp_layout.h"

#include <algorithm>

namespace sidestep::mpc {

void NlpLayout::Reserve(const CentroidalOcp& ocp) {
  std::size_t num_vertices = 0;
  for (const OcpContact& contact : ocp.contacts) {
    num_vertices += static_cast<std::size_t>(contact.vertices_m.cols());
  }
  const auto num_knots = static_cast<std::size_t>(ocp.knots);
  knots_.reserve(num_knots + 1);
  slots_.reserve(num_knots * num_vertices);
  // At most every other knot starts a phase, but phases may also touch each other.
  locations_.reserve((num_knots + 1) * ocp.contacts.size());
}

void NlpLayout::AddSlots(const CentroidalOcp& ocp, int contact, int k, int* column) {
  const OcpContact& foot = ocp.contacts[static_cast<std::size_t>(contact)];
  const int q = ActivePhase(foot, k);
  if (q < 0) {
    return;
  }
  const ContactPhase& phase = foot.phases[static_cast<std::size_t>(q)];
  const int num_rows = static_cast<int>(ocp.friction_A.rows());
  for (int j = 0; j < static_cast<int>(foot.vertices_m.cols()); ++j) {
    ForceSlot slot;
    slot.contact = contact;
    slot.phase = q;
    slot.vertex = j;
    slot.knot = k;
    slot.column = *column;
    slot.friction_row = kStateSize * ocp.knots + num_rows * static_cast<int>(slots_.size());
    slot.location = LocationIndex(contact, q);
    slot.has_previous_force = k == 0 && foot.has_previous_force;
    slot.is_new = phase.first_knot == ocp.knots - 1;
    slot.anchor_W =
        (phase.fixed ? phase.p_WF : phase.nominal_p_WF) + phase.R_WF * foot.vertices_m.col(j);
    if (k > phase.first_knot) {
      const KnotLayout& before = knots_[static_cast<std::size_t>(k - 1)];
      for (int s = before.first_slot; s < before.end_slot; ++s) {
        ForceSlot& candidate = slots_[static_cast<std::size_t>(s)];
        if (candidate.contact == contact && candidate.vertex == j) {
          slot.previous_slot = s;
          candidate.next_slot = static_cast<int>(slots_.size());
        }
      }
    }
    slots_.push_back(slot);
    *column += 3;
  }
}

void NlpLayout::Build(const CentroidalOcp& ocp) {
  Reserve(ocp);
  knots_.clear();
  slots_.clear();
  locations_.clear();
  const int num_contacts = static_cast<int>(ocp.contacts.size());
  for (int i = 0; i < num_contacts; ++i) {
    const auto& phases = ocp.contacts[static_cast<std::size_t>(i)].phases;
    for (int q = 0; q < static_cast<int>(phases.size()); ++q) {
      const ContactPhase& phase = phases[static_cast<std::size_t>(q)];
      if (!phase.fixed && phase.first_knot <= ocp.knots) {
        const int num_knots = std::min(phase.end_knot, ocp.knots + 1) - phase.first_knot;
        locations_.push_back({i, q, 0, num_knots});
      }
    }
  }
  int column = 0;
  for (int k = 0; k <= ocp.knots; ++k) {
    KnotLayout knot;
    if (k > 0) {
      knot.state_column = column;
      column += kStateSize;
    }
    knot.first_slot = static_cast<int>(slots_.size());
    for (int i = 0; i < num_contacts && k < ocp.knots; ++i) {
      AddSlots(ocp, i, k, &column);
    }
    knot.end_slot = static_cast<int>(slots_.size());
    knots_.push_back(knot);
  }
  for (FreeLocation& location : locations_) {
    location.column = column;
    column += 3;
  }
  num_variables_ = column;
  num_constraints_ = kStateSize * ocp.knots +
                     static_cast<int>(ocp.friction_A.rows()) * static_cast<int>(slots_.size());
}

int NlpLayout::LocationIndex(int contact, int phase) const {
  for (std::size_t i = 0; i < locations_.size(); ++i) {
    if (locations_[i].contact == contact && locations_[i].phase == phase) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

}  // namespace sidestep::mpc
