// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// metrics: every figure of merit that summary.json tells and a scenario's `expect` may bound.

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "controller/types/field.h"

namespace sidestep {

/// Whom a metric asks.
enum class MetricGroup {
  kTruth,      ///< The world alone, beside the scenario: the same for every controller.
  kController  ///< The controller: what it said it believed, planned and solved.
};

template <>
struct EnumNames<MetricGroup> {
  static constexpr std::array<std::pair<MetricGroup, std::string_view>, 2> kNames{
      {{MetricGroup::kTruth, "truth"}, {MetricGroup::kController, "controller"}}};
};

/// One line of the table that summary.json, `expect` and `sidestep metrics` share.
struct MetricInfo {
  std::string_view name;     ///< Key in summary.json and under `expect`; ends in its unit.
  std::string_view unit;     ///< SI; empty for a count or a truth value.
  std::string_view meaning;  ///< One line.
  bool is_bool;
  MetricGroup group;
};

/// All metrics, in the order in which they are shown.
std::span<const MetricInfo> KnownMetrics();

/// The metric called `name`, or null.
const MetricInfo* FindMetric(std::string_view name);

}  // namespace sidestep
