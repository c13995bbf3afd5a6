// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// export_run: a run's trajectory.csv in, a file for other programs' viewers out.

#include <filesystem>
#include <string>

#include "sim/record/run_reader.h"

namespace sidestep {

/// The table with each column's name as its path (column_path.h), for PlotJuggler; time_s stays.
std::string GroupedCsv(const CsvTable& trajectory);

/// Writes what `run_dir`/trajectory.csv has, of whatever detail and ending, as `file`'s extension
/// asks: .csv as GroupedCsv, .mat as WriteMat (mat_file.h). An older file is replaced only by a
/// whole new one. One in the run's folder goes on its list of files.
/// @throws ConfigError for another extension, for a file that is the run's own, if the trajectory
///         or scenario.yaml can't be read, holds no row or has columns whose names are no plain
///         words or stand twice, and if the file can't be written.
void ExportRun(const std::filesystem::path& run_dir, const std::filesystem::path& file);

}  // namespace sidestep
