// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// filter: which pairs of infeasibility and barrier function a line search may still accept.
//
// Source: Waechter & Biegler, "On the implementation of an interior-point filter line-search
// algorithm for large-scale nonlinear programming", Math. Program. 106 (2006), section 2.3.

#include "controller/mpc/structured/isa.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {

/// A filter of bounded size: when it is full, the oldest entry goes.
class Filter {
 public:
  void Reset(double largest_infeasibility) {
    count_ = 0;
    largest_ = largest_infeasibility;
  }

  bool Accepts(double infeasibility, double value) const {
    if (!(infeasibility <= largest_)) return false;
    for (int i = 0; i < count_; ++i) {
      if (infeasibility >= infeasibility_[i] && value >= value_[i]) return false;
    }
    return true;
  }

  void Add(double infeasibility, double value) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {  // What the new entry dominates says nothing any more.
      if (infeasibility_[i] >= infeasibility && value_[i] >= value) continue;
      infeasibility_[kept] = infeasibility_[i];
      value_[kept++] = value_[i];
    }
    if (kept == kCapacity) {
      for (int i = 1; i < kCapacity; ++i) {
        infeasibility_[i - 1] = infeasibility_[i];
        value_[i - 1] = value_[i];
      }
      --kept;
    }
    infeasibility_[kept] = infeasibility;
    value_[kept] = value;
    count_ = kept + 1;
  }

 private:
  static constexpr int kCapacity = 64;
  double infeasibility_[kCapacity]{};
  double value_[kCapacity]{};
  double largest_{0.0};
  int count_{0};
};

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
