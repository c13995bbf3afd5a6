// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// barrier: slacks of the friction rows, distances to the boxes, and their multipliers.

#include "controller/mpc/structured/evaluate.h"
#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/problem_view.h"
#include "controller/mpc/structured/riccati.h"

namespace sidestep::mpc::structured {

/// How far a direction may be followed.
struct StepLimits {
  double primal{1.0};
  double dual{1.0};
};

namespace SIDESTEP_ISA {

/// Moves the point inside its bounds by at least `push` (less in thin boxes), pinned coordinates
/// to the middle of their box, and sets the multipliers to barrier / distance.
void StartInside(const ProblemView& problem, double push, double barrier, double* point);

/// What the products of slacks and multipliers aim at: the barrier, and for the friction rows
/// barrier (1 - damping slack), so that forces which nothing holds don't run away.
void SetTarget(const ProblemView& problem, const double* point, double barrier, double damping,
               double* target);

/// Fills curvature and slope of the barrier problem with these targets.
void BuildTerms(const ProblemView& problem, const double* point, const Evaluation& at,
                const Linearization& linear, const double* target, NewtonTerms* terms);

/// The slacks' and multipliers' part of the direction. `target`, in a point's order, is what their
/// products aim at; entries at the slacks are not read.
void CompleteDirection(const ProblemView& problem, const double* point, const Evaluation& at,
                       const double* target, double* direction);

/// Sets what the products of slacks and multipliers aim at, `barrier` minus `weight` times the
/// product of their affine steps, and by how much the slopes differ from those of a barrier of
/// zero.
void BuildCorrection(const ProblemView& problem, const double* point, const double* affine,
                     double barrier, double weight, double* target, double* change);

/// Average product of slack and multiplier after a step.
double AverageProduct(const ProblemView& problem, const double* point, const double* direction,
                      const StepLimits& step);

/// Longest steps that leave the share 1 - `fraction` of every distance and multiplier.
StepLimits LimitSteps(const ProblemView& problem, const double* point, const double* direction,
                      double fraction);

/// Slope of cost - barrier * (logs - damping * friction rows' slacks) along the direction.
double BarrierSlope(const ProblemView& problem, const double* point, const double* direction,
                    const double* gradient, double barrier, double damping);

/// trial = point + primal * direction in x, u, d, s and dual * direction in the multipliers.
void TakeStep(const ProblemView& problem, const double* point, const double* direction,
              const StepLimits& step, double* trial);

/// Keeps multipliers within 1e10 of barrier / distance.
void SafeguardMultipliers(const ProblemView& problem, double barrier, double* point);

}  // namespace SIDESTEP_ISA
}  // namespace sidestep::mpc::structured
