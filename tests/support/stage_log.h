// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// stage_log: a stage timer that writes down what it is told.

#include <utility>
#include <vector>

#include "controller/types/stage_timer.h"

namespace sidestep {

/// Every begin (true) and end (false) of a stage, in the order told.
class StageLog final : public StageTimer {
 public:
  using Event = std::pair<Stage, bool>;

  void Begin(Stage stage) override { events_.emplace_back(stage, true); }
  void End(Stage stage) override { events_.emplace_back(stage, false); }

  const std::vector<Event>& events() const { return events_; }
  void Clear() { events_.clear(); }

  /// What stages that follow one another leave: each ends before the next begins.
  static std::vector<Event> OneAfterAnother(const std::vector<Stage>& stages) {
    std::vector<Event> events;
    for (const Stage stage : stages) {
      events.emplace_back(stage, true);
      events.emplace_back(stage, false);
    }
    return events;
  }

 private:
  std::vector<Event> events_;
};

}  // namespace sidestep
