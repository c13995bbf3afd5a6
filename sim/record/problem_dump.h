// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// problem_dump: MPC problems of a run as JSON files that `sidestep solve`, a test or a benchmark
// can load. A problem that failed is always worth a file; the others on request.

#include <filesystem>

#include "controller/mpc/problem/centroidal_ocp.h"

namespace sidestep {

class ProblemDump {
 public:
  /// Files go to `run_dir`/problems/ as mpc_<milliseconds>.json. `every`: also solved problems.
  ProblemDump(const std::filesystem::path& run_dir, bool every);

  /// Takes the problem that was solved at `time_s`. Of failed ones the first ten are kept: a run
  /// that lost its solver has more of the same. Throws ConfigError if a file can't be written.
  void Add(double time_s, const mpc::CentroidalOcp& ocp, bool failed);

 private:
  std::filesystem::path folder_;
  bool every_;
  int num_failed_{0};
};

}  // namespace sidestep
