// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/log_detail.h"

#include <string>

#include "models/support/config_error.h"
#include "sim/record/run_summary.h"

namespace sidestep {

bool RecordsNoTicks(const std::filesystem::path& run_dir) {
  try {
    return ReadSummary(run_dir).log == LogDetail::kNone;
  } catch (const ConfigError&) {  // whoever needs the summary tells what is wrong with it
    return false;
  }
}

void RequireTicksFile(const std::filesystem::path& run_dir, const char* name) {
  if (std::filesystem::exists(run_dir / name) || !RecordsNoTicks(run_dir)) return;
  throw ConfigError((run_dir / name).string() +
                    ": error: is not there: the run was recorded with --log none; run it again "
                    "with --log normal");
}

}  // namespace sidestep
