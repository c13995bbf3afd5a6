// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/barrier.h"

#include "controller/mpc/structured/core_math.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

void StartBoxes(const ProblemView& problem, double push, double barrier, double* point) {
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    const double lower = problem.box_lower[i], upper = problem.box_upper[i];
    double& d = point[problem.at.d + i];
    if (problem.is_free[i] == 0.0) {
      d = 0.5 * (lower + upper);
      point[problem.at.lower + i] = point[problem.at.upper + i] = 0.0;
      continue;
    }
    const double margin = Min(push, 0.1 * (upper - lower));
    d = Min(Max(d, lower + margin), upper - margin);
    point[problem.at.lower + i] = barrier / (d - lower);
    point[problem.at.upper + i] = barrier / (upper - d);
  }
}

void BuildBoxTerms(const ProblemView& problem, const double* point, const double* gradient,
                   const double* target, NewtonTerms* terms) {
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    const int at = problem.at.d + i;
    if (problem.is_free[i] == 0.0) continue;
    const double below = point[at] - problem.box_lower[i];
    const double above = problem.box_upper[i] - point[at];
    terms->box_curvature[i] =
        point[problem.at.lower + i] / below + point[problem.at.upper + i] / above;
    terms->slope[at] =
        gradient[at] + target[problem.at.upper + i] / above - target[problem.at.lower + i] / below;
  }
}

double LargestRatio(const double* values, const double* steps, int count, double ratio) {
  // The largest of -step / value, whose inverse is the longest step.
  for (int i = 0; i < count; ++i) ratio = Max(ratio, -steps[i] / values[i]);
  return ratio;
}

}  // namespace

void StartInside(const ProblemView& problem, double push, double barrier, double* point) {
  StartBoxes(problem, push, barrier, point);
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    const int n = stage.num_slots;
    const double* u = point + problem.at.u + 3 * stage.first_slot;
    const double* face = problem.face + 3 * problem.num_faces * stage.first_slot;
    double* s = point + problem.at.s + problem.num_faces * stage.first_slot;
    double* z = point + problem.at.z + problem.num_faces * stage.first_slot;
    for (int r = 0; r < problem.num_faces; ++r) {
      const double* row = face + 3 * r * n;
      for (int j = 0; j < n; ++j) {
        const double left = problem.bound[r] - row[j] * u[j] - row[n + j] * u[n + j] -
                            row[2 * n + j] * u[2 * n + j];
        s[r * n + j] = Max(left, push);
        z[r * n + j] = barrier / s[r * n + j];
      }
    }
  }
}

void BuildTerms(const ProblemView& problem, const double* point, const Evaluation& at,
                const Linearization& linear, const double* target, NewtonTerms* terms) {
  for (int i = 0; i < 9 * (problem.knots + 1); ++i) terms->slope[i] = linear.gradient[i];
  BuildBoxTerms(problem, point, linear.gradient, target, terms);
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    const int n = stage.num_slots, base = problem.num_faces * stage.first_slot;
    double* H = terms->curvature + 6 * stage.first_slot;
    double* slope = terms->slope + problem.at.u + 3 * stage.first_slot;
    const double* gradient = linear.gradient + problem.at.u + 3 * stage.first_slot;
    Fill(H, 6 * n, 0.0);
    for (int i = 0; i < 3 * n; ++i) slope[i] = gradient[i];
    for (int r = 0; r < problem.num_faces; ++r) {
      const double* row = problem.face + 3 * (base + r * n);
      const double* s = point + problem.at.s + base + r * n;
      const double* z = point + problem.at.z + base + r * n;
      const double* residual = at.residual + base + r * n;
      const double* aim = target + problem.at.z + base + r * n;
      for (int j = 0; j < n; ++j) {
        const double inverse = 1.0 / s[j];
        const double weight = z[j] * inverse;
        const double pull = aim[j] * inverse + weight * residual[j];
        const double x = row[j], y = row[n + j], w = row[2 * n + j];
        H[j] += weight * x * x;
        H[n + j] += weight * y * y;
        H[2 * n + j] += weight * w * w;
        H[3 * n + j] += weight * x * y;
        H[4 * n + j] += weight * x * w;
        H[5 * n + j] += weight * y * w;
        slope[j] += pull * x;
        slope[n + j] += pull * y;
        slope[2 * n + j] += pull * w;
      }
    }
  }
}

void SetTarget(const ProblemView& problem, const double* point, double barrier, double damping,
               double* target) {
  Fill(target + problem.at.z, problem.at.size - problem.at.z, barrier);
  if (damping == 0.0) return;
  const int num_faces = problem.num_faces * problem.num_slots;
  for (int i = 0; i < num_faces; ++i) {
    target[problem.at.z + i] = barrier * (1.0 - damping * point[problem.at.s + i]);
  }
}

void BuildCorrection(const ProblemView& problem, const double* point, const double* affine,
                     double barrier, double weight, double* target, double* change) {
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    const int n = stage.num_slots, base = problem.num_faces * stage.first_slot;
    double* slope = change + problem.at.u + 3 * stage.first_slot;
    Fill(slope, 3 * n, 0.0);
    for (int r = 0; r < problem.num_faces; ++r) {
      const double* row = problem.face + 3 * (base + r * n);
      const int at_s = problem.at.s + base + r * n, at_z = problem.at.z + base + r * n;
      for (int j = 0; j < n; ++j) {
        const double aim = barrier - weight * affine[at_s + j] * affine[at_z + j];
        const double pull = aim / point[at_s + j];
        target[at_z + j] = aim;
        slope[j] += pull * row[j];
        slope[n + j] += pull * row[n + j];
        slope[2 * n + j] += pull * row[2 * n + j];
      }
    }
  }
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    const int d = problem.at.d + i, lower = problem.at.lower + i, upper = problem.at.upper + i;
    change[d] = 0.0;
    if (problem.is_free[i] == 0.0) continue;
    target[lower] = barrier - weight * affine[d] * affine[lower];
    target[upper] = barrier + weight * affine[d] * affine[upper];
    change[d] = target[upper] / (problem.box_upper[i] - point[d]) -
                target[lower] / (point[d] - problem.box_lower[i]);
  }
}

