// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fail_on: what of a comparison is to fail, as a command line spells it.
//
//   drift_m>0.2                   B's value itself
//   max_step_adjustment_m>+0.05   the change from A to B
//   max_step_adjustment_m>+10%    the same, of A's size
//   recovered<1                   true counts as 1

#include <string>

namespace sidestep {

struct FailOn {
  enum class Of { kValue, kChange, kPercent };
  std::string text;  ///< As it was spelled.
  std::string name;
  bool is_above{true};  ///< `>`; else `<`.
  double bound{0.0};
  Of of{Of::kValue};
};

/// @throws ConfigError of one line if it is none.
FailOn ParseFailOn(const std::string& text);

/// Whether it fails. What is NaN now and was not before fails; what was NaN and is NaN does not.
bool Fails(const FailOn& condition, double first, double second);

}  // namespace sidestep
