// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// structured_memory: the arrays of a Workspace.

#include "controller/mpc/structured/arena.h"
#include "controller/mpc/structured/interior_point.h"

namespace sidestep::mpc::structured {

/// Owns a workspace's arrays; grows to the largest problem met.
class Memory {
 public:
  /// Points `workspace` at arrays of the sizes that `view` needs, values undefined.
  void Take(const ProblemView& view, Workspace* workspace);

 private:
  Arena arena_;
};

}  // namespace sidestep::mpc::structured
