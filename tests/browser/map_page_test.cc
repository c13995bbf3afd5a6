// SPDX-License-Identifier: BSD-3-Clause
// A map of survivable pushes and the page that compares two runs, as a reader has them.

#include <gtest/gtest.h>

#include "tests/browser/browser_page.h"
#include "tests/support/run_files.h"
#include "tests/support/sidestep_program.h"
#include "tests/support/temp_folder.h"

namespace sidestep {
namespace {

// Both kinds of ends, a cell that wins and one that loses, for every mark and colour of a map.
constexpr const char* kSweep = R"(sidestep_sweep: 1
name: hop_map
scenario: hopper_push
set:
  duration_s: 4
  pushes: [{body: trunk, impulse_Nspkg: 1, direction_rad: 0, after_s: 1.5, at_phase: 0.25, duration_s: 0.3}]
vary:
  pushes.0.direction_rad: [0, 2]
  pushes.0.at_phase: [0.25, mid_stance]
limit: {key: pushes.0.impulse_Nspkg, ladder: [0.2, 1, 4], resolution: 0.5}
controllers:
  ours: {}
  fixed: {control.mpc.box_lower_m: [0, 0, 0], control.mpc.box_upper_m: [0, 0, 0]}
)";

// The pages to look at, made once.
struct Pages {
  Pages() {
    const ProcessResult sweep = Sidestep(
        {"sweep", folder.Write("hop_map.yaml", kSweep), "-o", folder.path() / "map", "-q", "-j2"});
    EXPECT_EQ(sweep.exit_code, 0) << sweep.err;
    for (const char* force : {"2", "3"}) {
      const ProcessResult run =
          Sidestep({"run", "hopper_push", "-o", folder.path() / force, "-q", "--no-video",
                    "--no-plots", "--set", "duration_s=4", "--set",
                    std::string("pushes=[{body: trunk, force_N: [") + force +
                        ", 0, 0], start_s: 2, duration_s: 0.3}]"});
      EXPECT_LE(run.exit_code, 1) << run.err;
    }
    const ProcessResult both = Sidestep(
        {"compare", folder.path() / "2", folder.path() / "3", "-o", folder.path() / "both"});
    EXPECT_EQ(both.exit_code, 0) << both.err;
  }
  [[nodiscard]] std::filesystem::path map() const { return folder.path() / "map/map.html"; }
  [[nodiscard]] std::filesystem::path compare() const {
    return folder.path() / "both/compare.html";
  }

  TempFolder folder;
};

const Pages& All() {
  static const Pages kPages;
  return kPages;
}

void ExpectLegible(const std::filesystem::path& page) {
  for (const ColorScheme scheme : {ColorScheme::kLight, ColorScheme::kDark}) {
    const nlohmann::json answer = AskPage(page, kAskContrast, scheme, kPhone_px);
    const char* name = scheme == ColorScheme::kDark ? "dark: " : "light: ";
    EXPECT_GT(answer["count"], 50) << name << "all pictures' words are among them";
    EXPECT_GE(answer["page"][0], kLegibleText) << name << answer;
    EXPECT_GE(answer["plot"][0], kLegiblePlot) << name << answer;
  }
}

void ExpectItFits(const std::filesystem::path& page) {
  for (const int width_px : {kDesk_px, kPhone_px}) {
    EXPECT_LE(AskPage(page, kAskOverflow, ColorScheme::kLight, width_px), 0) << width_px;
  }
}

TEST(MapPageTest, EveryWordCanBeReadInLightAndInDark) { ExpectLegible(All().map()); }

TEST(MapPageTest, ItIsNoWiderThanItsWindow) { ExpectItFits(All().map()); }

TEST(MapPageTest, LegendAndDirectionsFitAPhoneWhole) {
  const nlohmann::json cut = AskPage(All().map(), R"(
    return [...document.querySelectorAll('.legend, .polar')].map(f => f.scrollWidth - f.clientWidth);)",
                                     ColorScheme::kDark, kPhone_px);
  ASSERT_EQ(cut.size(), 5) << cut;
  for (const nlohmann::json& pixels : cut) EXPECT_LE(pixels, 0) << cut;
}

TEST(ComparePageTest, EveryWordCanBeReadInLightAndInDark) { ExpectLegible(All().compare()); }

TEST(ComparePageTest, ItIsNoWiderThanItsWindow) { ExpectItFits(All().compare()); }

}  // namespace
}  // namespace sidestep
