// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mj_state.h"

#include <utility>

#include "models/support/require.h"

namespace sidestep {

MjState::MjState(std::shared_ptr<const mjModel> model)
    : model_(std::move(model)), data_(MakeData(*model_)) {}

MjState::MjState(const MjState& other)
    : model_(other.model_), data_(mj_copyData(nullptr, model_.get(), other.data_.get())) {
  SIDESTEP_REQUIRE(data_ != nullptr, "no memory for mjData");
}

MjState& MjState::operator=(MjState other) noexcept {
  model_.swap(other.model_);
  data_.swap(other.data_);
  return *this;
}

}  // namespace sidestep
