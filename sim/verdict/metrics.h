// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// metrics: every figure of merit that summary.json tells and a scenario's `expect` may bound.

#include <span>
#include <string_view>

namespace sidestep {

struct MetricInfo {
  std::string_view name;     ///< Key in summary.json and under `expect`; ends in its unit.
  std::string_view unit;     ///< SI; empty for a count or a truth value.
  std::string_view meaning;  ///< One line; measured on the truth unless it says otherwise.
  bool is_bool;
};

/// All metrics, in the order in which they are shown.
std::span<const MetricInfo> KnownMetrics();

/// The metric called `name`, or null.
const MetricInfo* FindMetric(std::string_view name);

}  // namespace sidestep
