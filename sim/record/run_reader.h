// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_reader: reads back what a run left in its folder, but for its summary (run_summary.h).
//
// For the tools that show or check a run afterwards (render, plot, report). A run that was cut
// short is still evidence: a truncated last row is dropped. A file that is missing or is not what
// it should be is a ConfigError that names it.

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sidestep {

/// One foot at one tick. Vectors in W.
struct FootRow {
  Eigen::Vector3d f_F_W;          ///< Ground on robot (N).
  Eigen::Vector3d p_WF;           ///< Where that force acts (m).
  Eigen::Vector3d nominal_p_WF;   ///< Planned place of the current or next contact (m).
  Eigen::Vector3d adjusted_p_WF;  ///< Where the MPC moved it to (m).
};

/// One row of states.bin: the truth at one tick.
struct StateRow {
  double time_s{0.0};
  Eigen::VectorXd qpos;          ///< nq; MuJoCo's order, quaternions w,x,y,z.
  Eigen::Vector3d push_force_W;  ///< The strongest push acting (N); zero if none.
  Eigen::Vector3d push_point_W;  ///< Where it acts (m).
  std::vector<FootRow> feet;     ///< As StateLog::feet.
};

/// All of states.bin.
struct StateLog {
  int nq{0};
  double dt_s{0.0};  ///< Time between rows.
  std::vector<std::string> feet;
  std::vector<StateRow> rows;  ///< At least one, equally spaced.

  /// Time covered by the rows: their number times dt_s.
  double duration_s() const { return dt_s * static_cast<double>(rows.size()); }
};

/// One contact of footsteps.csv. Vectors in W (m).
struct Footstep {
  std::string foot;
  int index{0};
  double start_s{0.0};
  double end_s{0.0};
  Eigen::Vector3d nominal_p_WF;
  Eigen::Vector3d adjusted_p_WF;
  std::optional<Eigen::Vector3d> realised_p_WF;  ///< Empty if the foot never landed.
  double slip_m{0.0};
  /// The box that adjusted - nominal must stay in, x and y of F; NaN if the controller told none.
  Eigen::Vector2d box_lower_m;
  Eigen::Vector2d box_upper_m;
  double yaw_rad{0.0};  ///< Of F about W's z.
};

/// A CSV file with one header row. Cells are views into the file's text, parsed when asked for.
class CsvTable {
 public:
  /// Reads a file; drops a last row with too few cells.
  /// @throws ConfigError if it can't be read, has no header, or another row's width is wrong.
  static CsvTable Read(const std::filesystem::path& file);

  /// The same of a file's text. @param file  For errors.
  static CsvTable Parse(std::string text, const std::filesystem::path& file);

  std::size_t num_rows() const { return num_rows_; }
  const std::vector<std::string>& header() const { return header_; }
  bool has(std::string_view column) const;

  /// A cell by its column's number; valid as long as the table. Precondition: both are there.
  std::string_view Cell(std::size_t row, std::size_t column) const {
    const std::size_t cell = row * header_.size() + column;
    return std::string_view(text_).substr(starts_[cell], lengths_[cell]);
  }

  /// A cell's text. Precondition: row < num_rows().
  /// @throws ConfigError if there is no such column.
  std::string Text(std::size_t row, std::string_view column) const;

  /// A whole column as numbers; NaN for an empty cell or one that is not a number.
  /// @throws ConfigError if there is no such column.
  std::vector<double> Numbers(std::string_view column) const;

 private:
  std::size_t IndexOf(std::string_view column) const;

  std::filesystem::path file_;
  std::vector<std::string> header_;
  std::size_t num_rows_{0};
  std::string text_;
  std::vector<std::size_t> starts_;   ///< Of each cell in text_, row by row.
  std::vector<std::size_t> lengths_;  ///< Of each cell.
};

/// Reads `run_dir/states.bin`.
/// @throws ConfigError if it is missing, not of version 1, its header contradicts itself, or it
///         holds not one whole row; if the run recorded none, how to get it.
StateLog ReadStates(const std::filesystem::path& run_dir);

/// Reads `run_dir/trajectory.csv`, of whatever detail. @throws ConfigError as CsvTable::Read, and
/// as ReadStates if the run recorded none.
CsvTable ReadTrajectory(const std::filesystem::path& run_dir);

/// Reads `run_dir/footsteps.csv`, in order of start. @throws ConfigError as CsvTable::Read.
std::vector<Footstep> ReadFootsteps(const std::filesystem::path& run_dir);

/// A whole file as text. @throws ConfigError naming it if it can't be read.
std::string ReadWholeFile(const std::filesystem::path& file);

/// Feet that trajectory.csv has columns for, in the file's order.
std::vector<std::string> FeetOf(const CsvTable& trajectory);

}  // namespace sidestep
