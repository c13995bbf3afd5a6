// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/limit_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sidestep {
namespace {

constexpr double kConfirmShares[] = {0.5, 0.75, 0.9};
constexpr int kMostHalvings = 60;  // beyond that two doubles have nothing between them

}  // namespace

Bracket BracketOf(const std::vector<TestedStrength>& tested) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bracket bracket{0.0, kInfinity, std::numeric_limits<double>::quiet_NaN()};
  double doubtful = kInfinity;  // the smallest that did not survive for sure
  int survived = 0, judged = 0;
  for (const TestedStrength& one : tested) {
    if (one.survival == Survival::kLost) bracket.lost = std::min(bracket.lost, one.strength);
    const bool is_survived = one.survival == Survival::kSurvived;
    if (!is_survived) doubtful = std::min(doubtful, one.strength);
    const bool counts =
        one.stage == SearchStage::kLadder && (is_survived || one.survival == Survival::kLost);
    judged += counts ? 1 : 0;
    survived += counts && is_survived ? 1 : 0;
  }
  for (const TestedStrength& one : tested) {
    if (one.strength < doubtful) bracket.survived = std::max(bracket.survived, one.strength);
  }
  if (judged > 0) bracket.ladder_share = static_cast<double>(survived) / judged;
  return bracket;
}

LimitResult SearchLimit(
    const LimitSpec& limit,
    const std::function<Survival(double strength, SearchStage stage)>& survives) {
  LimitResult result;
  // False: go no further.
  const auto test = [&](double strength, SearchStage stage) {
    const auto is_same = [&](const TestedStrength& one) { return one.strength == strength; };
    if (std::any_of(result.tested.begin(), result.tested.end(), is_same)) return true;
    const Survival survival = survives(strength, stage);
    if (survival == Survival::kUnknown) return false;
    result.tested.push_back({strength, stage, survival});
    return true;
  };
  for (const double strength : limit.ladder) {
    if (!test(strength, SearchStage::kLadder)) return result;
  }
  for (int i = 0; i < kMostHalvings; ++i) {
    const Bracket bracket = BracketOf(result.tested);
    const bool is_open =
        std::isfinite(bracket.lost) && bracket.lost - bracket.survived > limit.resolution;
    if (!is_open) break;
    const double middle = 0.5 * (bracket.survived + bracket.lost);
    const std::size_t before = result.tested.size();
    if (!test(middle, SearchStage::kBisect)) return result;
    const bool is_new = result.tested.size() > before;
    if (!is_new || result.tested.back().survival == Survival::kInvalid) break;
  }
  const double survived = BracketOf(result.tested).survived;
  for (const double share : kConfirmShares) {
    if (survived > 0.0 && !test(share * survived, SearchStage::kConfirm)) return result;
  }
  result.is_complete = true;
  return result;
}

}  // namespace sidestep
