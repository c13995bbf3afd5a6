// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// clone_ptr: an owner of a polymorphic part that is copied with what owns it.
//
// A run can be forked in its middle: its controller and world are copied with all their parts.
// Parts behind an interface offer Clone(); holding them by ClonePtr makes their owner copyable as
// it is.

#include <memory>
#include <utility>

namespace sidestep {

/// Owns a T, or nothing after a move. A copy owns a Clone() of it.
/// T needs `std::unique_ptr<T> Clone() const`.
template <typename T>
class ClonePtr {
 public:
  /// Implicit on purpose: factories return unique_ptr.
  // NOLINTNEXTLINE(google-explicit-constructor)
  ClonePtr(std::unique_ptr<T> part) : part_(std::move(part)) {}
  ClonePtr(const ClonePtr& other) : part_(other.part_ ? other.part_->Clone() : nullptr) {}
  ClonePtr(ClonePtr&&) noexcept = default;
  /// Drops what it owned; holds a clone of its own afterwards.
  ClonePtr& operator=(const ClonePtr& other) {
    if (this != &other) part_ = other.part_ ? other.part_->Clone() : nullptr;
    return *this;
  }
  ClonePtr& operator=(ClonePtr&&) noexcept = default;
  ~ClonePtr() = default;

  /// Null after a move only. Constness is not passed on, as with unique_ptr.
  T* get() const { return part_.get(); }
  T* operator->() const { return part_.get(); }
  T& operator*() const { return *part_; }

 private:
  std::unique_ptr<T> part_;
};

}  // namespace sidestep
