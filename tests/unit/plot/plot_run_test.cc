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
#include <regex>
#include <set>
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
    ::sidestep::testing::GiveItSoles(dir);
    PlotRun(dir, {.formats = {"svg", "png"}});
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
  EXPECT_TRUE(Has(svg("top_view"), "left, stood"));
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

// What gnuplot would draw: it tables that.
std::vector<Eigen::Vector2d> Tabled(const std::string& plot) {
  const auto plots = PlottedRun() / "plots";
  RunTool({"gnuplot", "-e", "set table 'table.txt'", plot + ".gp"}, "", plots);
  return Numbers(TextOf(plots / "table.txt"));
}

void ExpectDrawn(const std::vector<Eigen::Vector2d>& drawn, const Eigen::Vector2d& expected) {
  EXPECT_TRUE(std::any_of(drawn.begin(), drawn.end(), [&](const Eigen::Vector2d& point) {
    return (point - expected).norm() < 1e-4;
  })) << expected.transpose();
}

TEST(PlotRunTest, BoxesAndSolesOfTheTopViewAreTurnedByTheFootsYaw) {
  // The last foothold is turned by 0.3 rad; its box is about (0.1, -0.08), its sole where it stood.
  const std::vector<Eigen::Vector2d> drawn = Tabled("top_view");
  const Eigen::Rotation2Dd turn(0.3);
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(-0.05, -0.03), Eigen::Vector2d(0.05, -0.03), Eigen::Vector2d(0.05, 0.07),
        Eigen::Vector2d(-0.05, 0.07)}) {
    ExpectDrawn(drawn, Eigen::Vector2d(0.1, -0.08) + turn * corner);
  }
  const plot::PlotData data = plot::LoadPlotData(PlottedRun());
  ASSERT_EQ(data.soles.at(1).size(), 4U);
  for (const Eigen::Vector2d& corner : data.soles[1]) {
    ExpectDrawn(drawn, Eigen::Vector2d(0.118, -0.032) + turn * corner);
  }
}

// Ranges of x and y that a script sets last.
std::pair<plot::Span, plot::Span> RangesOf(const std::string& script) {
  const auto range = [&](const std::string& axis) {
    const std::string words = "set " + axis + "range [";
    plot::Span span;
    char colon = 0;
    std::istringstream(script.substr(script.rfind(words) + words.size())) >> span.min >> colon >>
        span.max;
    return span;
  };
  return {range("x"), range("y")};
}

TEST(PlotRunTest, RangesHoldAllThatIsDrawn) {
  const auto [x, y] = RangesOf(TextOf(PlottedRun() / "plots" / "top_view.gp"));
  ASSERT_FALSE(x.is_empty() || y.is_empty());
  for (const Eigen::Vector2d& point : Tabled("top_view")) {
    EXPECT_TRUE(point.x() >= x.min && point.x() <= x.max) << point.transpose();
    EXPECT_TRUE(point.y() >= y.min && point.y() <= y.max) << point.transpose();
  }
}

TEST(PlotRunTest, TheAllowedAdjustmentIsABandFromLiftOffToTheNext) {
  const std::string script = TextOf(PlottedRun() / "plots" / "step_adjustment.gp");
  EXPECT_TRUE(Has(script, "with boxxyerror"));
  EXPECT_FALSE(Has(script, "yerrorbars"));
  EXPECT_TRUE(Has(script, "0.6 -0.03 0.6 1.99 -0.03 0.07"))
      << "of the right foot's step to the side";
}

TEST(PlotRunTest, SolveTimesHaveALogarithmicAxisOfWholeDecades) {
  const std::string script = TextOf(PlottedRun() / "plots" / "mpc_time.gp");
  EXPECT_TRUE(Has(script, "set logscale y 10")) << script;
  EXPECT_TRUE(Has(script, "set yrange [1:100]")) << "4 to 6.8 ms, deadline 50 ms";
}

TEST(PlotRunTest, EveryPlotHasALegend) {
  for (const std::string& name : PlotNames()) {
    const std::string script = TextOf(PlottedRun() / "plots" / (name + ".gp"));
    EXPECT_TRUE(Has(script, " title '")) << name;
    EXPECT_TRUE(Has(script, "set key")) << name;
  }
}

TEST(PlotRunTest, TheTimeAroundEachPushIsDrawnInFilesOfItsOwn) {
  const auto dir = FreshTestDir("plots_around");
  WriteSyntheticRun(dir, {.duration_s = 2.0, .push_start_s = 0.8});
  const auto pictures = PlotRun(dir, {.only = {"com"}, .around_s = 0.3});
  ASSERT_EQ(pictures.size(), 1U);
  EXPECT_EQ(pictures[0], dir / "plots" / "com_push1.svg");
  EXPECT_TRUE(Has(TextOf(dir / "plots" / "com_push1.gp"), "set xrange [0.5:1.2]"));
  EXPECT_TRUE(Has(TextOf(pictures[0]), "toy_push_left (PASS), push 1"));
  const std::string listed = TextOf(dir / "run_files.txt");
  for (const char* file : {"com_push1.gp", "com_push1.svg", "curves_push1.bin"}) {
    EXPECT_TRUE(Has(listed, std::string("plots/") + file)) << "else --force would leave it";
  }
  EXPECT_FALSE(std::filesystem::exists(dir / "plots" / "com.svg"));
}

