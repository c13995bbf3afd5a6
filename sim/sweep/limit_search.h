// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// limit_search: how hard a push may be, for a robot whose survival need not fall with strength.
//
//   1. the whole ladder, upwards, whatever comes of it
//   2. bisection between the largest strength up to which everything tried survived and the
//      smallest that was lost, until they are no farther apart than the resolution
//   3. confirmation at 0.5, 0.75 and 0.9 of that limit
// What is told in the end goes by all of it: if a confirmation is lost, the limit is below it. A
// strength in between that nobody tried is not said to survive.

#include <functional>
#include <string_view>
#include <vector>

#include "controller/types/field.h"
#include "sim/sweep/sweep_spec.h"

namespace sidestep {

/// Why a strength was tried. kSingle: there is no limit to look for.
enum class SearchStage { kSingle, kLadder, kBisect, kConfirm };

template <>
struct EnumNames<SearchStage> {
  static constexpr std::array<std::pair<SearchStage, std::string_view>, 4> kNames{
      {{SearchStage::kSingle, "single"},
       {SearchStage::kLadder, "ladder"},
       {SearchStage::kBisect, "bisect"},
       {SearchStage::kConfirm, "confirm"}}};
};

/// What came of a strength, over all seeds.
enum class Survival {
  kSurvived,  ///< Every seed recovered.
  kLost,      ///< At least one did not.
  kInvalid,   ///< None did not, but some run says nothing.
  kUnknown    ///< It was not run to the end: the search stops here.
};

struct TestedStrength {
  double strength{0.0};
  SearchStage stage{SearchStage::kLadder};
  Survival survival{Survival::kUnknown};
};

/// What is known of a ray's limit.
struct Bracket {
  double survived{0.0};      ///< Largest strength with all tried up to it survived; 0: none.
  double lost;               ///< Smallest that was lost; infinite: none.
  double ladder_share{0.0};  ///< Of the ladder, what survived; INVALID ones count in neither part.
};

struct LimitResult {
  std::vector<TestedStrength> tested;  ///< In the order of the search.
  bool is_complete{false};             ///< No strength was unknown.
};

/// Searches; `survives` is asked for one strength after the other, never twice for the same.
LimitResult SearchLimit(
    const LimitSpec& limit,
    const std::function<Survival(double strength, SearchStage stage)>& survives);

/// The bracket that the tested strengths leave, in whatever order they are.
Bracket BracketOf(const std::vector<TestedStrength>& tested);

}  // namespace sidestep
