// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// log_detail: how much of a run's ticks its folder keeps. It never changes the run, its metrics or
// its verdict.

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "controller/types/field.h"

namespace sidestep {

enum class LogDetail {
  kFull,    ///< trajectory.csv has every control tick, to the last digit.
  kNormal,  ///< Every second one and the last, to the resolution of each column (column_digits.h).
  kNone     ///< Neither trajectory.csv nor states.bin.
};

template <>
struct EnumNames<LogDetail> {
  static constexpr std::array<std::pair<LogDetail, std::string_view>, 3> kNames{
      {{LogDetail::kFull, "full"}, {LogDetail::kNormal, "normal"}, {LogDetail::kNone, "none"}}};
};

/// Whether the run in that folder says that it recorded no ticks; false if it has no summary that
/// can be read.
bool RecordsNoTicks(const std::filesystem::path& run_dir);

/// Throws ConfigError if `run_dir`/`name`, a file with a row a tick, is not there because the run
/// was told to record none; says how to get it.
void RequireTicksFile(const std::filesystem::path& run_dir, const char* name);

}  // namespace sidestep