double AverageProduct(const ProblemView& problem, const double* point, const double* direction,
                      const StepLimits& step) {
  const int offset = problem.at.z - problem.at.s;
  double sum = 0.0;
  int count = offset;
  for (int i = problem.at.s; i < problem.at.z; ++i) {
    sum += (point[i] + step.primal * direction[i]) *
           (point[i + offset] + step.dual * direction[i + offset]);
  }
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    if (problem.is_free[i] == 0.0) continue;
    const int lower = problem.at.lower + i, upper = problem.at.upper + i;
    const double d = point[problem.at.d + i] + step.primal * direction[problem.at.d + i];
    sum += (d - problem.box_lower[i]) * (point[lower] + step.dual * direction[lower]);
    sum += (problem.box_upper[i] - d) * (point[upper] + step.dual * direction[upper]);
    count += 2;
  }
  return count == 0 ? 0.0 : sum / count;
}

void CompleteDirection(const ProblemView& problem, const double* point, const Evaluation& at,
                       const double* target, double* direction) {
  for (int k = 0; k < problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    const int n = stage.num_slots, base = problem.num_faces * stage.first_slot;
    const double* du = direction + problem.at.u + 3 * stage.first_slot;
    for (int r = 0; r < problem.num_faces; ++r) {
      const double* row = problem.face + 3 * (base + r * n);
      const double* s = point + problem.at.s + base + r * n;
      const double* z = point + problem.at.z + base + r * n;
      const double* residual = at.residual + base + r * n;
      const double* aim = target + problem.at.z + base + r * n;
      double* ds = direction + problem.at.s + base + r * n;
      double* dz = direction + problem.at.z + base + r * n;
      for (int j = 0; j < n; ++j) {
        ds[j] =
            -residual[j] - row[j] * du[j] - row[n + j] * du[n + j] - row[2 * n + j] * du[2 * n + j];
        dz[j] = (aim[j] - z[j] * ds[j]) / s[j] - z[j];
      }
    }
  }
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    const double d = point[problem.at.d + i], step = direction[problem.at.d + i];
    const int lower = problem.at.lower + i, upper = problem.at.upper + i;
    direction[lower] = direction[upper] = 0.0;
    if (problem.is_free[i] == 0.0) continue;
    direction[lower] =
        (target[lower] - point[lower] * step) / (d - problem.box_lower[i]) - point[lower];
    direction[upper] =
        (target[upper] + point[upper] * step) / (problem.box_upper[i] - d) - point[upper];
  }
}

StepLimits LimitSteps(const ProblemView& problem, const double* point, const double* direction,
                      double fraction) {
  const int count = problem.num_faces * problem.num_slots;
  double primal = LargestRatio(point + problem.at.s, direction + problem.at.s, count, 0.0);
  double dual = LargestRatio(point + problem.at.z, direction + problem.at.z, count, 0.0);
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    if (problem.is_free[i] == 0.0) continue;
    const double d = point[problem.at.d + i], step = direction[problem.at.d + i];
    primal =
        Max(primal, Max(-step / (d - problem.box_lower[i]), step / (problem.box_upper[i] - d)));
    const int lower = problem.at.lower + i, upper = problem.at.upper + i;
    dual = Max(dual, Max(-direction[lower] / point[lower], -direction[upper] / point[upper]));
  }
  StepLimits limits;
  if (primal > fraction) limits.primal = fraction / primal;
  if (dual > fraction) limits.dual = fraction / dual;
  return limits;
}

double BarrierSlope(const ProblemView& problem, const double* point, const double* direction,
                    const double* gradient, double barrier, double damping) {
  double slope = 0.0;
  for (int i = 9; i < problem.at.s; ++i) slope += gradient[i] * direction[i];
  double logs = 0.0;
  for (int i = problem.at.s; i < problem.at.z; ++i) {
    logs += direction[i] / point[i] - damping * direction[i];
  }
  for (int i = 0; i < 3 * problem.num_locations; ++i) {
    if (problem.is_free[i] == 0.0) continue;
    const double d = point[problem.at.d + i], step = direction[problem.at.d + i];
    logs += step / (d - problem.box_lower[i]) - step / (problem.box_upper[i] - d);
  }
  return slope - barrier * logs;
}

void TakeStep(const ProblemView& problem, const double* point, const double* direction,
              const StepLimits& step, double* trial) {
  for (int i = 0; i < problem.at.z; ++i) trial[i] = point[i] + step.primal * direction[i];
  for (int i = problem.at.z; i < problem.at.size; ++i) {
    trial[i] = point[i] + step.dual * direction[i];
  }
}

void SafeguardMultipliers(const ProblemView& problem, double barrier, double* point) {
  constexpr double kFactor = 1e10;
  const int count = problem.num_faces * problem.num_slots;
  for (int i = 0; i < count; ++i) {
    const double centre = barrier / point[problem.at.s + i];
    double& z = point[problem.at.z + i];
    z = Max(Min(z, kFactor * centre), centre / kFactor);
  }
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
