// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mpc_test_support: problems for the tests of the MPC room.

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/mpc/problem/mpc_solution.h"
#include "controller/mpc/problem/ocp_json.h"

namespace sidestep::mpc {

inline std::filesystem::path ReferenceFolder() {
  return std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/reference";
}

/// The parsed file `name` (without .json) of the reference folder.
inline nlohmann::json ReferenceJson(const std::string& name) {
  std::ifstream file(ReferenceFolder() / (name + ".json"));
  return nlohmann::json::parse(file);
}

inline CentroidalOcp ReferenceProblem(const std::string& name) {
  return OcpFromJson(ReferenceJson(name));
}

/// One foot without phases. Four vertices are the corners of a sole, one is a point foot.
inline OcpContact Foot(const std::string& name, int num_vertices) {
  OcpContact foot;
  foot.name = name;
  foot.vertices_m = Eigen::Matrix3Xd::Zero(3, num_vertices);
  if (num_vertices == 4) {
    foot.vertices_m.row(0) << 0.1, 0.1, -0.1, -0.1;
    foot.vertices_m.row(1) << 0.05, -0.05, -0.05, 0.05;
  }
  return foot;
}

inline ContactPhase FixedPhase(int first_knot, int end_knot, const Eigen::Vector3d& p_WF) {
  ContactPhase phase;
  phase.first_knot = first_knot;
  phase.end_knot = end_knot;
  phase.fixed = true;
  phase.p_WF = p_WF;
  return phase;
}

inline ContactPhase FreePhase(int first_knot, int end_knot, const Eigen::Vector3d& nominal_p_WF,
                              const Eigen::Vector3d& half_box_m) {
  ContactPhase phase;
  phase.first_knot = first_knot;
  phase.end_knot = end_knot;
  phase.nominal_p_WF = nominal_p_WF;
  phase.box_lower_m = -half_box_m;
  phase.box_upper_m = half_box_m;
  return phase;
}

/// As the reference files have it. Not the program's own figure, so that a solver which took that
/// instead of the problem's would fail.
constexpr double kStandardGravity_mps2 = 9.80665;

/// A problem without contacts: a robot of 2 kg that floats at the origin, references zero.
inline CentroidalOcp FloatingProblem(int knots) {
  CentroidalOcp ocp;
  ocp.name = "floating";
  ocp.knots = knots;
  ocp.mass_kg = 2.0;
  ocp.gravity_mps2 << 0.0, 0.0, -kStandardGravity_mps2;
  ocp.reference_p_WC = Eigen::Matrix3Xd::Zero(3, knots + 1);
  ocp.reference_angular_momentum = Eigen::Matrix3Xd::Zero(3, knots + 1);
  ocp.external_force_N = Eigen::Matrix3Xd::Zero(3, knots);
  ocp.external_torque_Nm = Eigen::Matrix3Xd::Zero(3, knots);
  ocp.friction_A.resize(4, 3);
  ocp.friction_A << 1, 1, -0.5, -1, 1, -0.5, -1, -1, -0.5, 1, -1, -0.5;
  ocp.friction_b = Eigen::VectorXd::Zero(4);
  return ocp;
}

/// Numbers in [-1, 1] from a seeded generator that is the same on every platform.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : generator_(seed) {}

  double Next() { return static_cast<double>(generator_()) / 2147483648.0 - 1.0; }

  void Fill(Eigen::Ref<Eigen::MatrixXd> matrix) {
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) {
      for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
        matrix(r, c) = Next();
      }
    }
  }

  Eigen::Vector3d Vector3() { return {Next(), Next(), Next()}; }

  Eigen::Matrix3d Rotation() {
    return Eigen::Quaterniond(Next(), Next(), Next(), Next()).normalized().toRotationMatrix();
  }

 private:
  std::mt19937 generator_;
};

