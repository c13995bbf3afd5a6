// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/cell_runner.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "sim/episode/run_episode.h"
#include "sim/process/interrupt.h"
#include "sim/sweep/shared_prefix.h"

namespace sidestep {
namespace {

constexpr std::size_t kMostPrefixes = 16;  // kept at once; an iCub's episode is a few MB
constexpr char kUnsettled[] = "UNSETTLED";
constexpr char kNotRecovered[] = "NOT_RECOVERED";

double ProcessCpu_s() {
  constexpr double kSecondsPerNanosecond = 1e-9;
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + kSecondsPerNanosecond * static_cast<double>(now.tv_nsec);
}

double ImpulsePerMass_Nspkg(const Scenario& scenario, double mass_kg) {
  double impulse_Ns = 0.0;
  for (const Push& push : scenario.pushes) {
    impulse_Ns += MeanShare(push.profile) * push.duration_s * push.force_N.norm();
  }
  return impulse_Ns / mass_kg;
}

void AddReason(const std::string& kind, const std::string& text, std::optional<double> time_s,
               std::string* reasons) {
  char time[32] = "";
  if (time_s) std::snprintf(time, sizeof time, " at %.3f s", *time_s);
  *reasons += (reasons->empty() ? "" : "; ") + kind + time + (text.empty() ? "" : ": " + text);
}

// Judges a run that is over.
void Conclude(const Episode& episode, CellResult* result) {
  const RunOutcome outcome = episode.judge.Conclude();
  for (const Reason& reason : outcome.verdict.reasons) {
    AddReason(reason.kind, reason.text, reason.time_s, &result->reasons);
  }
  result->simulated_s = episode.time_s();
  if (outcome.verdict.verdict_class == VerdictClass::kInvalid) return;
  result->metrics = outcome.metrics;
  const bool has_recovered = std::get<bool>(outcome.metrics.at("recovered"));
  const bool has_fallen = std::get<bool>(outcome.metrics.at("fall"));
  result->outcome = has_recovered ? CellOutcome::kRecovered : CellOutcome::kLost;
  if (!has_recovered && !has_fallen) AddReason(kNotRecovered, "", {}, &result->reasons);
}

void RunFrom(Episode episode, CellResult* result) {
  RunEpisode(&episode, {});
  result->was_interrupted = InterruptRequested();
  Conclude(episode, result);
}

}  // namespace

const Episode* CellRunner::Before(const Scenario& scenario, Tick tick) {
  const std::string text = PrefixText(scenario);
  const auto found = std::find_if(prefixes_.begin(), prefixes_.end(), [&](const Prefix& prefix) {
    return prefix.text == text && prefix.episode.tick <= tick;
  });
  if (found != prefixes_.end()) {
    prefixes_.splice(prefixes_.begin(), prefixes_, found);
  } else {
    prefixes_.remove_if([&](const Prefix& prefix) { return prefix.text == text; });
    if (prefixes_.size() >= kMostPrefixes) prefixes_.pop_back();
    prefixes_.push_front({text, StartEpisode(WithoutWords(scenario), make_controller_)});
  }
  Episode& episode = prefixes_.front().episode;
  if (episode.tick < tick && !episode.is_over) {
    if (episode.tick > 0) episode = ForkWithPushes(episode, scenario.pushes);
    RunEpisode(&episode, {}, tick);
  }
  if (!InterruptRequested()) return &episode;
  prefixes_.pop_front();  // it may have ended in its middle
  return nullptr;
}

CellResult CellRunner::Run(const Scenario& scenario) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu_start_s = ProcessCpu_s();
  CellResult result;
  const Tick first = FirstPushTick(scenario);
  if (first <= 1) {  // nothing to share, or to be settled in
    Episode episode = StartEpisode(WithoutWords(scenario), make_controller_);
    result.impulse_Nspkg = ImpulsePerMass_Nspkg(scenario, episode.world->mass_kg());
    RunFrom(std::move(episode), &result);
  } else if (const Episode* before = Before(scenario, first - 1)) {
    result.impulse_Nspkg = ImpulsePerMass_Nspkg(scenario, before->world->mass_kg());
    if (before->judge.is_settled() && !before->is_over) {
      RunFrom(ForkWithPushes(*before, scenario.pushes), &result);
    } else {
      result.simulated_s = before->time_s();
      AddReason(kUnsettled, "it did not go as its gait asks before the push", {}, &result.reasons);
    }
  } else {
    result.was_interrupted = true;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  result.wall_s = wall.count();
  result.cpu_s = ProcessCpu_s() - cpu_start_s;
  return result;
}

}  // namespace sidestep
