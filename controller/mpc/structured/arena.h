// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// arena: one block of doubles, handed out piece by piece.

#include <cstddef>
#include <vector>

namespace sidestep::mpc::structured {

/// A count that is never negative, as the standard library's sizes.
inline std::size_t Size(int count) { return static_cast<std::size_t>(count); }

/// A stock of doubles handed out from the front in whole cache lines. Grows, never shrinks.
class Arena {
 public:
  /// Makes room for `count` doubles in `pieces` pieces and takes everything back.
  void Reset(std::size_t count, std::size_t pieces);

  /// The next `count` doubles, values undefined. Throws ContractViolation beyond Reset()'s room.
  double* Take(std::size_t count);

 private:
  std::vector<double> storage_;
  std::size_t start_{0};
  std::size_t used_{0};
  std::size_t room_{0};
};

}  // namespace sidestep::mpc::structured
