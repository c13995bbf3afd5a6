// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// problem_dump: the controller's optimisation problems of a run as JSON files that `sidestep
// solve`, a test or a benchmark can load. A problem that failed is always worth a file; the others
// on request. What is in a problem only the controller knows: it hands over text.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sidestep {

class ProblemDump {
 public:
  /// Gives the JSON text of a problem that is to be called `name` in it. Costs time and memory, so
  /// it is called only for a problem that gets a file.
  using ProblemText = std::function<std::string(const std::string& name)>;

  /// Files go to `run_dir`/problems/ as mpc_<milliseconds>.json. `every`: also solved problems.
  ProblemDump(const std::filesystem::path& run_dir, bool every);
  ProblemDump(ProblemDump&&) = default;
  ProblemDump& operator=(ProblemDump&&) = default;

  /// A second dump that stands where this one does: it counts the same failures, and the files
  /// written so far are copied to `run_dir`/problems/. Both go on, each for itself.
  /// @throws ConfigError if `run_dir` is this dump's own, or a file can't be copied.
  ProblemDump ForkTo(const std::filesystem::path& run_dir) const;

  /// Takes the problem that was solved at `time_s`. Of failed ones the first ten are kept: a run
  /// that lost its solver has more of the same. Throws ConfigError if a file can't be written.
  void Add(double time_s, bool failed, const ProblemText& problem_text);

 private:
  void MakeFolder() const;

  std::filesystem::path run_dir_;
  std::filesystem::path folder_;
  bool every_;
  int num_failed_{0};
  std::vector<std::string> written_;  ///< Names of the files in folder_.
};

}  // namespace sidestep
