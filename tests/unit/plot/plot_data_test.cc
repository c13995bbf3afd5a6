// SPDX-License-Identifier: BSD-3-Clause
// What the gait diagram and the phase portraits draw, of runs whose motion is known.
#include "sim/plot/plot_data.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

#include "models/support/config_error.h"
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
const plot::PlottedRun& PitchingRun() {
  static const plot::PlottedRun kRun = [] {
    constexpr double kTwoPi = 2.0 * std::numbers::pi;
    const fs::path dir = FreshTestDir("pitching");
    WriteSyntheticRun(dir, {.duration_s = 1.0, .dt_s = 0.002});
    const auto half_rad = [](double time_s) { return 0.05 * std::sin(kTwoPi * time_s); };
    Replace(dir, "truth_q_WB_w", [=](double t) { return Number(std::cos(half_rad(t))); });
    Replace(dir, "truth_q_WB_y", [=](double t) { return Number(std::sin(half_rad(t))); });
    for (const char* still : {"truth_q_WB_x", "truth_p_WC_y_m", "truth_v_WC_y_mps"}) {
      Replace(dir, still, [](double) { return "0"; });
    }
    return plot::ReadPlottedRun(dir);
  }();
  return kRun;
}

const plot::PlotData& Pitching() {
  static const plot::PlotData kData = plot::SelectPlotData(PitchingRun());
  return kData;
}

// A curve as gnuplot reads it.
std::vector<Eigen::Vector2f> SamplesOf(const plot::CurveFile& curves, const std::string& name) {
  const std::string macro = curves.Macro(name);
  const std::string line = curves.Definitions(macro);
  const auto number = [&](const std::string& key) {
    return std::stoul(line.substr(line.find(key) + key.size()));
  };
  std::vector<Eigen::Vector2f> samples(number("record="));
  std::memcpy(static_cast<void*>(samples.data()), curves.bytes().data() + number("skip="),
              samples.size() * sizeof(Eigen::Vector2f));
  return samples;
}

constexpr double kPitchRow_s = 0.002;

// Pitch (rad) and its rate (rad/s) of the base that Pitching() shows.
Eigen::Vector2d PitchAt(double time_s) {
  const double phase_rad = 2.0 * std::numbers::pi * time_s;
  return {0.1 * std::sin(phase_rad), 0.2 * std::numbers::pi * std::cos(phase_rad)};
}

// The row's time at which pitch and rate are those of the point.
double TimeOf(const Eigen::Vector2d& point) {
  const double turns =
      std::atan2(point.x() / 0.1, point.y() / (0.2 * std::numbers::pi)) / (2.0 * std::numbers::pi);
  return std::round((turns < 0.0 ? turns + 1.0 : turns) / kPitchRow_s) * kPitchRow_s;
}

// Of a portrait's part: its points but for gaps.
std::vector<Eigen::Vector2d> PitchPoints(const plot::PlotData& data, const std::string& when) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2f& sample : SamplesOf(data.curves, "truth_pitch_rad_" + when)) {
    if (sample.allFinite()) points.push_back(sample.cast<double>());
  }
  return points;
}

// Each point is a row's to the last digits, and no row between two of them is farther from the line
// that joins them than a 2000th of the portrait's width and height.
void ExpectRows(const std::vector<Eigen::Vector2d>& points, double from_s, double to_s) {
  const Eigen::Vector2d scale(1.0 / 0.2, 1.0 / (0.4 * std::numbers::pi));
  ASSERT_GT(points.size(), 5U);
  EXPECT_NEAR(TimeOf(points.front()), from_s, 1e-9);
  EXPECT_NEAR(TimeOf(points.back()), to_s, 1e-9);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double time_s = TimeOf(points[i]);
    const Eigen::Vector2d row = PitchAt(time_s);
    EXPECT_NEAR(points[i].x(), row.x(), 1e-7) << time_s;
    EXPECT_NEAR(points[i].y(), row.y(), 1e-4) << time_s << ": a difference of rows";
    if (i + 1 == points.size()) break;
    const double next_s = TimeOf(points[i + 1]);
    EXPECT_GT(next_s, time_s) << "clockwise, as time goes";
    const Eigen::Vector2d chord = scale.cwiseProduct(points[i + 1] - points[i]).normalized();
    for (double t = time_s + kPitchRow_s; t < next_s - 0.5 * kPitchRow_s; t += kPitchRow_s) {
      const Eigen::Vector2d off = scale.cwiseProduct(PitchAt(t) - points[i]);
      EXPECT_LT((off - chord * chord.dot(off)).norm(), std::sqrt(2.0) / 2000.0) << t;
    }
  }
}

TEST(PlotDataTest, PitchAndItsRateAreThoseOfTheBase) {
  ExpectRows(PitchPoints(Pitching(), "before"), 0.0, 0.2);
  ExpectRows(PitchPoints(Pitching(), "pushed"), 0.2, 0.3);
  ExpectRows(PitchPoints(Pitching(), "after"), 0.302, 0.998);
}

