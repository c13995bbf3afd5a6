// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// clock_stage_timer: the clocks behind the controller's stages. Its figures go to the log's columns
// of time and never back into the run.

#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>

#include "controller/types/stage_timer.h"
#include "sim/record/tick_times.h"

namespace sidestep {

/// An instant by the steady clock and by the processor time of the calling thread.
class ClockReading {
 public:
  static ClockReading Now() {
    ClockReading now;
    now.wall_ = std::chrono::steady_clock::now();
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now.cpu_);
    return now;
  }

  /// From `start` to here, on the same thread.
  StageTime Since(const ClockReading& start) const {
    using Milliseconds = std::chrono::duration<double, std::milli>;
    return {Milliseconds(wall_ - start.wall_).count(),
            1e3 * static_cast<double>(cpu_.tv_sec - start.cpu_.tv_sec) +
                1e-6 * static_cast<double>(cpu_.tv_nsec - start.cpu_.tv_nsec)};
  }

 private:
  std::chrono::steady_clock::time_point wall_{};
  timespec cpu_{};
};

/// A stage that runs more than once between two resets has the sum of its runs.
class ClockStageTimer final : public StageTimer {
 public:
  void Begin(Stage stage) override { start_[Index(stage)] = ClockReading::Now(); }
  void End(Stage stage) override {
    const StageTime run = ClockReading::Now().Since(start_[Index(stage)]);
    spent_[Index(stage)].wall_ms += run.wall_ms;
    spent_[Index(stage)].cpu_ms += run.cpu_ms;
  }

  /// Forgets what was measured; call before every control tick.
  void Reset() { spent_.fill({}); }

  /// Time spent in `stage` since Reset().
  const StageTime& Spent(Stage stage) const { return spent_[Index(stage)]; }

 private:
  static constexpr std::size_t kStages = static_cast<std::size_t>(Stage::kCount);
  static std::size_t Index(Stage stage) { return static_cast<std::size_t>(stage); }

  std::array<ClockReading, kStages> start_{};  ///< Of the last Begin().
  std::array<StageTime, kStages> spent_{};
};

}  // namespace sidestep
