// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/leg_root.h"

namespace sidestep {

bool IsAtOrBelow(const mjModel& model, int body, int ancestor) {
  while (body != ancestor && body != 0) body = model.body_parentid[body];
  return body == ancestor;
}

int RootOfLegs(const mjModel& model, std::span<const int> foot_sites, int base) {
  if (foot_sites.size() < 2) return base;
  int root = model.site_bodyid[foot_sites.front()];
  for (const int site : foot_sites) {
    while (root != base && root != 0 && !IsAtOrBelow(model, model.site_bodyid[site], root)) {
      root = model.body_parentid[root];
    }
  }
  return root;
}

}  // namespace sidestep
