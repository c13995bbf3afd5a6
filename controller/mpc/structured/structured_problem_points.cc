// SPDX-License-Identifier: BSD-3-Clause
// Building a problem's view, and points between SI and the core's arrays.
#include <algorithm>

#include "controller/mpc/problem/solution_shape.h"
#include "controller/mpc/structured/structured_problem.h"

namespace sidestep::mpc::structured {

void StructuredProblem::Build(const CentroidalOcp& ocp) {
  Reserve(ocp);
  FindLocations(ocp);
  stages_.assign(Size(ocp.knots + 1), Stage{});
  blocks_.clear();
  block_contact_.clear();
  block_phase_.clear();
  coupled_.clear();
  carries_.clear();
  first_pivot_.clear();
  int num_slots = 0;
  view_.num_pivots = 0;
  for (int k = 0; k <= ocp.knots; ++k) {
    AddBlocks(ocp, k);
    AddCoupled(k);
    SetRows(k);
    AddMemory(k);
    stages_[Size(k)].first_slot = num_slots;
    num_slots += stages_[Size(k)].num_slots;
    stages_[Size(k)].first_of_pivots = view_.num_pivots;
    view_.num_pivots += stages_[Size(k)].num_pivots;
  }
  for (int k = 0; k < ocp.knots; ++k) AddCarries(k);
  view_.knots = ocp.knots;
  view_.num_slots = num_slots;
  view_.num_locations = static_cast<int>(locations_.size());
  view_.num_faces = static_cast<int>(ocp.friction_b.size());
  TakeArrays();
  FillVectors(ocp);
  FillLocations(ocp);
  for (const Stage& stage : stages_) {
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      FillBlock(ocp, stage, Size(b));
    }
  }
}

void StructuredProblem::TakeArrays() {
  const std::size_t stages = stages_.size();
  const std::size_t slots = Size(view_.num_slots);
  const std::size_t faces = Size(view_.num_faces);
  view_.step_s = step_s_ = arena_.Take(Size(view_.knots));
  view_.reference = reference_ = arena_.Take(9 * stages);
  view_.drift = drift_ = arena_.Take(6 * stages);
  view_.anchor = anchor_ = arena_.Take(3 * slots);
  view_.face = face_ = arena_.Take(3 * faces * slots);
  view_.bound = bound_ = arena_.Take(faces);
  view_.relative_share = relative_share_ = arena_.Take(slots);
  view_.previous_u = previous_u_ = arena_.Take(3 * Size(stages_[0].num_slots));
  view_.rotation = rotation_ = arena_.Take(9 * locations_.size());
  view_.location_hessian = location_hessian_ = arena_.Take(9 * locations_.size());
  view_.box_lower = box_lower_ = arena_.Take(3 * locations_.size());
  view_.box_upper = box_upper_ = arena_.Take(3 * locations_.size());
  view_.is_free = is_free_ = arena_.Take(3 * locations_.size());
  view_.stages = stages_.data();
  view_.blocks = blocks_.data();
  view_.coupled = coupled_.data();
  view_.carries = carries_.data();
  PointLayout& at = view_.at;
  const int num_d = 3 * view_.num_locations;
  at.u = kStateSize * (view_.knots + 1);
  at.d = at.u + 3 * view_.num_slots;
  at.s = at.d + num_d;
  at.z = at.s + view_.num_faces * view_.num_slots;
  at.lower = at.z + view_.num_faces * view_.num_slots;
  at.upper = at.lower + num_d;
  at.size = at.upper + num_d;
}

void StructuredProblem::Pack(const CentroidalOcp& ocp, const MpcSolution& guess,
                             double* point) const {
  const double inverse_mass = 1.0 / ocp.mass_kg;
  for (int k = 0; k <= ocp.knots; ++k) {
    const bool is_first = k == 0;
    const Eigen::Vector3d hp =
        is_first ? ocp.initial_linear_momentum : Eigen::Vector3d(guess.linear_momentum.col(k));
    const Eigen::Vector3d hw =
        is_first ? ocp.initial_angular_momentum : Eigen::Vector3d(guess.angular_momentum.col(k));
    for (int a = 0; a < 3; ++a) {
      point[9 * k + a] = is_first ? ocp.initial_p_WC(a) : guess.p_WC(a, k);
      point[9 * k + 3 + a] = inverse_mass * hp(a);
      point[9 * k + 6 + a] = inverse_mass * hw(a);
    }
  }
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const Stage& stage = stages_[k];
    double* u = point + view_.at.u + 3 * stage.first_slot;
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      const ContactBlock& block = blocks_[Size(b)];
      const Eigen::Matrix3Xd& force_N = guess.contacts[Size(block_contact_[Size(b)])].force_N[k];
      for (int j = 0; j < block.count; ++j) {
        for (int a = 0; a < 3; ++a) {
          u[a * stage.num_slots + block.first + j] = inverse_mass * force_N(a, j);
        }
      }
    }
  }
  for (std::size_t i = 0; i < locations_.size(); ++i) {
    const auto contact = Size(locations_[i].contact);
    const auto q = Size(locations_[i].phase);
    const ContactPhase& phase = ocp.contacts[contact].phases[q];
    const Eigen::Vector3d moved_F =
        phase.R_WF.transpose() * (guess.contacts[contact].phase_p_WF[q] - phase.nominal_p_WF);
    for (std::size_t a = 0; a < 3; ++a) {
      point[Size(view_.at.d) + 3 * i + a] = moved_F(static_cast<Eigen::Index>(a));
    }
  }
}

void StructuredProblem::Unpack(const CentroidalOcp& ocp, const double* point,
                               MpcSolution* solution) const {
  ResetToShape(ocp, solution);
  for (int k = 0; k <= ocp.knots; ++k) {
    for (int a = 0; a < 3; ++a) {
      solution->p_WC(a, k) = point[9 * k + a];
      solution->linear_momentum(a, k) = ocp.mass_kg * point[9 * k + 3 + a];
      solution->angular_momentum(a, k) = ocp.mass_kg * point[9 * k + 6 + a];
    }
  }
  for (std::size_t k = 0; k < stages_.size(); ++k) {
    const Stage& stage = stages_[k];
    const double* u = point + view_.at.u + 3 * stage.first_slot;
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      const ContactBlock& block = blocks_[Size(b)];
      Eigen::Matrix3Xd& force_N = solution->contacts[Size(block_contact_[Size(b)])].force_N[k];
      for (int j = 0; j < block.count; ++j) {
        for (int a = 0; a < 3; ++a) {
          force_N(a, j) = ocp.mass_kg * u[a * stage.num_slots + block.first + j];
        }
      }
    }
  }
  for (std::size_t i = 0; i < locations_.size(); ++i) {
    const auto contact = Size(locations_[i].contact);
    const auto q = Size(locations_[i].phase);
    const ContactPhase& phase = ocp.contacts[contact].phases[q];
    const double* d = point + view_.at.d + 3 * i;
    solution->contacts[contact].phase_p_WF[q].noalias() =
        phase.nominal_p_WF + phase.R_WF * Eigen::Vector3d(d[0], d[1], d[2]);
  }
}

}  // namespace sidestep::mpc::structured
