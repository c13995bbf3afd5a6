// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// structured_problem: lays a CentroidalOcp out as the arrays that the numerical core works on.
//
// Memory grows to the largest (knots, contacts, vertices, friction rows) met so far, with every
// contact active at every knot: problems of other schedules do not allocate.

#include <vector>

#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/mpc/problem/mpc_solution.h"
#include "controller/mpc/structured/arena.h"
#include "controller/mpc/structured/problem_view.h"

namespace sidestep::mpc::structured {

class StructuredProblem {
 public:
  /// Boxes thinner than this (m) hold the foot at their middle: below the tolerance on places.
  static constexpr double kThinBox_m = 1e-8;

  /// Lays out `ocp`, whose shapes and numbers must have passed CheckShapes() and IsFinite().
  void Build(const CentroidalOcp& ocp);

  /// Multiplies the cost, until the next Build().
  void ScaleCost(double factor);

  const ProblemView& view() const { return view_; }

  /// The point of `guess`, whose shapes must be the problem's; slacks and multipliers untouched.
  void Pack(const CentroidalOcp& ocp, const MpcSolution& guess, double* point) const;

  /// The trajectories of `point` in SI; `solution` gets the problem's shapes.
  void Unpack(const CentroidalOcp& ocp, const double* point, MpcSolution* solution) const;

 private:
  struct Location {
    int contact{0};
    int phase{0};
    int first_knot{0};
    int end_knot{0};
  };

  void Reserve(const CentroidalOcp& ocp);
  void FindLocations(const CentroidalOcp& ocp);
  void AddBlocks(const CentroidalOcp& ocp, int k);
  void AddCoupled(int k);
  void SetRows(int k);
  void AddMemory(int k);
  void AddCarries(int k);
  void FillVectors(const CentroidalOcp& ocp);
  void FillLocations(const CentroidalOcp& ocp);
  void TakeArrays();
  void FillBlock(const CentroidalOcp& ocp, const Stage& stage, std::size_t b);
  int LocationIndex(int contact, int phase) const;

  ProblemView view_;
  Arena arena_;
  std::vector<Stage> stages_;
  std::vector<ContactBlock> blocks_;
  std::vector<int> block_contact_;  // One a block.
  std::vector<int> block_phase_;    // One a block.
  std::vector<CoupledLocation> coupled_;
  std::vector<Location> locations_;
  std::vector<Carry> carries_;
  std::vector<int> first_pivot_;
  double *step_s_{nullptr}, *reference_{nullptr}, *drift_{nullptr}, *anchor_{nullptr},
      *face_{nullptr}, *bound_{nullptr}, *relative_share_{nullptr}, *previous_u_{nullptr},
      *rotation_{nullptr}, *location_hessian_{nullptr}, *box_lower_{nullptr}, *box_upper_{nullptr},
      *is_free_{nullptr};
};

}  // namespace sidestep::mpc::structured
