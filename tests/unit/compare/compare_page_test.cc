// SPDX-License-Identifier: BSD-3-Clause
#include "sim/compare/compare_page.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "models/support/config_error.h"
#include "sim/compare/overlay_plots.h"
#include "sim/record/run_reader.h"
#include "tests/support/synthetic_run.h"

namespace sidestep::compare_page_test {
namespace {

namespace fs = std::filesystem;
using ::sidestep::testing::FreshTestDir;
using ::sidestep::testing::WriteSyntheticRun;

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

RunComparison Parted() {
  RunComparison comparison;
  comparison.first_verdict = "PASS";
  comparison.second_verdict = "FAIL";
  comparison.settings = {{"pushes.0.force_N.1", "40", "<60>"}};
  comparison.metrics = {{"drift_m", 0.2, 0.3}, {"slip_m", 0.1, 0.1}};
  comparison.has_trajectories = true;
  comparison.divergence = Divergence{200, "0.2", "truth_p_WC_y_m"};
  return comparison;
}

TEST(ComparePageTest, TellsWhatDiffersAndNotWhatDoesNot) {
  const std::string page = ComparePage(Parted(), "a<b", "b", {{"label", "<svg></svg>"}});
  EXPECT_TRUE(Has(page, "A, solid: a&lt;b <span class=\"badge PASS\">"));
  EXPECT_TRUE(Has(page, "part at row 200, 0.2 s, in truth_p_WC_y_m"));
  EXPECT_TRUE(Has(page, "<td>40</td><td>&lt;60&gt;</td>"));
  EXPECT_TRUE(Has(page, "<td>0.2</td><td>0.3</td><td>+0.1</td><td>+50.0 %</td>"));
  EXPECT_FALSE(Has(page, "slip_m"));
  EXPECT_TRUE(Has(page, "prefers-color-scheme: dark"));
  EXPECT_FALSE(Has(page, "<script"));
}

class OverlayTest : public ::testing::Test {
 protected:
  OverlayTest() {
    testing::SyntheticRun later;
    later.name = "toy_push_later";
    later.push_start_s = 0.3;
    later.duration_s = 0.7;
    WriteSyntheticRun(root_ / "a");
    WriteSyntheticRun(root_ / "b", later);
  }
  std::string Script(const std::string& name) const {
    return ReadWholeFile(root_ / "out" / (name + ".gp"));
  }
  const fs::path root_ = FreshTestDir("overlay");
};

TEST_F(OverlayTest, DrawsBothRunsInTheSameAxesAndAPageWithThem) {
  WriteComparison(Parted(), root_ / "a", root_ / "b", root_ / "out");
  for (const OverlayPlot& one : OverlayPlots()) {
    EXPECT_GT(fs::file_size(root_ / "out" / (one.name + ".png")), 5000U) << one.name;
    const std::string svg = ReadWholeFile(root_ / "out" / (one.name + ".svg"));
    EXPECT_TRUE(Has(svg, "toy_push_left")) << one.name;
    EXPECT_TRUE(Has(svg, "toy_push_later")) << one.name;
    EXPECT_TRUE(Has(svg, "stroke-dasharray")) << one.name << ": B is dashed";
  }
  EXPECT_TRUE(Has(Script("com"), "set xrange [0:0.69]")) << "of the longer one";
  EXPECT_TRUE(Has(Script("com"), "from 0.2, graph 0 to 0.3, graph 1")) << "the push of A";
  EXPECT_TRUE(Has(Script("com"), "from 0.3, graph 0 to 0.4, graph 1")) << "the push of B";
  const std::string page = ReadWholeFile(root_ / "out/compare.html");
  std::size_t figures = 0;
  for (std::size_t at = 0; (at = page.find("<figure>", at)) != std::string::npos; ++at) ++figures;
  EXPECT_EQ(figures, OverlayPlots().size());
  EXPECT_FALSE(Has(page, "href=\"http")) << "it needs no network";
}

TEST_F(OverlayTest, AMissingFileIsNamed) {
  fs::remove(root_ / "b/footsteps.csv");
  try {
    PlotOverlay(root_ / "a", root_ / "b", root_ / "out");
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_TRUE(Has(error.what(), "footsteps.csv")) << error.what();
  }
}

}  // namespace
}  // namespace sidestep::compare_page_test
