// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// hdf5_failures: what goes wrong in HDF5, below a library that does not tell all of it.
//
// HDF5 keeps data back and writes it when it likes: matio never sees that this failed, and HDF5
// itself prints pages of it to stderr.

#include <optional>

namespace sidestep {

/// While one is there, HDF5 prints nothing in this thread, and its failures are kept. At most one
/// at a time. Make it before HDF5 is first used: a file that could not be written to its end makes
/// HDF5 crash when the program exits and it tidies up, which it then leaves undone.
class Hdf5Failures {
 public:
  Hdf5Failures();
  ~Hdf5Failures();
  Hdf5Failures(const Hdf5Failures&) = delete;
  Hdf5Failures& operator=(const Hdf5Failures&) = delete;

  /// The errno of the first call that failed, 0 if it had none; empty if all went well.
  const std::optional<int>& first() const { return first_; }

 private:
  std::optional<int> first_;
};

}  // namespace sidestep
