// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// model_instance: a MuJoCo model with one state of it, as a value.

#include <memory>
#include <utility>

#include "models/mjcf/mjcf.h"

namespace sidestep {

/// Copies share the model, which nobody changes any more, and have a state of their own each.
class ModelInstance {
 public:
  /// At the model's reference configuration. Throws ContractViolation without memory.
  explicit ModelInstance(MjModelPtr model)
      : model_(model.release(), MjModelDeleter{}), data_(MakeData(*model_)) {}

  /// Copies the whole mjData: the copy goes on bit for bit as the original does.
  ModelInstance(const ModelInstance& other) : model_(other.model_), data_(MakeData(*model_)) {
    mj_copyData(data_.get(), model_.get(), other.data_.get());
  }
  /// Copies first, then swaps: if memory runs out this one is left as it was.
  ModelInstance& operator=(const ModelInstance& other) {
    ModelInstance copy(other);
    std::swap(model_, copy.model_);
    std::swap(data_, copy.data_);
    return *this;
  }
  ModelInstance(ModelInstance&&) noexcept = default;
  ModelInstance& operator=(ModelInstance&&) noexcept = default;
  ~ModelInstance() = default;

  /// Shared with all copies: never to be written. Valid as long as one of them lives.
  const mjModel* model() const { return model_.get(); }

  /// Not const, though the instance may be: what is evaluated when first read is written here.
  mjData* data() const { return data_.get(); }

 private:
  std::shared_ptr<const mjModel> model_;  ///< Freed with the last copy.
  MjDataPtr data_;                        ///< This copy's alone.
};

}  // namespace sidestep
