// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/leg_reach.h"

#include "controller/mpc/structured/core_math.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

// Sets leg = [r; e] of `block` in stage k.
void MeasureLeg(const ProblemView& problem, const double* point, int k, const ContactBlock& block,
                double* leg) {
  Fill(leg, 4, 0.0);
  if (block.leg_length <= 0.0 || k == 0) return;
  double moved[3] = {0.0, 0.0, 0.0};
  if (block.location >= 0) {
    Rotate(problem.rotation + 9 * block.location, point + problem.at.d + 3 * block.location, moved);
  }
  double square = 0.0;
  for (int a = 0; a < 3; ++a) {
    leg[a] = point[kStateSize * k + a] + block.leg_anchor[a] - moved[a];
    square += leg[a] * leg[a];
  }
  leg[3] = Max(0.0, 0.5 * (square / block.leg_length - block.leg_length));
}

}  // namespace

double LegCost(const ProblemView& problem, const double* point) {
  if (problem.weight_leg == 0.0) return 0.0;
  double sum = 0.0;
  for (int k = 1; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      double leg[4];
      MeasureLeg(problem, point, k, problem.blocks[b], leg);
      sum += leg[3] * leg[3];
    }
  }
  return 0.5 * problem.weight_leg * sum;
}

void LinearizeLegs(const ProblemView& problem, const double* point, Linearization* out) {
  if (problem.weight_leg == 0.0) return;
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      const ContactBlock& block = problem.blocks[b];
      double* leg = out->leg + 4 * b;
      MeasureLeg(problem, point, k, block, leg);
      if (leg[3] == 0.0) continue;
      double slope[3], slope_F[3];
      for (int a = 0; a < 3; ++a) {
        slope[a] = problem.weight_leg * leg[3] * leg[a] / block.leg_length;
        out->gradient[kStateSize * k + a] += slope[a];
      }
      if (block.location < 0) continue;
      RotateBack(problem.rotation + 9 * block.location, slope, slope_F);
      double* gradient = out->gradient + problem.at.d + 3 * block.location;
      for (int a = 0; a < 3; ++a) gradient[a] -= slope_F[a];
    }
  }
}

void LegCurvature(const ProblemView& problem, const Linearization& linear, int b,
                  double* curvature) {
  Fill(curvature, 9, 0.0);
  const double* leg = linear.leg + 4 * b;
  if (problem.weight_leg == 0.0 || leg[3] == 0.0) return;
  const double length = problem.blocks[b].leg_length;
  for (int a = 0; a < 3; ++a) {
    for (int c = 0; c < 3; ++c) {
      curvature[3 * a + c] =
          problem.weight_leg * (leg[a] * leg[c] / length + (a == c ? leg[3] : 0.0)) / length;
    }
  }
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
