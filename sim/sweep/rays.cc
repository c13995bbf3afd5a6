// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/rays.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/support/config_node.h"

namespace sidestep {
namespace {

// Values of some axes at once: of one grid axis, or of all that are drawn together.
struct Choice {
  std::vector<std::size_t> axes;                  // their numbers
  std::vector<std::vector<std::string>> options;  // each one value an axis
};

Choice DrawnChoice(const SweepSpec& spec, AxisKind kind) {
  Choice choice;
  for (std::size_t i = 0; i < spec.axes.size(); ++i) {
    if (spec.axes[i].kind == kind) choice.axes.push_back(i);
  }
  for (const std::vector<double>& row : DrawAxes(spec.axes, kind, spec.sample_seed)) {
    std::vector<std::string>& option = choice.options.emplace_back();
    for (const double value : row) option.push_back(NumberText(value));
  }
  return choice;
}

std::vector<Choice> ChoicesOf(const SweepSpec& spec) {
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < spec.axes.size(); ++i) {
    const Axis& axis = spec.axes[i];
    if (axis.kind != AxisKind::kGrid) continue;
    Choice& choice = choices.emplace_back();
    choice.axes = {i};
    for (const std::string& value : axis.values) choice.options.push_back({value});
  }
  for (const AxisKind kind : {AxisKind::kRandom, AxisKind::kLatin}) {
    Choice choice = DrawnChoice(spec, kind);
    if (!choice.options.empty()) choices.push_back(std::move(choice));
  }
  return choices;
}

std::vector<std::string> SeedTexts(const SweepSpec& spec) {
  std::vector<std::string> seeds;
  for (const std::uint64_t seed : spec.seeds) seeds.push_back(std::to_string(seed));
  if (seeds.empty()) seeds.emplace_back();
  return seeds;
}

Survival SurvivalOf(const std::vector<CellOutcome>& outcomes) {
  const auto has = [&](CellOutcome outcome) {
    return std::find(outcomes.begin(), outcomes.end(), outcome) != outcomes.end();
  };
  if (has(CellOutcome::kLost)) return Survival::kLost;
  return has(CellOutcome::kInvalid) ? Survival::kInvalid : Survival::kSurvived;
}

}  // namespace

double NumRays(const SweepSpec& spec) {
  double rays = static_cast<double>(spec.controllers.size());
  bool has_drawn[2] = {false, false};
  for (const Axis& axis : spec.axes) {
    if (axis.kind != AxisKind::kGrid) {
      bool& is_counted = has_drawn[axis.kind == AxisKind::kLatin ? 1 : 0];
      if (std::exchange(is_counted, true)) continue;
    }
    rays *= static_cast<double>(axis.size());
  }
  return rays;
}

double NumCells(const SweepSpec& spec) {
  const double seeds = std::max(1.0, static_cast<double>(spec.seeds.size()));
  double strengths = 1.0;
  if (spec.limit) {
    constexpr double kConfirmations = 3.0;
    const double halvings =
        std::ceil(std::max(0.0, std::log2(spec.limit->ladder.back() / spec.limit->resolution)));
    strengths = static_cast<double>(spec.limit->ladder.size()) + halvings + kConfirmations;
  }
  return NumRays(spec) * seeds * strengths;
}

std::vector<Ray> RaysOf(const SweepSpec& spec) {
  const std::vector<Choice> choices = ChoicesOf(spec);
  std::vector<Ray> rays;
  for (std::size_t controller = 0; controller < spec.controllers.size(); ++controller) {
    std::vector<std::size_t> at(choices.size(), 0);
    for (bool is_done = false; !is_done;) {
      Ray ray{rays.size(), controller, std::vector<std::string>(spec.axes.size())};
      for (std::size_t i = 0; i < choices.size(); ++i) {
        for (std::size_t j = 0; j < choices[i].axes.size(); ++j) {
          ray.values[choices[i].axes[j]] = choices[i].options[at[i]][j];
        }
      }
      rays.push_back(std::move(ray));
      is_done = true;  // unless a digit counts on; the last one is the fastest
      for (std::size_t i = choices.size(); i-- > 0 && is_done;) {
        at[i] = (at[i] + 1) % choices[i].options.size();
        is_done = at[i] == 0;
      }
    }
  }
  return rays;
}

std::vector<std::string> OverridesOf(const SweepSpec& spec, const Ray& ray, const CellKey& cell) {
  std::vector<std::string> overrides = spec.set;
  const std::vector<std::string>& controller = spec.controllers[ray.controller].set;
  overrides.insert(overrides.end(), controller.begin(), controller.end());
  for (std::size_t i = 0; i < spec.axes.size(); ++i) {
    overrides.push_back(spec.axes[i].key + "=" + ray.values[i]);
  }
  if (spec.limit) overrides.push_back(spec.limit->key + "=" + cell.strength);
  if (!cell.seed.empty()) overrides.push_back("seed=" + cell.seed);
  return overrides;
}

CellKey FirstCell(const SweepSpec& spec, const Ray& ray) {
  CellKey first;
  WalkRay(spec, ray, [&](const CellKey& cell) {
    first = cell;
    return std::optional<CellOutcome>();
  });
  return first;
}

LimitResult WalkRay(const SweepSpec& spec, const Ray& ray,
                    const std::function<std::optional<CellOutcome>(const CellKey&)>& outcome_of) {
  const std::vector<std::string> seeds = SeedTexts(spec);
  const auto run_seeds = [&](const std::string& strength, SearchStage stage) {
    std::vector<CellOutcome> outcomes;
    for (const std::string& seed : seeds) {
      const std::optional<CellOutcome> outcome = outcome_of({ray.index, strength, seed, stage});
      if (!outcome) return Survival::kUnknown;
      outcomes.push_back(*outcome);
    }
    return SurvivalOf(outcomes);
  };
  if (spec.limit) {
    return SearchLimit(*spec.limit, [&](double strength, SearchStage stage) {
      return run_seeds(NumberText(strength), stage);
    });
  }
  const Survival survival = run_seeds("", SearchStage::kSingle);
  if (survival == Survival::kUnknown) return {};
  return {{{0.0, SearchStage::kSingle, survival}}, true};
}

}  // namespace sidestep
