// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/structured_memory.h"

#include <algorithm>

namespace sidestep::mpc::structured {

void Memory::Take(const ProblemView& view, Workspace* workspace) {
  const std::size_t point = Size(view.at.size);
  const std::size_t slots = Size(view.num_slots);
  const std::size_t residuals = Size(view.num_faces) * slots;
  const std::size_t stages = Size(view.knots + 1);
  std::size_t tail = 0, active = 0, rows = 0, blocks = 0;
  for (std::size_t k = 0; k < stages; ++k) {
    const Stage& stage = view.stages[k];
    const std::size_t kept = Size(stage.num_rows - stage.num_pivots);
    tail = std::max(tail, kept * kept);
    active = std::max(active, Size(stage.num_active));
    rows = std::max(rows, Size(stage.num_rows));
    blocks += Size(stage.num_blocks);
  }
  arena_.Reset(7 * point + 2 * residuals + 33 * stages + 9 * slots + 7 * blocks +
                   3 * Size(view.num_locations) + 2 * tail + 24 * active + 2 * rows +
                   Size(view.num_pivots),
               32);
  for (double** array :
       {&workspace->point, &workspace->trial, &workspace->direction, &workspace->target,
        &workspace->change, &workspace->linear.gradient, &workspace->newton.slope}) {
    *array = arena_.Take(point);
  }
  for (Evaluation* evaluation : {&workspace->now, &workspace->next}) {
    evaluation->gap = arena_.Take(9 * stages);
    evaluation->residual = arena_.Take(residuals);
  }
  workspace->linear.arm = arena_.Take(3 * slots);
  workspace->linear.force = arena_.Take(3 * stages);
  workspace->linear.block_force = arena_.Take(3 * blocks);
  workspace->linear.leg = arena_.Take(4 * blocks);
  workspace->linear.costate = arena_.Take(9 * stages);
  workspace->newton.curvature = arena_.Take(6 * slots);
  workspace->newton.box_curvature = arena_.Take(3 * Size(view.num_locations));
  workspace->newton.tail[0] = arena_.Take(tail);
  workspace->newton.tail[1] = arena_.Take(tail);
  workspace->newton.value = arena_.Take(12 * active);
  workspace->newton.product = arena_.Take(12 * active);
  workspace->newton.vector = arena_.Take(rows);
  workspace->newton.kept = arena_.Take(rows);
  workspace->newton.change = arena_.Take(Size(view.num_pivots));
}

}  // namespace sidestep::mpc::structured
