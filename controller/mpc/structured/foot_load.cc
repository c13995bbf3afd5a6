// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/foot_load.h"

#include "controller/mpc/structured/core_math.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

double Excess(const ProblemView& problem, double load) {
  return Max(0.0, load - problem.load_limit);
}

}  // namespace

double LoadCost(const ProblemView& problem, const double* point) {
  if (problem.weight_load == 0.0) return 0.0;
  double sum = 0.0;
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    const double* u_z = point + problem.at.u + 3 * stage.first_slot + 2 * stage.num_slots;
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      const ContactBlock& block = problem.blocks[b];
      double load = 0.0;
      for (int j = block.first; j < block.first + block.count; ++j) load += u_z[j];
      const double excess = Excess(problem, load);
      sum += excess * excess;
    }
  }
  return 0.5 * problem.weight_load * sum;
}

void LinearizeLoads(const ProblemView& problem, Linearization* out) {
  if (problem.weight_load == 0.0) return;
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    double* slope = out->gradient + problem.at.u + 3 * stage.first_slot + 2 * stage.num_slots;
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      const ContactBlock& block = problem.blocks[b];
      const double pull = problem.weight_load * Excess(problem, out->block_force[3 * b + 2]);
      for (int j = block.first; j < block.first + block.count; ++j) slope[j] += pull;
    }
  }
}

double LoadCurvature(const ProblemView& problem, const Linearization& linear, int b) {
  return Excess(problem, linear.block_force[3 * b + 2]) > 0.0 ? problem.weight_load : 0.0;
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
