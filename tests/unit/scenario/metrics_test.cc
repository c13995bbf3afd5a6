// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace sidestep::metrics_test {
namespace {

TEST(MetricsTest, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const MetricInfo& metric : KnownMetrics()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_EQ(FindMetric(metric.name), &metric);
    EXPECT_FALSE(metric.meaning.empty()) << metric.name;
  }
  EXPECT_EQ(FindMetric("fal"), nullptr);
}

TEST(MetricsTest, NamesEndInTheirUnit) {
  for (const MetricInfo& metric : KnownMetrics()) {
    EXPECT_EQ(UnitOf(metric.name), metric.unit) << metric.name;
    EXPECT_TRUE(metric.unit.empty() || !metric.is_bool) << metric.name;
  }
}

TEST(MetricsTest, FallSlipAndRecoveredAreTrueOrFalse) {
  for (const char* name : {"fall", "slip", "recovered"}) {
    ASSERT_NE(FindMetric(name), nullptr) << name;
    EXPECT_TRUE(FindMetric(name)->is_bool) << name;
  }
  EXPECT_EQ(std::count_if(KnownMetrics().begin(), KnownMetrics().end(),
                          [](const MetricInfo& metric) { return metric.is_bool; }),
            3);
}

TEST(MetricsTest, WhatTheControllerBelievedPlannedAndSolvedIsAGroupOfItsOwn) {
  std::set<std::string_view> asked;
  for (const MetricInfo& metric : KnownMetrics()) {
    if (metric.group == MetricGroup::kController) asked.insert(metric.name);
  }
  EXPECT_EQ(asked, (std::set<std::string_view>{
                       "planned_mean_step_adjustment_m", "planned_max_step_adjustment_m",
                       "mpc_failures", "wbc_failures", "step_failures", "max_solver_failure_ratio",
                       "solver_fallbacks", "max_cone_violation_N", "max_box_violation_m",
                       "rms_com_velocity_error_mps", "max_com_velocity_error_mps",
                       "rms_pushed_com_velocity_error_mps", "max_pushed_com_velocity_error_mps",
                       "rms_push_estimate_error_N", "max_push_estimate_error_N"}));
}

}  // namespace
}  // namespace sidestep::metrics_test
