// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_run.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "models/support/config_error.h"
#include "sim/plot/plot_script.h"
#include "sim/process/process.h"
#include "sim/record/run_summary.h"
#include "tests/support/synthetic_run.h"

namespace sidestep::plot_run_test {
namespace {

using ::sidestep::testing::FreshTestDir;
using ::sidestep::testing::WriteSyntheticRun;

std::string TextOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string ErrorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// One run, plotted once for all tests that only look.
const std::filesystem::path& PlottedRun() {
  static const std::filesystem::path kDir = [] {
    auto dir = FreshTestDir("plots");
    WriteSyntheticRun(dir, {.name = "it's_a_toy", .duration_s = 2.0, .push_start_s = 0.5});
    PlotRun(dir, PlotFiles::kSvgAndPng);
    return dir;
  }();
  return kDir;
}

TEST(PlotRunTest, EachPlotIsAWholeSvgAndAWholePngOfFullSize) {
  ASSERT_GE(PlotNames().size(), 6U);
  for (const std::string& name : PlotNames()) {
    const std::string svg = TextOf(PlottedRun() / "plots" / (name + ".svg"));
    EXPECT_GT(svg.size(), 5000U) << name;
    EXPECT_TRUE(Has(svg, "<svg") && Has(svg, "</svg>")) << name;
    const std::string png = TextOf(PlottedRun() / "plots" / (name + ".png"));
    ASSERT_GT(png.size(), 10000U) << name;
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n") << name;
    EXPECT_EQ(png.substr(16, 8), std::string("\0\0\x03\xe8\0\0\x02\xbc", 8)) << "1000 x 700";
    EXPECT_TRUE(Has(png, "IEND")) << name;
  }
}

TEST(PlotRunTest, PlotsOverTimeShadeThePush) {
  for (const std::string name : {"com", "contact_forces", "external_wrench", "feet", "gait",
                                 "momentum", "step_adjustment"}) {
    const std::string svg = TextOf(PlottedRun() / "plots" / (name + ".svg"));
    EXPECT_TRUE(Has(svg, "204,   0, 102") || Has(svg, "#cc0066") || Has(svg, "#CC0066")) << name;
    EXPECT_TRUE(Has(TextOf(PlottedRun() / "plots" / (name + ".gp")),
                    "rectangle from 0.5, graph 0 to 0.6, graph 1"))
        << name;
  }
}

TEST(PlotRunTest, TitlesUnitsAndFeetAreWritten) {
  const auto svg = [](const char* name) {
    return TextOf(PlottedRun() / "plots" / (std::string(name) + ".svg"));
  };
  EXPECT_TRUE(Has(svg("com"), "centre of mass"));
  EXPECT_TRUE(Has(svg("com"), "(m/s)"));
  EXPECT_TRUE(Has(svg("top_view"), "left, adjusted"));
  EXPECT_TRUE(Has(svg("contact_forces"), "right, MPC"));
  EXPECT_TRUE(Has(svg("external_wrench"), "moment about C"));
  EXPECT_TRUE(Has(svg("external_wrench"), "believed"));
  EXPECT_TRUE(Has(svg("feet"), "CoP, y from F (m)"));
  EXPECT_TRUE(Has(svg("gait"), "right, planned"));
  EXPECT_TRUE(Has(svg("gait"), "who stands when"));
  EXPECT_TRUE(Has(svg("phase_portrait"), "before the first push"));
  EXPECT_TRUE(Has(svg("phase_portrait"), "rate (rad/s)"));
  EXPECT_TRUE(Has(svg("mpc_time"), "deadline"));
  EXPECT_TRUE(Has(svg("mpc_time"), "iterations"));
}

/// Points "x y" that gnuplot draws for `script` run after the data of a plotted run.
std::vector<Eigen::Vector2d> Numbers(const std::string& table) {
  std::vector<Eigen::Vector2d> points;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    Eigen::Vector2d point;
    if (std::istringstream(line) >> point.x() >> point.y()) points.push_back(point);
  }
  return points;
}

TEST(PlotRunTest, BoxesOfTheTopViewAreTurnedByTheFootsYaw) {
  // gnuplot tables what it would draw; the last foothold is turned by 0.3 rad about (0.1, -0.08).
  const auto plots = PlottedRun() / "plots";
  const std::string script = TextOf(plots / "top_view.gp");
  RunTool({"gnuplot", "-e", "set table 'top_view.txt'", "top_view.gp"}, "", plots);
  const std::vector<Eigen::Vector2d> drawn = Numbers(TextOf(plots / "top_view.txt"));
  const Eigen::Rotation2Dd turn(0.3);
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(-0.05, -0.03), Eigen::Vector2d(0.05, -0.03), Eigen::Vector2d(0.05, 0.07),
        Eigen::Vector2d(-0.05, 0.07)}) {
    const Eigen::Vector2d expected = Eigen::Vector2d(0.1, -0.08) + turn * corner;
    EXPECT_TRUE(std::any_of(drawn.begin(), drawn.end(), [&](const Eigen::Vector2d& point) {
      return (point - expected).norm() < 1e-4;
    })) << expected.transpose();
  }
}

