// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mj_state: MuJoCo's state as a value, so that whoever holds one can be copied.

#include <mujoco/mujoco.h>

#include <memory>

#include "models/mjcf/mjcf.h"

namespace sidestep {

/// A state of a model. Copies share the model, which nobody changes, and have all else to
/// themselves: between mj_step1() and mj_step2() a copy goes on as its original would, bit for bit,
/// because mj_copyData takes contacts, constraints and the solver's warm start along.
class MjState {
 public:
  /// At the model's reference configuration. Throws ContractViolation without memory.
  explicit MjState(std::shared_ptr<const mjModel> model);

  MjState(const MjState& other);
  MjState(MjState&& other) noexcept = default;
  MjState& operator=(MjState other) noexcept;
  ~MjState() = default;

  /// Never to be written: copies share it.
  const mjModel& model() const { return *model_; }
  /// The state, to be read and moved on; owned by this object.
  mjData* get() const { return data_.get(); }
  mjData* operator->() const { return data_.get(); }

 private:
  std::shared_ptr<const mjModel> model_;
  MjDataPtr data_;
};

}  // namespace sidestep
