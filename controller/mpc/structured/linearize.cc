// SPDX-License-Identifier: BSD-3-Clause
// Gradients, costates and the Lagrangian's stationarity.
#include "controller/mpc/structured/core_math.h"
#include "controller/mpc/structured/evaluate.h"
#include "controller/mpc/structured/foot_load.h"
#include "controller/mpc/structured/leg_reach.h"
#include "controller/mpc/structured/share_corrections.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

// Arms and sums of forces of a stage.
void StageGeometry(const ProblemView& problem, const double* point, int k, Linearization* out) {
  const Stage& stage = problem.stages[k];
  const int n = stage.num_slots;
  const double* u = point + problem.at.u + 3 * stage.first_slot;
  const double* anchor = problem.anchor + 3 * stage.first_slot;
  double* arm = out->arm + 3 * stage.first_slot;
  double* force = out->force + 3 * k;
  Fill(force, 3, 0.0);
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    double moved[3] = {0.0, 0.0, 0.0};
    if (block.location >= 0) {
      Rotate(problem.rotation + 9 * block.location, point + problem.at.d + 3 * block.location,
             moved);
    }
    for (int a = 0; a < 3; ++a) {
      const double shift = moved[a] - point[9 * k + a];
      double sum = 0.0;
      for (int j = a * n + block.first; j < a * n + block.first + block.count; ++j) {
        arm[j] = anchor[j] + shift;
        sum += u[j];
      }
      out->block_force[3 * b + a] = sum;
      force[a] += sum;
    }
  }
}

void BlockGradient(const ProblemView& problem, const double* point, int k,
                   const ContactBlock& block, double* gradient) {
  const Stage& stage = problem.stages[k];
  for (int a = 0; a < 3; ++a) {
    const int at = problem.at.u + 3 * stage.first_slot + a * stage.num_slots + block.first;
    const double* u = point + at;
    double* slope = gradient + at;
    double sum = 0.0;
    for (int j = 0; j < block.count; ++j) sum += u[j];
    const double mean = sum / block.count;
    const double rate = problem.weight_rate[a];
    const double own = block.is_new ? problem.weight_new[a] : 0.0;
    for (int j = 0; j < block.count; ++j) {
      slope[j] = problem.weight_symmetry[a] * (u[j] - mean) + own * u[j];
    }
    if (block.has_shares) {
      AddShareSlope(problem.relative_share + stage.first_slot + block.first, u,
                    problem.weight_symmetry[a], mean, block.count, slope);
    }
    if (block.previous >= 0) {
      const Stage& before = problem.stages[k - 1];
      const double* earlier =
          point + problem.at.u + 3 * before.first_slot + a * before.num_slots + block.previous;
      for (int j = 0; j < block.count; ++j) slope[j] += rate * (u[j] - earlier[j]);
    } else if (block.has_previous_force) {
      const double* earlier = problem.previous_u + a * stage.num_slots + block.first;
      for (int j = 0; j < block.count; ++j) slope[j] += rate * (u[j] - earlier[j]);
    }
    if (block.next >= 0) {
      const Stage& after = problem.stages[k + 1];
      const double* later =
          point + problem.at.u + 3 * after.first_slot + a * after.num_slots + block.next;
      for (int j = 0; j < block.count; ++j) slope[j] += rate * (u[j] - later[j]);
    }
  }
}

void StateGradient(const ProblemView& problem, const double* point, double* gradient) {
  for (int k = 0; k <= problem.knots; ++k) {
    for (int a = 0; a < 3; ++a) {
      const int p = 9 * k + a, l = 9 * k + 6 + a;
      gradient[p] = problem.weight_com[a] * (point[p] - problem.reference[p]);
      gradient[9 * k + 3 + a] = 0.0;
      gradient[l] = problem.weight_momentum[a] * (point[l] - problem.reference[l]);
    }
  }
}

// costate_k = dJ/dx_k + A_k^T costate_{k+1}: the Lagrangian is stationary in every state.
void Costates(const ProblemView& problem, Linearization* out) {
  const int N = problem.knots;
  for (int k = N; k > 0; --k) {
    double* own = out->costate + 9 * k;
    for (int i = 0; i < 9; ++i) own[i] = out->gradient[9 * k + i];
    if (k == N) continue;
    const double step_s = problem.step_s[k];
    const double* next = own + 9;
    double pull[3];
    Cross(next + 6, out->force + 3 * k, pull);
    for (int a = 0; a < 3; ++a) {
      own[a] += next[a] + step_s * pull[a];
      own[3 + a] += next[3 + a] + step_s * next[a];
      own[6 + a] += next[6 + a];
    }
  }
}