TEST(PlotDataTest, AStretchsFirstAndLastRowHaveTheRatesThatTheyHaveInTheRun) {
  const plot::PlotData data = plot::SelectPlotData(PitchingRun(), plot::Stretch{0.4, 0.6});
  ExpectRows(PitchPoints(data, "after"), 0.4, 0.6);
}

TEST(PlotDataTest, ARollBeyondHalfATurnGoesOn) {
  const fs::path dir = FreshTestDir("rolling");
  WriteSyntheticRun(dir, {.duration_s = 1.0});
  constexpr double kRate_radps = 5.0;
  Replace(dir, "truth_q_WB_w", [=](double t) { return Number(std::cos(0.5 * kRate_radps * t)); });
  Replace(dir, "truth_q_WB_x", [=](double t) { return Number(std::sin(0.5 * kRate_radps * t)); });
  for (const char* still : {"truth_q_WB_y", "truth_q_WB_z"}) {
    Replace(dir, still, [](double) { return "0"; });
  }
  const plot::PlotData data = plot::LoadPlotData(dir);
  EXPECT_NEAR(data.curves.XOf("truth_roll_rad_after").max, kRate_radps * data.end_s, 1e-6);
  EXPECT_NEAR(data.curves.YOf("truth_roll_rad_after").min, kRate_radps, 1e-6);
  EXPECT_NEAR(data.curves.YOf("truth_roll_rad_after").max, kRate_radps, 1e-6);
}

TEST(PlotDataTest, WhatDoesNotMoveHasNoPortrait) {
  const plot::PlotData& data = Pitching();
  EXPECT_EQ(data.phases, (std::vector<std::string>{"truth_pitch_rad"}));
  plot::Span pitch_rad;
  for (const char* when : {"before", "pushed", "after"}) {
    pitch_rad.Include(data.curves.XOf(std::string("truth_pitch_rad_") + when));
  }
  EXPECT_NEAR(pitch_rad.min, -0.1, 1e-6);
  EXPECT_NEAR(pitch_rad.max, 0.1, 1e-6);
  const std::string script = plot::PhasePortraitScript(data);
  EXPECT_NE(script.find("pitch of the base"), std::string::npos);
  EXPECT_EQ(script.find("roll of the base"), std::string::npos);
}

TEST(PlotDataTest, StepsAreNumberedByTouchDownAndTheFarthestMovedAreMarked) {
  const fs::path dir = FreshTestDir("steps");
  WriteSyntheticRun(dir, {.duration_s = 2.0});
  std::ofstream(dir / "footsteps.csv", std::ios::app)
      << "left,1,1.2,2,0.2,0.08,0,0.205,0.08,0,0.2,0.08,0,0,-0.1,-0.1,0.1,0.1,0\n";
  const plot::PlotData data = plot::LoadPlotData(dir);
  ASSERT_EQ(data.steps.size(), 4U);
  EXPECT_EQ(data.steps[0].number, 0) << "stood from the start";
  EXPECT_EQ(data.steps[1].number, 0);
  EXPECT_EQ(data.steps[2].number, 1);
  EXPECT_EQ(data.steps[3].number, 2);
  EXPECT_TRUE(data.steps[2].is_far_moved) << "5 cm";
  EXPECT_FALSE(data.steps[3].is_far_moved) << "5 mm";
  EXPECT_DOUBLE_EQ(data.steps[2].lift_s, data.steps[1].step.end_s);
}

TEST(PlotDataTest, SolesAreThoseOfTheRobotAndPointsWhereThatIsGone) {
  const fs::path dir = FreshTestDir("soles");
  WriteSyntheticRun(dir);
  EXPECT_EQ(plot::LoadPlotData(dir).soles.at(0).size(), 1U) << "a point foot";
  ::sidestep::testing::GiveItSoles(dir);
  EXPECT_EQ(plot::LoadPlotData(dir).soles.at(0).size(), 4U);
  fs::remove(dir / "scenario.yaml");
  const plot::PlotData data = plot::LoadPlotData(dir);
  ASSERT_EQ(data.soles.size(), 2U);
  EXPECT_TRUE(data.soles[0].empty());
  EXPECT_NE(plot::TopViewScript(data).find("with points pointtype 7"), std::string::npos);
}

TEST(PlotDataTest, AStretchHoldsItsOwnTimeAndWhatItSees) {
  const fs::path dir = FreshTestDir("stretch");
  WriteSyntheticRun(dir, {.duration_s = 2.0, .push_start_s = 1.0});
  const plot::PlottedRun run = plot::ReadPlottedRun(dir);
  const plot::PlotData data = plot::SelectPlotData(run, plot::Stretch{0.9, 1.25});
  EXPECT_NEAR(data.start_s, 0.9, 1e-9);
  EXPECT_NEAR(data.end_s, 1.25, 1e-9);
  EXPECT_NEAR(data.curves.XOf("truth_p_WC_x_m").max, 1.25, 1e-9);
  EXPECT_EQ(data.push_marks.size(), 1U);
  EXPECT_TRUE(plot::SelectPlotData(run, plot::Stretch{0.0, 0.5}).push_marks.empty());
  EXPECT_THROW(plot::SelectPlotData(run, plot::Stretch{5.0, 6.0}), ConfigError);
}

}  // namespace
}  // namespace sidestep::plot_data_test
