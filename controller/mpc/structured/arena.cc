// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/arena.h"

#include <cstdint>

#include "models/support/require.h"

namespace sidestep::mpc::structured {
namespace {

constexpr std::size_t kLine = 8;  // Doubles in a cache line of 64 bytes.

std::size_t WholeLines(std::size_t count) { return (count + kLine - 1) / kLine * kLine; }

}  // namespace

void Arena::Reset(std::size_t count, std::size_t pieces) {
  room_ = count + pieces * kLine;
  if (storage_.size() < room_ + kLine) storage_.resize(room_ + kLine);
  const auto address = reinterpret_cast<std::uintptr_t>(storage_.data()) / sizeof(double);
  start_ = (kLine - address % kLine) % kLine;
  used_ = 0;
}

double* Arena::Take(std::size_t count) {
  double* piece = storage_.data() + start_ + used_;
  used_ += WholeLines(count);
  SIDESTEP_REQUIRE(used_ <= room_, used_);
  return piece;
}

}  // namespace sidestep::mpc::structured
