// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/structured_problem.h"

#include <algorithm>

namespace sidestep::mpc::structured {
namespace {

constexpr int RoundUp(int count) { return (count + 3) / 4 * 4; }

}  // namespace

int StructuredProblem::LocationIndex(int contact, int phase) const {
  for (std::size_t i = 0; i < locations_.size(); ++i) {
    if (locations_[i].contact == contact && locations_[i].phase == phase) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

// Room for every contact active at every knot. At one knot a contact has at most two locations:
// the one it stands on and the next, which starts there.
void StructuredProblem::Reserve(const CentroidalOcp& ocp) {
  std::size_t vertices = 0;
  for (const OcpContact& contact : ocp.contacts)
    vertices += Size(static_cast<int>(contact.vertices_m.cols()));
  const std::size_t contacts = ocp.contacts.size();
  const std::size_t stages = Size(ocp.knots + 1);
  const std::size_t slots = vertices * stages;
  const std::size_t faces = Size(static_cast<int>(ocp.friction_b.size()));
  const std::size_t locations = contacts * stages;
  const std::size_t pivots = 3 * vertices + 3 * contacts + 3;
  const std::size_t active = pivots + kStateSize + 1 + 3 * contacts + 3;
  const std::size_t rows = active + 3 * vertices + 3;
  stages_.reserve(stages);
  blocks_.reserve(contacts * stages);
  block_contact_.reserve(contacts * stages);
  block_phase_.reserve(contacts * stages);
  coupled_.reserve(2 * contacts * stages);
  carries_.reserve((1 + 5 * contacts) * stages);
  locations_.reserve(locations);
  first_pivot_.reserve(stages * (rows / 4 + 1));
  const std::size_t data =
      16 * stages + (4 + 3 * faces) * slots + faces + 3 * vertices + 27 * locations;
  const std::size_t matrices = stages * (pivots * (rows + 1) + 9 * active);
  arena_.Reset(data + matrices, 16 + 3 * stages);
}

void StructuredProblem::FindLocations(const CentroidalOcp& ocp) {
  locations_.clear();
  for (int i = 0; i < static_cast<int>(ocp.contacts.size()); ++i) {
    const auto& phases = ocp.contacts[Size(i)].phases;
    for (int q = 0; q < static_cast<int>(phases.size()); ++q) {
      const ContactPhase& phase = phases[Size(q)];
      if (!phase.fixed && phase.first_knot <= ocp.knots) {
        locations_.push_back({i, q, phase.first_knot, phase.end_knot});
      }
    }
  }
}

void StructuredProblem::AddBlocks(const CentroidalOcp& ocp, int k) {
  Stage& stage = stages_[Size(k)];
  stage.first_block = static_cast<int>(blocks_.size());
  for (int i = 0; i < static_cast<int>(ocp.contacts.size()) && k < ocp.knots; ++i) {
    const OcpContact& contact = ocp.contacts[Size(i)];
    const int q = ActivePhase(contact, k);
    if (q < 0) continue;
    const ContactPhase& phase = contact.phases[Size(q)];
    ContactBlock block;
    block.first = stage.num_slots;
    block.count = static_cast<int>(contact.vertices_m.cols());
    block.location = LocationIndex(i, q);
    block.has_previous_force = k == 0 && contact.has_previous_force;
    block.is_new = phase.first_knot == ocp.knots - 1;
    if (k > phase.first_knot) {
      const Stage& before = stages_[Size(k - 1)];
      for (int b = before.first_block; b < before.first_block + before.num_blocks; ++b) {
        if (block_contact_[Size(b)] != i) continue;
        block.previous = blocks_[Size(b)].first;
        blocks_[Size(b)].next = block.first;
        block.kept = stage.num_kept;
        stage.num_kept += block.count;
      }
    }
    stage.num_slots += block.count;
    ++stage.num_blocks;
    blocks_.push_back(block);
    block_contact_.push_back(i);
    block_phase_.push_back(q);
  }
}

// A location couples to stages from the one where its foot lands to the last that it pushes in.
void StructuredProblem::AddCoupled(int k) {
  Stage& stage = stages_[Size(k)];
  stage.first_coupled = static_cast<int>(coupled_.size());
  for (const bool is_new : {true, false}) {
    for (int i = 0; i < static_cast<int>(locations_.size()); ++i) {
      const Location& location = locations_[Size(i)];
      const bool is_coupled = is_new ? location.first_knot == k
                                     : location.first_knot < k && k < location.end_knot &&
                                           k < static_cast<int>(stages_.size()) - 1;
      if (!is_coupled) continue;
      coupled_.push_back({i, 0, 0});
      stage.num_new += is_new ? 1 : 0;
      ++stage.num_coupled;
    }
  }
}

void StructuredProblem::SetRows(int k) {
  Stage& stage = stages_[Size(k)];
  stage.num_pivots = RoundUp(3 * stage.num_slots + 3 * stage.num_new);
  const int num_old = stage.num_coupled - stage.num_new;
  stage.num_active = stage.num_pivots + RoundUp(kStateSize + 1 + 3 * num_old);
  stage.num_rows = stage.num_active + RoundUp(3 * stage.num_kept);
  for (int i = 0; i < stage.num_coupled; ++i) {
    CoupledLocation& coupled = coupled_[Size(stage.first_coupled + i)];
    coupled.row = i < stage.num_new ? 3 * stage.num_slots + 3 * i
                                    : stage.num_pivots + kOneRow + 1 + 3 * (i - stage.num_new);
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      if (blocks_[Size(b)].location == coupled.location)
        blocks_[Size(b)].coupled = stage.first_coupled + i;
    }
    if (k == 0) continue;
    const Stage& before = stages_[Size(k - 1)];
    for (int j = before.first_coupled; j < before.first_coupled + before.num_coupled; ++j) {
      if (coupled_[Size(j)].location == coupled.location)
        coupled.row_before = coupled_[Size(j)].row;
    }
  }
}

// Row i of the forces that continue is coupled to its own force among the pivots only, so that its
// row of the factor starts there.
void StructuredProblem::AddMemory(int k) {
  Stage& stage = stages_[Size(k)];
  stage.panel = arena_.Take(Size(stage.num_rows * stage.num_pivots));
  stage.inverse_pivot = arena_.Take(Size(stage.num_pivots));
  stage.dynamics = arena_.Take(Size(stage.num_active * kStateSize));
  std::fill_n(stage.dynamics, stage.num_active * kStateSize, 0.0);
  const std::size_t first = first_pivot_.size();
  first_pivot_.resize(first + Size(stage.num_rows / 4), 0);
  stage.first_pivot = first_pivot_.data() + first;  // Reserved: does not move.
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = blocks_[Size(b)];
    if (block.previous < 0) continue;
    for (int a = 0; a < 3; ++a) {
      for (int j = 0; j < block.count; ++j) {
        const int row = stage.num_active + a * stage.num_kept + block.kept + j;
        if (row % 4 != 0) continue;
        stage.first_pivot[row / 4] = (a * stage.num_slots + block.first + j) / 4 * 4;
      }
    }
  }
}

// What stage k + 1 keeps besides its state, in the rows of stage k.
void StructuredProblem::AddCarries(int k) {
  Stage& stage = stages_[Size(k)];
  const Stage& next = stages_[Size(k + 1)];
  stage.first_carry = static_cast<int>(carries_.size());
  carries_.push_back({kOneRow, stage.num_pivots + kOneRow, 1});
  for (int i = next.first_coupled + next.num_new; i < next.first_coupled + next.num_coupled; ++i) {
    const CoupledLocation& coupled = coupled_[Size(i)];
    carries_.push_back({coupled.row - next.num_pivots, coupled.row_before, 3});
  }
  for (int a = 0; a < 3; ++a) {
    for (int b = next.first_block; b < next.first_block + next.num_blocks; ++b) {
      const ContactBlock& block = blocks_[Size(b)];
      if (block.previous < 0) continue;
      const int from = next.num_active - next.num_pivots + a * next.num_kept + block.kept;
      const int to = a * stage.num_slots + block.previous;
      Carry& last = carries_.back();
      if (last.from + last.count == from && last.to + last.count == to) {
        last.count += block.count;
      } else {
        carries_.push_back({from, to, block.count});
      }
    }
  }
  stage.num_carries = static_cast<int>(carries_.size()) - stage.first_carry;
}

void StructuredProblem::FillBlock(const CentroidalOcp& ocp, const Stage& stage, std::size_t b) {
  ContactBlock& block = blocks_[b];
  const OcpContact& contact = ocp.contacts[Size(block_contact_[b])];
  const ContactPhase& phase = contact.phases[Size(block_phase_[b])];
  const Eigen::Vector3d origin_W = phase.fixed ? phase.p_WF : phase.nominal_p_WF;
  double* anchor = anchor_ + 3 * stage.first_slot;
  double* face = face_ + 3 * view_.num_faces * stage.first_slot;
  block.has_shares = contact.force_shares.size() != 0;
  block.share_square = MeanSquareShare(contact);
  block.leg_length = contact.leg.length_m;
  const Eigen::Vector3d leg_anchor_W = phase.R_WF * contact.leg.offset_m - origin_W;
  for (int a = 0; a < 3; ++a) block.leg_anchor[a] = leg_anchor_W(a);
  for (int j = 0; j < block.count; ++j) {
    relative_share_[stage.first_slot + block.first + j] = RelativeShare(contact, j);
    const Eigen::Vector3d vertex_W = origin_W + phase.R_WF * contact.vertices_m.col(j);
    for (int a = 0; a < 3; ++a) anchor[a * stage.num_slots + block.first + j] = vertex_W(a);
    if (block.has_previous_force) {
      for (int a = 0; a < 3; ++a) {
        previous_u_[a * stage.num_slots + block.first + j] =
            contact.previous_force_N(a, j) / ocp.mass_kg;
      }
    }
  }
  for (int r = 0; r < view_.num_faces; ++r) {
    const Eigen::RowVector3d row_W = ocp.friction_A.row(r) * phase.R_WF.transpose();
    for (int a = 0; a < 3; ++a) {
      double* values = face + (3 * r + a) * stage.num_slots + block.first;
      std::fill(values, values + block.count, row_W(a));
    }
  }
}

void StructuredProblem::FillLocations(const CentroidalOcp& ocp) {
  for (std::size_t i = 0; i < locations_.size(); ++i) {
    const Location& location = locations_[i];
    const ContactPhase& phase = ocp.contacts[Size(location.contact)].phases[Size(location.phase)];
    const int num_knots = std::min(location.end_knot, ocp.knots + 1) - location.first_knot;
    const Eigen::Matrix3d hessian =
        num_knots * phase.R_WF.transpose() * ocp.weights.contact_position.asDiagonal() * phase.R_WF;
    for (int a = 0; a < 3; ++a) {
      for (int c = 0; c < 3; ++c) {
        rotation_[9 * i + Size(3 * a + c)] = phase.R_WF(a, c);
        location_hessian_[9 * i + Size(3 * a + c)] = hessian(a, c);
      }
      const std::size_t entry = 3 * i + Size(a);
      box_lower_[entry] = phase.box_lower_m(a);
      box_upper_[entry] = phase.box_upper_m(a);
      is_free_[entry] = box_upper_[entry] - box_lower_[entry] < kThinBox_m ? 0.0 : 1.0;
    }
  }
}

void StructuredProblem::FillVectors(const CentroidalOcp& ocp) {
  const double mass_kg = ocp.mass_kg;
  for (int k = 0; k <= ocp.knots; ++k) {
    for (int a = 0; a < 3; ++a) {
      reference_[9 * k + a] = ocp.reference_p_WC(a, k);
      reference_[9 * k + 3 + a] = 0.0;
      reference_[9 * k + 6 + a] = ocp.reference_angular_momentum(a, k) / mass_kg;
      if (k == ocp.knots) continue;
      step_s_[k] = ocp.StepAt(k);
      drift_[6 * k + a] = ocp.gravity_mps2(a) + ocp.external_force_N(a, k) / mass_kg;
      drift_[6 * k + 3 + a] = ocp.external_torque_Nm(a, k) / mass_kg;
    }
  }
  for (int r = 0; r < view_.num_faces; ++r) bound_[r] = ocp.friction_b(r) / mass_kg;
  const double inverse_square = 1.0 / (ocp.step_s * ocp.step_s);
  view_.weight_leg = ocp.weights.leg_length;
  view_.weight_load = ocp.weights.foot_load;
  view_.load_limit = ocp.foot_load_limit_N / mass_kg;
  for (int a = 0; a < 3; ++a) {
    view_.weight_com[a] = ocp.weights.com(a);
    view_.weight_momentum[a] = ocp.weights.angular_momentum(a);
    view_.weight_symmetry[a] = ocp.weights.force_symmetry(a);
    view_.weight_rate[a] = ocp.weights.force_rate(a) * inverse_square;
    view_.weight_new[a] = ocp.weights.new_contact_force(a);
  }
}

void StructuredProblem::ScaleCost(double factor) {
  view_.weight_leg *= factor;
  view_.weight_load *= factor;
  for (double* weights : {view_.weight_com, view_.weight_momentum, view_.weight_symmetry,
                          view_.weight_rate, view_.weight_new}) {
    for (int a = 0; a < 3; ++a) weights[a] *= factor;
  }
  for (std::size_t i = 0; i < 9 * locations_.size(); ++i) location_hessian_[i] *= factor;
}

}  // namespace sidestep::mpc::structured
