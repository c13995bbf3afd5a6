// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mat_names: names as fields of a MATLAB struct.

#include <set>
#include <string>

namespace sidestep {

/// Gives the fields of one struct their names, each once.
class MatNames {
 public:
  /// `text` as MATLAB takes it (letters, digits, underscores, a letter first, at most 63), with a
  /// number behind it if that is taken already. `data` and `log` mean something to viewers where
  /// they stand, and get an underscore.
  std::string Take(const std::string& text);

 private:
  std::set<std::string> taken_;
};

}  // namespace sidestep
