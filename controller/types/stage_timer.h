// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// stage_timer: how the controller tells when its stages begin and end without reading a clock.

namespace sidestep {

/// The links of the control chain, in the order in which they run within a tick. kCount is no
/// stage.
enum class Stage { kEstimator, kPlanner, kMpc, kSwing, kWholeBody, kCount };

/// Implemented by the simulation, which owns the clock. The default does nothing.
class StageTimer {
 public:
  virtual ~StageTimer() = default;
  /// Begin and End of one stage come in pairs and never overlap with the same stage; an End without
  /// Begin is a bug of the caller. Both must return soon and may not throw: End is called from a
  /// destructor.
  virtual void Begin(Stage /*stage*/) {}
  virtual void End(Stage /*stage*/) {}
};

/// Times a scope.
class ScopedStage {
 public:
  /// `timer` is not null and outlives the scope.
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
