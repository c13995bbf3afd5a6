// SPDX-License-Identifier: BSD-3-Clause
#include <IpoptConfig.h>

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "models/mjcf/mjcf.h"
#include "sim/record/git_commit.h"
#include "sim/record/make_summary.h"

namespace sidestep {
namespace {

#if defined(__clang__)
constexpr char kCompiler[] = __VERSION__;  // names itself
#else
constexpr char kCompiler[] = "GCC " __VERSION__;
#endif

}  // namespace

std::vector<std::pair<std::string, std::string>> Versions() {
  return {
      {"sidestep", SIDESTEP_VERSION},
      {"git_commit", GitCommit()},
      {"mujoco", mj_versionString()},
      {"ipopt", IPOPT_VERSION},
      {"eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) +
                    "." + std::to_string(EIGEN_MINOR_VERSION)},
      {"compiler", kCompiler}};
}

}  // namespace sidestep
