// SPDX-License-Identifier: BSD-3-Clause
// What the gait diagram and the phase portraits draw, of runs whose motion is known.
#include "sim/plot/plot_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

#include "sim/plot/plot_script.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"
#include "tests/support/synthetic_run.h"

namespace sidestep::plot_data_test {
namespace {

using ::sidestep::testing::FreshTestDir;
using ::sidestep::testing::WriteSyntheticRun;
namespace fs = std::filesystem;

// A cell of the column at a time.
using CellOf = std::function<std::string(double time_s)>;

std::string Number(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

// Writes the run's trajectory again with another column of that name.
void Replace(const fs::path& dir, const std::string& column, const CellOf& cell) {
  const CsvTable table = CsvTable::Read(dir / "trajectory.csv");
  std::ostringstream text;
  const auto add_row = [&](const std::function<std::string(const std::string&)>& value) {
    for (const std::string& name : table.header()) {
      text << (name == table.header().front() ? "" : ",") << value(name);
    }
    text << "\n";
  };
  add_row([](const std::string& name) { return name; });
  const std::vector<double> time_s = table.Numbers("time_s");
  for (std::size_t row = 0; row < time_s.size(); ++row) {
    add_row([&](const std::string& name) {
      return name == column ? cell(time_s[row]) : table.Text(row, name);
    });
  }
  std::ofstream(dir / "trajectory.csv") << text.str();
}

CellOf StandsBut(double from_s, double to_s) {
  constexpr double kHalfRow_s = 0.005;
  return [=](double time_s) {
    return time_s > from_s - kHalfRow_s && time_s < to_s - kHalfRow_s ? "0" : "1";
  };
}

void ExpectStretches(const std::vector<plot::Stretch>& stretches,
                     const std::vector<std::pair<double, double>>& expected) {
  ASSERT_EQ(stretches.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(stretches[i].start_s, expected[i].first, 1e-12);
    EXPECT_NEAR(stretches[i].end_s, expected[i].second, 1e-12);
  }
}

TEST(PlotDataTest, ContactsAndFlightsAreStretchesOfTime) {
  const fs::path dir = FreshTestDir("gait");
  WriteSyntheticRun(dir, {.duration_s = 0.5});
  Replace(dir, "truth_contact_left", StandsBut(0.10, 0.25));
  Replace(dir, "truth_contact_right", StandsBut(0.20, 0.40));
  Replace(dir, "planned_contact_left", StandsBut(0.12, 0.24));
  Replace(dir, "planned_contact_right", [](double) { return ""; });
  const plot::PlotData data = plot::LoadPlotData(dir);
  ASSERT_EQ(data.contacts.size(), 2u);
  ExpectStretches(data.contacts[0].truth, {{0.0, 0.10}, {0.25, data.end_s}});
  ExpectStretches(data.contacts[1].truth, {{0.0, 0.20}, {0.40, data.end_s}});
  ExpectStretches(data.contacts[0].planned, {{0.0, 0.12}, {0.24, data.end_s}});
  ExpectStretches(data.contacts[1].planned, {});
  ExpectStretches(data.flights, {{0.20, 0.25}});
}

TEST(PlotDataTest, ABounceIsNoFlight) {
  const fs::path dir = FreshTestDir("bounce");
  WriteSyntheticRun(dir, {.duration_s = 0.5});
  for (const char* foot : {"left", "right"}) {
    Replace(dir, std::string("truth_contact_") + foot, StandsBut(0.30, 0.31));
  }
  const plot::PlotData data = plot::LoadPlotData(dir);
  EXPECT_EQ(data.contacts[0].truth.size(), 2u);
  ExpectStretches(data.flights, {});
  EXPECT_EQ(plot::GaitScript(data).find("flight"), std::string::npos) << "nor a line for it";
}

TEST(PlotDataTest, TheGaitDiagramNamesTheGaitsThatWereAskedFor) {
  const fs::path dir = FreshTestDir("gaits");
  WriteSyntheticRun(dir);
  RunSummary summary = ReadSummary(dir);
  summary.gaits.resize(2);
  summary.gaits[0] = {GaitType::kWalk, 0.0, {}};
  summary.gaits[1] = {GaitType::kRun, 0.25, {}};
  std::ofstream(dir / "summary.json") << SummaryJson(summary);
  const std::string script = plot::GaitScript(plot::LoadPlotData(dir));
  EXPECT_NE(script.find("set label ' walk' at 0, graph"), std::string::npos);
  EXPECT_NE(script.find("set label ' run' at 0.25, graph"), std::string::npos);
}

TEST(PlotDataTest, ARunOfManyStepsIsBrokenIntoRows) {
  plot::PlotData data;
  data.end_s = 40.0;
  data.feet = {"foot"};
  data.contacts.resize(1);
  const auto rows = [&](std::size_t steps) {
    data.contacts[0].truth.assign(steps, {1.0, 2.0});
    const std::string script = plot::GaitScript(data);
    return script.substr(script.find("layout ") + 7, 3);
  };
  EXPECT_EQ(rows(0), "1,1");
  EXPECT_EQ(rows(12), "1,1");
  EXPECT_EQ(rows(13), "2,1");
  EXPECT_EQ(rows(1000), "4,1");
}

// The base pitches by 0.1 sin(2 pi t) and the CoM does not leave its plane.
const plot::PlotData& Pitching() {
  static const plot::PlotData kData = [] {
    constexpr double kTwoPi = 2.0 * std::numbers::pi;
    const fs::path dir = FreshTestDir("pitching");
    WriteSyntheticRun(dir, {.duration_s = 1.0, .dt_s = 0.002});
    const auto half_rad = [](double time_s) { return 0.05 * std::sin(kTwoPi * time_s); };
    Replace(dir, "truth_q_WB_w", [=](double t) { return Number(std::cos(half_rad(t))); });
    Replace(dir, "truth_q_WB_y", [=](double t) { return Number(std::sin(half_rad(t))); });
    for (const char* still : {"truth_q_WB_x", "truth_p_WC_y_m", "truth_v_WC_y_mps"}) {
      Replace(dir, still, [](double) { return "0"; });
    }
    return plot::LoadPlotData(dir);
  }();
  return kData;
}

TEST(PlotDataTest, PitchAndItsRateAreThoseOfTheBase) {
  std::istringstream csv(Pitching().phase_csv);
  std::string line;
  std::getline(csv, line);
  ASSERT_EQ(line,
            "time_s,truth_p_WC_y_m,truth_v_WC_y_mps,truth_p_WC_z_m,truth_v_WC_z_mps,truth_roll_rad,"
            "truth_roll_radps,truth_pitch_rad,truth_pitch_radps");
  int rows = 0;
  while (std::getline(csv, line)) {
    std::istringstream cells(line);
    std::vector<double> numbers;
    for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
    ASSERT_EQ(numbers.size(), 9u);
    const double phase_rad = 2.0 * std::numbers::pi * numbers[0];
    EXPECT_NEAR(numbers[7], 0.1 * std::sin(phase_rad), 1e-7);
    if (rows++ == 0 || numbers[0] > 0.997) continue;  // the ends have no difference
    EXPECT_NEAR(numbers[8], 0.2 * std::numbers::pi * std::cos(phase_rad), 1e-4);
  }
  EXPECT_EQ(rows, 500);
}

TEST(PlotDataTest, WhatDoesNotMoveHasNoPortrait) {
  const plot::PlotData& data = Pitching();
  for (const plot::PhaseRange& phase : data.phases) {
    EXPECT_NE(phase.column, "truth_p_WC_y_m");
    EXPECT_NE(phase.column, "truth_roll_rad");
  }
  ASSERT_FALSE(data.phases.empty());
  const plot::PhaseRange& pitch = data.phases.back();
  EXPECT_EQ(pitch.column, "truth_pitch_rad");
  EXPECT_NEAR(pitch.min, -0.1, 1e-6);
  EXPECT_NEAR(pitch.max, 0.1, 1e-6);
  const std::string script = plot::PhasePortraitScript(data);
  EXPECT_NE(script.find("pitch of the base"), std::string::npos);
  EXPECT_EQ(script.find("roll of the base"), std::string::npos);
  EXPECT_NE(script.find("set xtics 0.05\n"), std::string::npos) << "a fifth of 0.2 is 0.04";
}

}  // namespace
}  // namespace sidestep::plot_data_test