// Largest entry of the Lagrangian's gradient in the forces of a stage.
double ForceDual(const ProblemView& problem, const double* point, int k, const Linearization& at) {
  const Stage& stage = problem.stages[k];
  const int n = stage.num_slots;
  const double* costate = at.costate + 9 * (k + 1);
  const double* arm = at.arm + 3 * stage.first_slot;
  const double* z = point + problem.at.z + problem.num_faces * stage.first_slot;
  const double* face = problem.face + 3 * problem.num_faces * stage.first_slot;
  const double* gradient = at.gradient + problem.at.u + 3 * stage.first_slot;
  const double step_s = problem.step_s[k];
  double largest = 0.0;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    for (int j = 0; j < n; ++j) {
      double slope =
          gradient[a * n + j] + step_s * (costate[3 + a] + costate[6 + b] * arm[c * n + j] -
                                          costate[6 + c] * arm[b * n + j]);
      for (int r = 0; r < problem.num_faces; ++r) {
        slope += face[(3 * r + a) * n + j] * z[r * n + j];
      }
      largest = Max(largest, Abs(slope));
    }
  }
  return largest;
}

double LocationDual(const ProblemView& problem, const double* point, const Linearization& at) {
  double largest = 0.0;
  for (int i = 0; i < problem.num_locations; ++i) {
    double slope[3];
    for (int a = 0; a < 3; ++a) slope[a] = at.gradient[problem.at.d + 3 * i + a];
    for (int k = 0; k < problem.knots; ++k) {
      const Stage& stage = problem.stages[k];
      for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
        if (problem.blocks[b].location != i) continue;
        double pull_W[3], pull_F[3];
        Cross(at.block_force + 3 * b, at.costate + 9 * (k + 1) + 6, pull_W);
        RotateBack(problem.rotation + 9 * i, pull_W, pull_F);
        for (int a = 0; a < 3; ++a) slope[a] += problem.step_s[k] * pull_F[a];
      }
    }
    for (int a = 0; a < 3; ++a) {
      const int entry = 3 * i + a;
      if (problem.is_free[entry] == 0.0) continue;
      largest = Max(largest, Abs(slope[a] - point[problem.at.lower + entry] +
                                 point[problem.at.upper + entry]));
    }
  }
  return largest;
}

void AddProduct(double slack, double multiplier, Linearization* out) {
  const double product = slack * multiplier;
  out->gap_products += product;
  out->largest_product = Max(out->largest_product, product);
  out->smallest_product = Min(out->smallest_product, product);
  out->bound_sum += multiplier;
}

void Multipliers(const ProblemView& problem, const double* point, Linearization* out) {
  out->gap_products = out->bound_sum = out->largest_product = 0.0;
  out->smallest_product = 1e300;
  const int num_faces = problem.num_faces * problem.num_slots;
  for (int i = 0; i < num_faces; ++i) {
    AddProduct(point[problem.at.s + i], point[problem.at.z + i], out);
  }
  double sum = out->bound_sum;  // Once as the friction rows', once as their slacks'.
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    if (problem.is_free[i] == 0.0) continue;
    const double d = point[problem.at.d + i];
    AddProduct(d - problem.box_lower[i], point[problem.at.lower + i], out);
    AddProduct(problem.box_upper[i] - d, point[problem.at.upper + i], out);
  }
  for (int i = 9; i < 9 * (problem.knots + 1); ++i) sum += Abs(out->costate[i]);
  out->multiplier_sum = sum + out->bound_sum;
}

}  // namespace

void Linearize(const ProblemView& problem, const double* point, Linearization* out) {
  StateGradient(problem, point, out->gradient);
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    StageGeometry(problem, point, k, out);
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      BlockGradient(problem, point, k, problem.blocks[b], out->gradient);
    }
  }
  for (int i = 0; i < problem.num_locations; ++i) {
    Rotate(problem.location_hessian + 9 * i, point + problem.at.d + 3 * i,
           out->gradient + problem.at.d + 3 * i);
  }
  LinearizeLegs(problem, point, out);
  LinearizeLoads(problem, out);
  Costates(problem, out);
  out->dual = LocationDual(problem, point, *out);
  for (int k = 0; k < problem.knots; ++k) {
    out->dual = Max(out->dual, ForceDual(problem, point, k, *out));
  }
  Multipliers(problem, point, out);
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