TEST(PlotRunTest, APapersPlotIsAsLargeAsItWants) {
  const auto dir = FreshTestDir("plots_paper");
  WriteSyntheticRun(dir);
  PlotOptions options{.only = {"com"}, .formats = {"svg", "pdf", "png"}};
  options.canvas = plot::ReadCanvas("127x50.8mm");
  PlotRun(dir, options);
  EXPECT_TRUE(Has(TextOf(dir / "plots" / "com_127x50.8mm.svg"), "width=\"480\" height=\"192\""));
  const std::string pdf = TextOf(dir / "plots" / "com_127x50.8mm.pdf");
  EXPECT_TRUE(Has(pdf, "360 144")) << "points, 72 an inch";
  const std::string png = TextOf(dir / "plots" / "com_127x50.8mm.png");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\x05\xdc\0\0\x02\x58", 8)) << "at 300 dpi";
}

TEST(PlotRunTest, APapersColumnKeepsItsLegend) {
  const auto dir = FreshTestDir("plots_column_of_paper");
  WriteSyntheticRun(dir);
  PlotOptions options;
  options.canvas = plot::ReadCanvas("88mm");
  PlotRun(dir, options);
  const std::string com = TextOf(dir / "plots" / "com_88mm.svg");
  for (const char* word : {"true", "reference", "believed", "planned by the MPC", "push"}) {
    EXPECT_TRUE(Has(com, std::string("<text>") + word + "</text>")) << word;
  }
  const std::string steps = TextOf(dir / "plots" / "step_adjustment_88mm.svg");
  for (const char* word : {"left, allowed", "right, planned", "right, taken", "push"}) {
    EXPECT_TRUE(Has(steps, std::string("<text>") + word + "</text>")) << word;
  }
}

TEST(PlotRunTest, AnUnknownPlotTellsTheNearestAndAllThatThereAre) {
  const std::string error = ErrorOf([] { PlotRun(PlottedRun(), {.only = {"com", "topview"}}); });
  EXPECT_TRUE(Has(error, "there is no plot 'topview', did you mean 'top_view'?")) << error;
  EXPECT_TRUE(Has(error, "momentum, mpc_time")) << error;
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 0) << error;
}

// An SVG from its first grid line on, without the numbers that gnuplot counts its curves by. What
// stands before that has the pen that the plot before left.
std::string DrawnOf(const std::string& svg) {
  return std::regex_replace(svg.substr(std::min(svg.find("class=\"gridline\""), svg.size())),
                            std::regex("gnuplot_plot_[0-9]+"), "gnuplot_plot_");
}

TEST(PlotRunTest, AScriptDrawsItsPlotAgainByItself) {
  const auto plots = PlottedRun() / "plots";
  const std::string before = TextOf(plots / "com.svg");
  std::filesystem::remove(plots / "com.svg");
  RunTool({"gnuplot", "com.gp"}, "", plots);
  EXPECT_GT(DrawnOf(before).size(), 5000U);
  EXPECT_TRUE(DrawnOf(TextOf(plots / "com.svg")) == DrawnOf(before));
}

TEST(PlotRunTest, ALongRunIsThinned) {
  const auto dir = FreshTestDir("plots_long");
  WriteSyntheticRun(dir, {.duration_s = 5.0, .dt_s = 0.001});
  const plot::PlotData data = plot::LoadPlotData(dir);
  std::set<std::string> curves;  // lines that tell where a curve of the file is
  for (const plot::PlotScript& script : plot::AllScripts()) {
    std::istringstream lines(data.curves.Definitions(script.body(data)));
    for (std::string line; std::getline(lines, line);) {
      if (Has(line, " record=")) curves.insert(line);
    }
  }
  const std::size_t rows = CsvTable::Read(dir / "trajectory.csv").Numbers("time_s").size();
  const std::size_t samples = data.curves.bytes().size() / (2 * sizeof(float));
  ASSERT_EQ(rows, 5000U);
  EXPECT_LT(samples, rows * curves.size() / 10) << "smooth curves need few samples";
  EXPECT_GT(samples, 2 * curves.size()) << "more than a line's ends";
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
  EXPECT_TRUE(Has(ErrorOf([&] { PlotRun(dir); }), "has no column 'truth_p_WC_x_m'"));
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
