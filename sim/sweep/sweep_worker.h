// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sweep_worker: the process that runs rays, one after the other, and the one that hands them out.
//
// By process, because the reference solver is not thread-safe and a run that crashes must not take
// its neighbours along; forked rather than started, so that both know the plan. They talk by lines:
//   to it      the number of a ray in the plan
//   from it    b<row>  a cell begins; should this be the last word, the row tells of the crash
//              r<row>  it is done          d  the ray is done
//              s  the user interrupted     e<text>  a mistake of the user's: nothing goes on
//              x<text>  a bug of ours

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/sweep/cell_row.h"
#include "sim/sweep/keep_run.h"
#include "sim/sweep/row_file.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep {

/// What every worker of a shard knows.
struct WorkerSetup {
  const SweepPlan* plan;
  const CellRows* rows;  ///< Those that need not be run again.
  std::filesystem::path folder;
  KeepOptions keep;
};

/// A worker as its parent has it.
class SweepWorker {
 public:
  /// Forks it off. In the child `file` is given up, and so are the other workers' sockets.
  SweepWorker(const WorkerSetup& setup, RowFile* file, const std::vector<SweepWorker*>& others);
  ~SweepWorker();
  SweepWorker(const SweepWorker&) = delete;
  SweepWorker& operator=(const SweepWorker&) = delete;

  int socket() const { return socket_; }
  pid_t pid() const { return pid_; }

  /// The place in the plan of the ray that it runs, if any.
  std::optional<std::size_t> ray;
  /// The row that tells of a crash now; empty between cells.
  std::string crash_row;

  void Assign(std::size_t place);

  /// Lines that have arrived, without their ends; nothing once the worker is gone.
  std::optional<std::vector<std::string>> Read();

  /// Lets it end and waits for it. Gives its exit code, or 128 and the signal's number.
  int Finish();

 private:
  int socket_{-1};
  pid_t pid_{-1};
  std::string unread_;
};

}  // namespace sidestep
