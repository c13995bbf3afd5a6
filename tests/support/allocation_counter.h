// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// allocation_counter: how often the program took memory.
//
// Eigen and C libraries allocate by malloc, the standard library by operator new. A test that links
// sidestep_allocation_counter has both go through counters (the linker's --wrap), in the libraries
// that it links statically too. That also sees what EIGEN_RUNTIME_NO_MALLOC would, in Release as
// well; it does not see inside shared libraries.

#include <cstdint>

namespace sidestep {

/// Allocations since the program began.
std::int64_t CountAllocations();

}  // namespace sidestep
