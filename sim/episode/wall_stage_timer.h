// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// wall_stage_timer: the clock behind the controller's stages. Its figures go to the log's wall
// columns and never back into the run.

#include <array>
#include <chrono>
#include <cstddef>

#include "controller/types/stage_timer.h"

namespace sidestep {

/// By the steady clock. A stage that runs more than once between two resets has the sum of its
/// runs.
class WallStageTimer final : public StageTimer {
 public:
  void Begin(Stage stage) override { start_[Index(stage)] = Clock::now(); }
  void End(Stage stage) override {
    using Milliseconds = std::chrono::duration<double, std::milli>;
    spent_ms_[Index(stage)] += Milliseconds(Clock::now() - start_[Index(stage)]).count();
  }

  /// Forgets what was measured; call before every control tick.
  void Reset() { spent_ms_.fill(0.0); }

  /// Time spent in `stage` since Reset().
  double Spent_ms(Stage stage) const { return spent_ms_[Index(stage)]; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kStages = static_cast<std::size_t>(Stage::kCount);
  static std::size_t Index(Stage stage) { return static_cast<std::size_t>(stage); }

  std::array<Clock::time_point, kStages> start_{};  ///< Of the last Begin().
  std::array<double, kStages> spent_ms_{};
};

}  // namespace sidestep
