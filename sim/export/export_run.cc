// SPDX-License-Identifier: BSD-3-Clause
#include "sim/export/export_run.h"

#include <cstddef>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include "models/support/config_error.h"
#include "models/support/config_tree.h"
#include "models/support/plain_word.h"
#include "sim/export/column_path.h"
#include "sim/export/mat_file.h"
#include "sim/record/output_file.h"
#include "sim/record/run_files.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

void RequireNotOfTheRun(const fs::path& run_dir, const fs::path& file) {
  for (const char* name : {"trajectory.csv", "footsteps.csv", "mpc.csv"}) {
    std::error_code ignored;  // a file that is not there yet is none of the run's
    if (!fs::equivalent(file, run_dir / name, ignored)) continue;
    throw ConfigError(file.string() + ": error: is a file of the run itself");
  }
}

// Names that mean something to other programs' readers of tables are none that a run wrote.
void RequirePlainHeader(const std::vector<std::string>& header, const std::string& file) {
  std::set<std::string_view> known;
  std::size_t column = 1;
  for (const std::string& name : header) {
    const auto place = static_cast<int>(column);
    if (name.empty() || name.find_first_not_of(kPlainCharacters) != std::string::npos) {
      throw ConfigError(
          file, 1, place,
          "a column's name must be of letters, digits, '_', '-' or '.', found '" + name + "'");
    }
    if (!known.insert(name).second) {
      throw ConfigError(file, 1, place, "there is a column '" + name + "' already");
    }
    column += name.size() + 1;
  }
}

// As the scenario calls it; empty if it does not.
std::string RobotOf(const fs::path& run_dir) {
  const fs::path file = run_dir / "scenario.yaml";
  const ConfigTree tree = ParseConfig(ReadWholeFile(file), ConfigSource{file.string(), false});
  for (std::size_t i = 0; i < tree.keys.size(); ++i) {
    if (tree.keys[i].text == "robot") return tree.children[i].scalar;
  }
  return {};
}

}  // namespace

std::string GroupedCsv(const CsvTable& trajectory) {
  const std::vector<std::string>& header = trajectory.header();
  std::string text;
  for (std::size_t i = 0; i < header.size(); ++i) {
    text += (i > 0 ? "," : "") + (header[i] == "time_s" ? header[i] : PathText(PathOf(header[i])));
  }
  text += '\n';
  for (std::size_t row = 0; row < trajectory.num_rows(); ++row) {
    for (std::size_t i = 0; i < header.size(); ++i) {
      if (i > 0) text += ',';
      text += trajectory.Cell(row, i);
    }
    text += '\n';
  }
  return text;
}

void ExportRun(const fs::path& run_dir, const fs::path& file) {
  const std::string extension = file.extension();
  if (extension != ".mat" && extension != ".csv") {
    throw ConfigError(file.string() + ": error: expected a name in .mat or .csv");
  }
  RequireNotOfTheRun(run_dir, file);
  const CsvTable trajectory = ReadTrajectory(run_dir);
  if (trajectory.num_rows() == 0) {
    throw ConfigError((run_dir / "trajectory.csv").string() + ": error: holds no row");
  }
  RequirePlainHeader(trajectory.header(), (run_dir / "trajectory.csv").string());
  const std::string robot = RobotOf(run_dir);
  ListIfInRun(run_dir, file);
  if (extension == ".csv") {
    WriteWholeFile(file, GroupedCsv(trajectory));
  } else {
    WriteMat({robot, trajectory.Numbers("time_s"), SignalsOf(trajectory)}, file);
  }
}

}  // namespace sidestep
