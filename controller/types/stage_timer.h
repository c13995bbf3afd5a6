// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// stage_timer: how the controller tells when its stages begin and end without reading a clock.

namespace sidestep {

enum class Stage { kEstimator, kPlanner, kMpc, kSwing, kWholeBody, kCount };

/// Implemented by the simulation, which owns the clock. The default does nothing.
class StageTimer {
 public:
  virtual ~StageTimer() = default;
  virtual void Begin(Stage /*stage*/) {}
  virtual void End(Stage /*stage*/) {}
};

/// Times a scope.
class ScopedStage {
 public:
  ScopedStage(StageTimer* timer, Stage stage) : timer_(timer), stage_(stage) {
    timer_->Begin(stage_);
  }
  ~ScopedStage() { timer_->End(stage_); }
  ScopedStage(const ScopedStage&) = delete;
  ScopedStage& operator=(const ScopedStage&) = delete;

 private:
  StageTimer* timer_;
  Stage stage_;
};

}  // namespace sidestep