TEST(PlotRunTest, AScriptDrawsItsPlotAgainByItself) {
  const auto plots = PlottedRun() / "plots";
  const std::string before = TextOf(plots / "com.svg");
  std::filesystem::remove(plots / "com.svg");
  RunTool({"gnuplot", "com.gp"}, "", plots);
  EXPECT_EQ(TextOf(plots / "com.svg").size(), before.size());
}

TEST(PlotRunTest, ALongRunIsThinned) {
  const auto dir = FreshTestDir("plots_long");
  WriteSyntheticRun(dir, {.duration_s = 5.0, .dt_s = 0.001});
  const std::string csv = plot::LoadPlotData(dir).thinned_csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 1667) << "every third of 5000 rows";
}

TEST(PlotRunTest, ARunWithoutPushesStepsAndSolvesIsPlotted) {
  const auto dir = FreshTestDir("plots_bare");
  WriteSyntheticRun(dir);
  for (const char* file : {"footsteps.csv", "mpc.csv"}) {
    const std::string text = TextOf(dir / file);
    std::ofstream(dir / file) << text.substr(0, text.find('\n') + 1);
  }
  std::ofstream(dir / "summary.json") << SummaryJson(RunSummary());  // nothing was measured
  PlotRun(dir);
  EXPECT_GT(TextOf(dir / "plots" / "mpc_time.svg").size(), 2000U);
}

TEST(PlotRunTest, AMissingFileOrColumnIsNamed) {
  for (const char* file : {"trajectory.csv", "footsteps.csv", "mpc.csv", "summary.json"}) {
    const auto dir = FreshTestDir("plots_missing");
    WriteSyntheticRun(dir);
    std::filesystem::remove(dir / file);
    EXPECT_TRUE(Has(ErrorOf([&] { PlotRun(dir); }), (dir / file).string())) << file;
  }
  const auto dir = FreshTestDir("plots_column");
  WriteSyntheticRun(dir);
  std::ofstream(dir / "trajectory.csv") << "time_s\n0\n";
  EXPECT_TRUE(Has(ErrorOf([&] { PlotRun(dir); }), "has no column 'truth_tilt_rad'"));
}

// Foreign folders hold any names. In gnuplot's double quotes a backtick runs a command.
TEST(PlotRunTest, AFootsNameRunsNoCommand) {
  const auto dir = FreshTestDir("hostile_foot");
  WriteSyntheticRun(dir);
  for (const char* file : {"trajectory.csv", "footsteps.csv"}) {
    std::string text = TextOf(dir / file);
    for (std::size_t at = 0; (at = text.find("left", at)) != std::string::npos;) {
      text.replace(at, 4, "`touch PWNED`");
    }
    std::ofstream(dir / file, std::ios::binary) << text;
  }
  PlotRun(dir);
  EXPECT_FALSE(std::filesystem::exists(dir / "plots" / "PWNED"));
  EXPECT_TRUE(Has(TextOf(dir / "plots" / "contact_forces.svg"), "touch PWNED")) << "as a word";
}

TEST(PlotRunTest, WithoutGnuplotTheErrorSaysSo) {
  const auto dir = FreshTestDir("plots_no_gnuplot");
  WriteSyntheticRun(dir);
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const std::string error = ErrorOf([&] { PlotRun(dir); });
  setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(Has(error, "can't start gnuplot")) << error;
}

}  // namespace
}  // namespace sidestep::plot_run_test
