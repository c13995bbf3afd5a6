// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/run_reader.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "models/support/config_error.h"
#include "models/support/json_text.h"
#include "sim/record/log_detail.h"

namespace sidestep {
namespace {

static_assert(std::endian::native == std::endian::little, "states.bin is little-endian");

constexpr std::string_view kStatesMagic = "sidestep-states 1";
constexpr int kFootDoubles = 12;  ///< Force, point, nominal and adjusted contact.
constexpr int kPushDoubles = 6;   ///< Force and point.

// Far beyond any robot; a header that says more is hostile or broken.
constexpr int kMostCoordinates = 10000;
constexpr std::size_t kMostFeet = 64;
constexpr double kShortestPeriod_s = 1e-6;
constexpr double kLongestPeriod_s = 10.0;

[[noreturn]] void Fail(const std::filesystem::path& file, const std::string& what) {
  throw ConfigError(file.string() + ": error: " + what);
}

/// Reads the two header lines; leaves `in` at the first row.
StateLog ReadStatesHeader(const std::filesystem::path& file, std::istream& in) {
  std::string magic;
  std::string line;
  std::getline(in, magic);
  std::getline(in, line);
  if (magic != kStatesMagic) Fail(file, "is not a states.bin of version 1");
  const auto header = ParseJson<nlohmann::json>(line, file.string());
  const auto whole = [&](const char* key, int most) {
    const auto found = header.find(key);
    const bool is_whole = found != header.end() && found->is_number_integer();
    const auto value = is_whole ? found->get<std::int64_t>() : -1;
    if (value >= 0 && value <= most) return static_cast<int>(value);
    Fail(file, std::string("its header's ") + key + " must be a whole number from 0 to " +
                   std::to_string(most));
  };
  StateLog log;
  log.nq = whole("nq", kMostCoordinates);
  try {
    log.feet = header.at("feet").get<std::vector<std::string>>();
    log.dt_s = header.at("dt_s").get<double>();
  } catch (const nlohmann::json::exception& failure) {
    Fail(file, std::string("its header can't be read: ") + failure.what());
  }
  if (log.feet.size() > kMostFeet) {
    Fail(file, "its header has more than " + std::to_string(kMostFeet) + " feet");
  }
  const int expected = 1 + log.nq + kPushDoubles + kFootDoubles * static_cast<int>(log.feet.size());
  const int row_doubles = whole("row_doubles", std::numeric_limits<int>::max());
  if (row_doubles != expected) {
    Fail(file, "its header says row_doubles = " + std::to_string(row_doubles) + ", expected " +
                   std::to_string(expected));
  }
  if (!(log.dt_s >= kShortestPeriod_s && log.dt_s <= kLongestPeriod_s)) {
    Fail(file, "its header's dt_s must be from 1e-6 to 10 s");
  }
  return log;
}

// Readers find rows by their time.
void RequireSteadyTime(const std::filesystem::path& file, const StateLog& log) {
  const std::size_t row = log.rows.size() - 1;
  const double expected_s = log.rows.front().time_s + log.dt_s * static_cast<double>(row);
  if (std::abs(log.rows.back().time_s - expected_s) < 0.5 * log.dt_s) return;
  Fail(file, "its row " + std::to_string(row) + " is of another time than " +
                 std::to_string(expected_s) + " s");
}

StateRow ParseStateRow(const std::vector<double>& numbers, int nq, std::size_t num_feet) {
  Eigen::Index at = 0;
  const auto take = [&](Eigen::Index count) {
    at += count;
    return Eigen::Map<const Eigen::VectorXd>(numbers.data() + at - count, count);
  };
  StateRow row;
  row.time_s = take(1)(0);
  row.qpos = take(nq);
  row.push_force_W = take(3);
  row.push_point_W = take(3);
  row.feet.resize(num_feet);
  for (FootRow& foot : row.feet) {
    foot.f_F_W = take(3);
    foot.p_WF = take(3);
    foot.nominal_p_WF = take(3);
    foot.adjusted_p_WF = take(3);
  }
  return row;
}

}  // namespace

StateLog ReadStates(const std::filesystem::path& run_dir) {
  const std::filesystem::path file = run_dir / "states.bin";
  RequireTicksFile(run_dir, "states.bin");
  std::ifstream in(file, std::ios::binary);
  if (!in) Fail(file, "can't be read");
  StateLog log = ReadStatesHeader(file, in);
  const std::size_t num_feet = log.feet.size();
  std::vector<double> numbers(1 + static_cast<std::size_t>(log.nq) + kPushDoubles +
                              kFootDoubles * num_feet);
  const auto row_bytes = static_cast<std::streamsize>(numbers.size() * sizeof(double));
  std::vector<char> bytes(static_cast<std::size_t>(row_bytes));
  while (in.read(bytes.data(), row_bytes)) {
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    log.rows.push_back(ParseStateRow(numbers, log.nq, num_feet));
    RequireSteadyTime(file, log);
  }
  if (log.rows.empty()) Fail(file, "holds no state");
  return log;
}

CsvTable ReadTrajectory(const std::filesystem::path& run_dir) {
  RequireTicksFile(run_dir, "trajectory.csv");
  return CsvTable::Read(run_dir / "trajectory.csv");
}

std::vector<Footstep> ReadFootsteps(const std::filesystem::path& run_dir) {
  const CsvTable table = CsvTable::Read(run_dir / "footsteps.csv");
  const auto numbers = [&](const std::string& column) { return table.Numbers(column); };
  const auto triple = [&](const std::string& stem) {
    return std::array{numbers(stem + "_x_m"), numbers(stem + "_y_m"), numbers(stem + "_z_m")};
  };
  const auto index = numbers("index");
  const auto start_s = numbers("start_s");
  const auto end_s = numbers("end_s");
  const auto slip_m = numbers("slip_m");
  const auto nominal = triple("nominal");
  const auto adjusted = triple("adjusted");
  const auto realised = triple("realised");
  const std::array lower{numbers("box_lower_x_m"), numbers("box_lower_y_m")};
  const std::array upper{numbers("box_upper_x_m"), numbers("box_upper_y_m")};
  const auto yaw_rad = numbers("yaw_rad");

  std::vector<Footstep> steps(table.num_rows());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Footstep& step = steps[i];
    const auto at = [i](const auto& xyz) {
      return Eigen::Vector3d(xyz[0][i], xyz[1][i], xyz[2][i]);
    };
    step.foot = table.Text(i, "foot");
    // -1 of a step that the gait does not have; so too of what is no number of one.
    const bool is_count = index[i] >= 0.0 && index[i] <= std::numeric_limits<int>::max();
    step.index = is_count ? static_cast<int>(index[i]) : -1;
    step.start_s = start_s[i];
    step.end_s = end_s[i];
    step.slip_m = slip_m[i];
    step.nominal_p_WF = at(nominal);
    step.adjusted_p_WF = at(adjusted);
    if (at(realised).allFinite()) step.realised_p_WF = at(realised);
    step.box_lower_m << lower[0][i], lower[1][i];
    step.box_upper_m << upper[0][i], upper[1][i];
    step.yaw_rad = yaw_rad[i];
  }
  return steps;
}

std::string ReadWholeFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || std::filesystem::is_directory(file)) Fail(file, "can't be read");
  text << in.rdbuf();
  return std::move(text).str();
}

std::vector<std::string> FeetOf(const CsvTable& trajectory) {
  constexpr std::string_view kPrefix = "truth_contact_";
  std::vector<std::string> feet;
  for (const std::string& column : trajectory.header()) {
    if (column.starts_with(kPrefix)) feet.push_back(column.substr(kPrefix.size()));
  }
  return feet;
}

}  // namespace sidestep
