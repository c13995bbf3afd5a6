// SPDX-License-Identifier: BSD-3-Clause
// The report of a run, light and dark, on a desk and on a phone.

#include <gtest/gtest.h>

#include "tests/browser/browser_page.h"
#include "tests/support/sidestep_program.h"
#include "tests/unit/check/check_test_support.h"

namespace sidestep {
namespace {

// The report of a run that fails, as a missed expectation has colours of its own; made once.
const std::string& Page() {
  static const ScratchFolder folder;
  static const std::string kPage = [] {
    const std::string out = folder.path() / "run";
    const ProcessResult run = Sidestep(
        {"run", "hopper_push", "-o", out, "-q", "--no-video", "--set", "duration_s=4", "--set",
         "pushes=[{body: trunk, force_N: [0, 5, 0], start_s: 2, duration_s: 0.5}]", "--set",
         "expect={fall: false, max_tilt_rad: {max: 0.001}}"});
    EXPECT_EQ(run.exit_code, 1) << run.err;
    return out + "/report.html";
  }();
  return kPage;
}

TEST(ReportPageTest, EveryWordCanBeReadInLightAndInDark) {
  for (const ColorScheme scheme : {ColorScheme::kLight, ColorScheme::kDark}) {
    const nlohmann::json answer = AskPage(Page(), kAskContrast, scheme, kDesk_px);
    const char* name = scheme == ColorScheme::kDark ? "dark: " : "light: ";
    EXPECT_GT(answer["count"], 300) << name << "all plots' words are among them";
    EXPECT_GE(answer["page"][0], kLegibleText) << name << answer;
    EXPECT_GE(answer["plot"][0], kLegiblePlot) << name << answer;
  }
}

TEST(ReportPageTest, ItIsNoWiderThanItsWindow) {
  for (const int width_px : {kDesk_px, kPhone_px}) {
    EXPECT_LE(AskPage(Page(), kAskOverflow, ColorScheme::kLight, width_px), 0) << width_px;
  }
}

TEST(ReportPageTest, TheSchemesDiffer) {
  const char* ground = "return getComputedStyle(document.body).backgroundColor;";
  EXPECT_NE(AskPage(Page(), ground, ColorScheme::kLight, kDesk_px),
            AskPage(Page(), ground, ColorScheme::kDark, kDesk_px))
      << "else the test above looks at one page twice";
}

}  // namespace
}  // namespace sidestep
