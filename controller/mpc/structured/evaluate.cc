// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/evaluate.h"

#include "controller/mpc/structured/core_math.h"
#include "controller/mpc/structured/foot_load.h"
#include "controller/mpc/structured/leg_reach.h"
#include "controller/mpc/structured/share_corrections.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

// Natural logarithms of a product are dearer than the product: eight factors between 1e-30 and
// 1e30 neither overflow nor underflow.
class LogSum {
 public:
  void Add(double factor) {
    product_ *= factor;
    if (++count_ == 8) Flush();
  }
  double Value() {
    Flush();
    return sum_;
  }

 private:
  void Flush() {
    sum_ += __builtin_log(product_);
    product_ = 1.0;
    count_ = 0;
  }
  double product_{1.0};
  double sum_{0.0};
  int count_{0};
};

double WeightedSquare(const double* weight, double x, double y, double z) {
  return 0.5 * (weight[0] * x * x + weight[1] * y * y + weight[2] * z * z);
}

double StateCost(const ProblemView& problem, const double* point) {
  double cost = 0.0;
  for (int k = 0; k <= problem.knots; ++k) {
    const double* x = point + 9 * k;
    const double* r = problem.reference + 9 * k;
    cost += WeightedSquare(problem.weight_com, x[0] - r[0], x[1] - r[1], x[2] - r[2]);
    cost += WeightedSquare(problem.weight_momentum, x[6] - r[6], x[7] - r[7], x[8] - r[8]);
  }
  return cost;
}

double LocationCost(const ProblemView& problem, const double* point) {
  double cost = 0.0;
  for (int i = 0; i < problem.num_locations; ++i) {
    const double* d = point + problem.at.d + 3 * i;
    double slope[3];
    Rotate(problem.location_hessian + 9 * i, d, slope);
    cost += 0.5 * (d[0] * slope[0] + d[1] * slope[1] + d[2] * slope[2]);
  }
  return cost;
}

// u of the same vertex and axis one knot earlier, or null where no rate term exists.
const double* Earlier(const ProblemView& problem, const double* point, int k,
                      const ContactBlock& block, int a) {
  const Stage& stage = problem.stages[k];
  if (block.previous >= 0) {
    const Stage& before = problem.stages[k - 1];
    return point + problem.at.u + 3 * before.first_slot + a * before.num_slots + block.previous;
  }
  return block.has_previous_force ? problem.previous_u + a * stage.num_slots + block.first
                                  : nullptr;
}

double BlockCost(const ProblemView& problem, const double* point, int k,
                 const ContactBlock& block) {
  const Stage& stage = problem.stages[k];
  double cost = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double* u =
        point + problem.at.u + 3 * stage.first_slot + a * stage.num_slots + block.first;
    const double* earlier = Earlier(problem, point, k, block, a);
    double sum = 0.0, squares = 0.0, jumps = 0.0;
    for (int j = 0; j < block.count; ++j) sum += u[j];
    const double mean = sum / block.count;
    double deviations = 0.0;
    for (int j = 0; j < block.count; ++j) {
      deviations += (u[j] - mean) * (u[j] - mean);
      squares += u[j] * u[j];
    }
    if (block.has_shares) {
      deviations = SquaresBesideShares(problem.relative_share + stage.first_slot + block.first, u,
                                       mean, block.count);
    }
    if (earlier != nullptr) {
      for (int j = 0; j < block.count; ++j) jumps += (u[j] - earlier[j]) * (u[j] - earlier[j]);
    }
    cost += 0.5 * (problem.weight_symmetry[a] * deviations + problem.weight_rate[a] * jumps);
    if (block.is_new) cost += 0.5 * problem.weight_new[a] * squares;
  }
  return cost;
}

