// SPDX-License-Identifier: BSD-3-Clause
#include "sim/export/hdf5_failures.h"

#include <hdf5.h>

#include <cerrno>

namespace sidestep {
namespace {

// HDF5 calls this once for each of its functions that fails, before that returns.
herr_t KeepFirst(hid_t /*stack*/, void* first) {
  auto& kept = *static_cast<std::optional<int>*>(first);
  if (!kept) kept = errno;
  return 0;
}

}  // namespace

Hdf5Failures::Hdf5Failures() {
  H5dont_atexit();
  errno = 0;  // HDF5 sets it only where the system does
  H5Eset_auto2(H5E_DEFAULT, KeepFirst, &first_);
}

Hdf5Failures::~Hdf5Failures() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

}  // namespace sidestep