/// Replaces every number of the problem but its schedule, step and boxes by random ones, so that
/// no term can hide behind a zero or a symmetry.
inline void Randomise(Numbers& numbers, CentroidalOcp* ocp) {
  ocp->mass_kg = 3.0 + numbers.Next();
  ocp->gravity_mps2 = numbers.Vector3();
  ocp->initial_p_WC = numbers.Vector3();
  ocp->initial_linear_momentum = numbers.Vector3();
  ocp->initial_angular_momentum = numbers.Vector3();
  numbers.Fill(ocp->reference_p_WC);
  numbers.Fill(ocp->reference_angular_momentum);
  numbers.Fill(ocp->external_force_N);
  numbers.Fill(ocp->external_torque_Nm);
  numbers.Fill(ocp->friction_A);
  numbers.Fill(ocp->friction_b);
  MpcWeights& weights = ocp->weights;
  for (Eigen::Vector3d* weight :
       {&weights.com, &weights.angular_momentum, &weights.contact_position, &weights.force_symmetry,
        &weights.force_rate, &weights.new_contact_force}) {
    *weight = 2.0 * Eigen::Vector3d::Ones() + numbers.Vector3();
  }
  weights.leg_length = 2.0 + numbers.Next();
  weights.foot_load = 2.0 + numbers.Next();
  ocp->foot_load_limit_N = 0.2 * ocp->mass_kg * (1.0 + numbers.Next());  // about half above it
  for (OcpContact& contact : ocp->contacts) {
    contact.leg = {numbers.Vector3(), 1.0 + 0.5 * numbers.Next()};  // often too short
    numbers.Fill(contact.vertices_m);
    if (contact.force_shares.size() != 0) {
      const Eigen::Index count = contact.vertices_m.cols();
      for (Eigen::Index j = 0; j < count; ++j) contact.force_shares(j) = 1.5 + numbers.Next();
      contact.force_shares /= contact.force_shares.sum();
    }
    if (contact.has_previous_force) {
      numbers.Fill(contact.previous_force_N);
    }
    for (ContactPhase& phase : contact.phases) {
      phase.R_WF = numbers.Rotation();
      phase.p_WF = numbers.Vector3();
      phase.nominal_p_WF = numbers.Vector3();
    }
  }
}

/// The problem a `share` (0 to 1) of the first input later in a perfect world: the state is that of
/// the solution within its first knot, the rest of which is the new problem's.
inline CentroidalOcp AdvanceWithinAKnot(const CentroidalOcp& ocp, const MpcSolution& solution,
                                        double share) {
  CentroidalOcp next = ocp;
  next.first_step_s = (1.0 - share) * ocp.StepAt(0);
  const auto within = [share](const Eigen::Matrix3Xd& states) {
    return Eigen::Vector3d((1.0 - share) * states.col(0) + share * states.col(1));
  };
  next.initial_p_WC = within(solution.p_WC);
  next.initial_linear_momentum = within(solution.linear_momentum);
  next.initial_angular_momentum = within(solution.angular_momentum);
  next.reference_p_WC.col(0) = within(ocp.reference_p_WC);
  next.reference_angular_momentum.col(0) = within(ocp.reference_angular_momentum);
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    next.contacts[i].has_previous_force = ActivePhase(ocp.contacts[i], 0) >= 0;
    next.contacts[i].previous_force_N = solution.contacts[i].force_N[0];
  }
  return next;
}

/// The problem one step later in a perfect world: the state is the solution's next one, the last
/// reference repeats, the schedule moves on, feet on the ground are where they were planned.
inline CentroidalOcp AdvanceProblem(const CentroidalOcp& ocp, const MpcSolution& solution) {
  CentroidalOcp next = ocp;
  next.first_step_s.reset();
  next.initial_p_WC = solution.p_WC.col(1);
  next.initial_linear_momentum = solution.linear_momentum.col(1);
  next.initial_angular_momentum = solution.angular_momentum.col(1);
  const int N = ocp.knots;
  next.reference_p_WC.leftCols(N) = ocp.reference_p_WC.rightCols(N);
  next.reference_angular_momentum.leftCols(N) = ocp.reference_angular_momentum.rightCols(N);
  next.external_force_N.leftCols(N - 1) = ocp.external_force_N.rightCols(N - 1);
  next.external_torque_Nm.leftCols(N - 1) = ocp.external_torque_Nm.rightCols(N - 1);
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    OcpContact& contact = next.contacts[i];
    contact.has_previous_force = ActivePhase(ocp.contacts[i], 0) >= 0;
    contact.previous_force_N = solution.contacts[i].force_N[0];
    contact.phases.clear();
    for (std::size_t q = 0; q < ocp.contacts[i].phases.size(); ++q) {
      ContactPhase phase = ocp.contacts[i].phases[q];
      const bool lands_now = phase.first_knot == 1;
      phase.first_knot = std::max(0, phase.first_knot - 1);
      // A stay that reaches the end of the horizon goes on.
      phase.end_knot -= phase.end_knot > N ? 0 : 1;
      if (lands_now) {
        phase.fixed = true;
        phase.p_WF = solution.contacts[i].phase_p_WF[q];
      }
      if (phase.end_knot > phase.first_knot) {
        contact.phases.push_back(phase);
      }
    }
  }
  return next;
}

}  // namespace sidestep::mpc