// Gap of the dynamics from knot k to k + 1.
void Gap(const ProblemView& problem, const double* point, int k, double* gap) {
  const Stage& stage = problem.stages[k];
  const double step_s = problem.step_s[k];
  const double* x = point + 9 * k;
  const double* u = point + problem.at.u + 3 * stage.first_slot;
  const double* anchor = problem.anchor + 3 * stage.first_slot;
  const int n = stage.num_slots;
  double force[3] = {0.0, 0.0, 0.0}, moment[3] = {0.0, 0.0, 0.0};
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    double shift[3] = {-x[0], -x[1], -x[2]};
    if (block.location >= 0) {
      double moved[3];
      Rotate(problem.rotation + 9 * block.location, point + problem.at.d + 3 * block.location,
             moved);
      for (int a = 0; a < 3; ++a) shift[a] += moved[a];
    }
    for (int j = block.first; j < block.first + block.count; ++j) {
      const double f[3] = {u[j], u[n + j], u[2 * n + j]};
      const double r[3] = {anchor[j] + shift[0], anchor[n + j] + shift[1],
                           anchor[2 * n + j] + shift[2]};
      double turn[3];
      Cross(r, f, turn);
      for (int a = 0; a < 3; ++a) {
        force[a] += f[a];
        moment[a] += turn[a];
      }
    }
  }
  const double* drift = problem.drift + 6 * k;
  const double* next = x + 9;
  for (int a = 0; a < 3; ++a) {
    gap[a] = x[a] + step_s * x[3 + a] - next[a];
    gap[3 + a] = x[3 + a] + step_s * (drift[a] + force[a]) - next[3 + a];
    gap[6 + a] = x[6 + a] + step_s * (drift[3 + a] + moment[a]) - next[6 + a];
  }
}

// A R^T u + s - b over a stage.
void Residual(const ProblemView& problem, const double* point, const Stage& stage,
              double* residual) {
  const int n = stage.num_slots;
  const double* u = point + problem.at.u + 3 * stage.first_slot;
  const double* s = point + problem.at.s + problem.num_faces * stage.first_slot;
  const double* face = problem.face + 3 * problem.num_faces * stage.first_slot;
  for (int r = 0; r < problem.num_faces; ++r) {
    const double* row = face + 3 * r * n;
    const double bound = problem.bound[r];
    for (int j = 0; j < n; ++j) {
      residual[r * n + j] = row[j] * u[j] + row[n + j] * u[n + j] + row[2 * n + j] * u[2 * n + j] +
                            s[r * n + j] - bound;
    }
  }
}

void AddNorms(const double* values, int count, Evaluation* out) {
  double sum = 0.0, largest = out->largest_residual;
  for (int i = 0; i < count; ++i) {
    const double size = Abs(values[i]);
    sum += size;
    largest = Max(largest, size);
  }
  out->infeasibility += sum;
  out->largest_residual = largest;
}

double BarrierSum(const ProblemView& problem, const double* point) {
  LogSum logs;
  const double* s = point + problem.at.s;
  for (int i = 0; i < problem.num_faces * problem.num_slots; ++i) logs.Add(s[i]);
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    if (problem.is_free[i] == 0.0) continue;
    logs.Add(point[problem.at.d + i] - problem.box_lower[i]);
    logs.Add(problem.box_upper[i] - point[problem.at.d + i]);
  }
  return logs.Value();
}

}  // namespace

void Evaluate(const ProblemView& problem, const double* point, Evaluation* out) {
  out->cost = StateCost(problem, point) + LocationCost(problem, point) + LegCost(problem, point) +
              LoadCost(problem, point);
  out->infeasibility = 0.0;
  out->largest_residual = 0.0;
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    Gap(problem, point, k, out->gap + 9 * k);
    Residual(problem, point, stage, out->residual + problem.num_faces * stage.first_slot);
    for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
      out->cost += BlockCost(problem, point, k, problem.blocks[b]);
    }
  }
  AddNorms(out->gap, 9 * problem.knots, out);
  AddNorms(out->residual, problem.num_faces * problem.num_slots, out);
  out->log_sum = BarrierSum(problem, point);
  out->slack_sum = 0.0;
  for (int i = problem.at.s; i < problem.at.z; ++i) out->slack_sum += point[i];
}

void RollOut(const ProblemView& problem, double push, double* point) {
  for (int k = 0; k < problem.knots; ++k) {
    double gap[9];
    Gap(problem, point, k, gap);
    for (int i = 0; i < 9; ++i) point[9 * (k + 1) + i] += gap[i];
    const Stage& stage = problem.stages[k];
    const int n = stage.num_slots;
    const double* u = point + problem.at.u + 3 * stage.first_slot;
    const double* face = problem.face + 3 * problem.num_faces * stage.first_slot;
    double* s = point + problem.at.s + problem.num_faces * stage.first_slot;
    for (int r = 0; r < problem.num_faces; ++r) {
      const double* row = face + 3 * r * n;
      for (int j = 0; j < n; ++j) {
        s[r * n + j] = Max(push, problem.bound[r] - row[j] * u[j] - row[n + j] * u[n + j] -
                                     row[2 * n + j] * u[2 * n + j]);
      }
    }
  }
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
