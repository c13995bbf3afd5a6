// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/minimize.h"

namespace sidestep::mpc::structured {

#ifdef SIDESTEP_HAS_AVX2_CORE
namespace avx2 {
Summary Minimize(const ProblemView& problem, const Settings& settings, Workspace* workspace);
}  // namespace avx2

bool HasFastInstructions() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

Summary Minimize(const ProblemView& problem, const Settings& settings, Workspace* workspace) {
  return HasFastInstructions() ? avx2::Minimize(problem, settings, workspace)
                               : baseline::Minimize(problem, settings, workspace);
}
#else
bool HasFastInstructions() { return false; }

Summary Minimize(const ProblemView& problem, const Settings& settings, Workspace* workspace) {
  return baseline::Minimize(problem, settings, workspace);
}
#endif

}  // namespace sidestep::mpc::structured
