// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/write_report.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "models/support/config_error.h"
#include "sim/plot/plot_run.h"
#include "sim/report/html.h"
#include "sim/report/inline_svg.h"
#include "sim/verdict/metrics.h"
#include "tests/support/synthetic_run.h"

namespace sidestep::write_report_test {
namespace {

using ::sidestep::testing::FreshTestDir;
using ::sidestep::testing::WriteSyntheticRun;

std::string TextOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string ErrorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

/// Values of an attribute, in either kind of quotes: what follows `name=`.
std::vector<std::string> Attributes(const std::string& page, const std::string& name) {
  std::vector<std::string> values;
  const std::string key = name + "=";
  for (std::size_t at = 0; (at = page.find(key, at)) != std::string::npos;) {
    at += key.size();
    if (page[at] != '"' && page[at] != '\'') continue;
    const std::size_t end = page.find(page[at], at + 1);
    values.push_back(page.substr(at + 1, end - at - 1));
  }
  return values;
}

/// The page of one run with plots and (made up) video.
const std::string& PageOfOne() {
  static const std::string kPage = [] {
    const auto dir = FreshTestDir("report_one");
    WriteSyntheticRun(dir, {.name = "toy <left> & \"right\"", .verdict = VerdictClass::kFail});
    PlotRun(dir);
    std::ofstream(dir / "video.mp4") << "a film";
    WriteReport({dir}, dir / "report.html");
    return TextOf(dir / "report.html");
  }();
  return kPage;
}

TEST(WriteReportTest, EachExpectationIsShownWithWhatWasAskedAndMeasured) {
  EXPECT_TRUE(Has(PageOfOne(),
                  "<code>fall</code></th><td>no</td><td>yes</td><td><span class="
                  "\"missed\">missed</span>"));
  EXPECT_TRUE(Has(PageOfOne(),
                  "<code>mean_step_adjustment_m</code></th><td>0.01 to 0.1</td>"
                  "<td>0.0539</td><td><span class=\"met\">met</span>"));
}

TEST(WriteReportTest, VerdictReasonPushAndSolveTimesAreShown) {
  EXPECT_TRUE(Has(PageOfOne(), "<span class=\"badge FAIL\">FAIL</span>"));
  EXPECT_TRUE(Has(PageOfOne(), "<b>FALL</b> base tilted beyond 1 rad at 0.4 s"));
  // 40 N for 0.1 s on 20 kg: 4 N s, 0.2 m/s.
  EXPECT_TRUE(Has(PageOfOne(), "trunk</th><td><span class=\"missed\">FALL</span></td><td>40</td>"));
  EXPECT_TRUE(Has(PageOfOne(), "rotate(-90)")) << "an arrow to the left";
  EXPECT_TRUE(Has(PageOfOne(), "<td>0.2</td><td>0.1</td><td>0.35</td><td>4</td><td>0.2</td>"));
  EXPECT_TRUE(Has(PageOfOne(), "p99 (ms)</th><td>3.4</td><td>6.8</td>"));
}

TEST(WriteReportTest, VerdictFilmPictureAndPushesComeBeforeTheRest) {
  std::size_t at = 0;
  for (const char* part : {"badge FAIL", "<video", "aria-label=\"top view\"", ">Pushes<",
                           ">Expectations<", "All plots", "MPC solve time", ">Metrics<",
                           ">Settings<", "as it was resolved", "Run it again"}) {
    const std::size_t found = PageOfOne().find(part, at);
    ASSERT_NE(found, std::string::npos) << part;
    at = found;
  }
}

TEST(WriteReportTest, MetricsTellWhatTheyMean) {
  EXPECT_TRUE(Has(PageOfOne(), "<code>max_tilt_rad</code></th><td>0.08</td><td>" +
                                   report::Escaped(FindMetric("max_tilt_rad")->meaning)));
}

TEST(WriteReportTest, TheCommandCanBePastedIntoAShell) {
  EXPECT_TRUE(
      Has(PageOfOne(), "sidestep run &#39;my toy.yaml&#39; --set &#39;pushes.0={a: b}&#39;"));
}

TEST(WriteReportTest, ThePageNeedsNoNetworkNoScriptAndNoOtherFile) {
  EXPECT_FALSE(Has(PageOfOne(), "http"));
  EXPECT_FALSE(Has(PageOfOne(), "<script"));
  EXPECT_FALSE(Has(PageOfOne(), "<link"));
  EXPECT_FALSE(Has(PageOfOne(), "@import"));
  std::size_t references = 0;
  for (const char* name : {"src", "href"}) {
    for (const std::string& target : Attributes(PageOfOne(), name)) {
      EXPECT_TRUE(target.starts_with("#") || target.starts_with("data:")) << target.substr(0, 80);
      ++references;
    }
  }
  EXPECT_GT(references, 10U);
  EXPECT_FALSE(Has(PageOfOne(), "url(h"));
}

TEST(WriteReportTest, VideoAndPlotsAreInThePage) {
  EXPECT_TRUE(Has(PageOfOne(), "src=\"data:video/mp4;base64,YSBmaWxt\""));
  std::size_t count = 0;
  for (std::size_t at = 0; (at = PageOfOne().find("<figure><svg", at)) != std::string::npos; ++at) {
    ++count;
  }
  EXPECT_EQ(count, PlotNames().size());
}

TEST(WriteReportTest, NoIdIsUsedTwice) {
  std::set<std::string> seen;
  for (const std::string& id : Attributes(PageOfOne(), " id")) {
    EXPECT_TRUE(seen.insert(id).second) << id;
  }
  EXPECT_GT(seen.size(), 50U);
}

TEST(WriteReportTest, ANameIsTextNotMarkup) {
  EXPECT_TRUE(Has(PageOfOne(), "toy &lt;left&gt; &amp; &quot;right&quot;"));
  EXPECT_FALSE(Has(PageOfOne(), "<left>"));
}

TEST(WriteReportTest, TheScenarioAndItsKeySettingsAreShown) {
  EXPECT_TRUE(Has(PageOfOne(), "<code>duration_s</code></th><td>0.5</td>"));
  EXPECT_TRUE(Has(PageOfOne(), "<pre>sidestep: 1\n"));
  EXPECT_TRUE(Has(PageOfOne(), "<p>A toy is pushed to the left.</p>"));
}

TEST(WriteReportTest, OverridesAndHashesAreShown) {
  EXPECT_TRUE(Has(PageOfOne(), "override</th><td>--set pushes.0={a: b}</td>"));
  EXPECT_TRUE(Has(PageOfOne(), "hash of the scenario</th><td>0123456789abcdef</td>"));
  EXPECT_TRUE(Has(PageOfOne(), "hash of the model</th><td>fedcba9876543210</td>"));
}

TEST(WriteReportTest, SeveralRunsAreComparedFirstThenShownEach) {
  const auto dir = FreshTestDir("report_two");
  WriteSyntheticRun(dir / "a", {.name = "weak", .push_force_N = 40.0});
  WriteSyntheticRun(dir / "b",
                    {.name = "strong", .verdict = VerdictClass::kFail, .push_force_N = 200.0});
  WriteReport({dir / "a", dir / "b"}, dir / "report.html");
  const std::string page = TextOf(dir / "report.html");
  EXPECT_TRUE(Has(page, "2 runs, 1 passed"));
  EXPECT_TRUE(Has(page,
                  "<a href=\"#run1\">strong</a></th><td><span class=\"badge FAIL\">"
                  "FAIL</span></td><td>1</td>"));
  EXPECT_LT(page.find("2 runs, 1 passed"), page.find("<article id=\"run0\">"));
  EXPECT_LT(page.find("<article id=\"run0\">"), page.find("<article id=\"run1\">"));
}

TEST(WriteReportTest, ARunWithoutVideoAndPlotsIsShownWithoutThem) {
  const auto dir = FreshTestDir("report_bare");
  WriteSyntheticRun(dir);
  WriteReport({dir}, dir / "report.html");
  const std::string page = TextOf(dir / "report.html");
  EXPECT_FALSE(Has(page, "<video"));
  EXPECT_FALSE(Has(page, "<figure"));
  EXPECT_TRUE(Has(page, "Expectations"));
}

TEST(WriteReportTest, AMissingFileIsNamedAndAnOldReportStays) {
  for (const char* file : {"summary.json", "scenario.yaml"}) {
    const auto dir = FreshTestDir("report_missing");
    WriteSyntheticRun(dir);
    std::ofstream(dir / "report.html") << "old";
    std::filesystem::remove(dir / file);
    EXPECT_TRUE(Has(ErrorOf([&] { WriteReport({dir}, dir / "report.html"); }),
                    (dir / file).string() + ": error: can't be read"));
    EXPECT_EQ(TextOf(dir / "report.html"), "old");
  }
}

TEST(WriteReportTest, AReportOfNothingOrToNowhereIsAnError) {
  const auto dir = FreshTestDir("report_nowhere");
  WriteSyntheticRun(dir);
  EXPECT_TRUE(Has(ErrorOf([&] { WriteReport({}, dir / "r.html"); }), "at least one run folder"));
  EXPECT_TRUE(Has(ErrorOf([&] { WriteReport({dir}, dir / "no" / "r.html"); }),
                  "r.html: error: can't be written"));
}

TEST(HtmlTest, Base64PadsToFours) {
  EXPECT_EQ(report::Base64(""), "");
  EXPECT_EQ(report::Base64("f"), "Zg==");
  EXPECT_EQ(report::Base64("fo"), "Zm8=");
  EXPECT_EQ(report::Base64("foo"), "Zm9v");
  EXPECT_EQ(report::Base64("\xff\xfe"), "//4=");
}

// As gnuplot writes them: a group's colour is what currentColor means within.
TEST(InlineSvgTest, BlackInkIsThePagesInkInGroupsOfAnyColourToo) {
  const std::string html = report::InlineSvg(
      "<svg><g color=\"white\" stroke=\"currentColor\"><text fill=\"black\">a</text></g>"
      "<g color=\"black\"/><g color=\"#0072B2\"/></svg>",
      "p-", "l");
  EXPECT_EQ(html,
            "<svg role=\"img\" aria-label=\"l\"><g stroke=\"currentColor\"><text "
            "fill=\"currentColor\">a</text></g><g/><g color=\"#0072B2\"/></svg>");
}

TEST(InlineSvgTest, IdsArePrefixedWhereTheyAreMadeAndWhereTheyAreUsed) {
  const std::string html = report::InlineSvg(
      "<?xml?><svg xmlns=\"http://x\"><g id='a' fill='black'/><use href='#a'/></svg>\n", "p-",
      "a plot");
  EXPECT_EQ(html,
            "<svg role=\"img\" aria-label=\"a plot\" ><g id='p-a' fill='currentColor'/>"
            "<use href='#p-a'/></svg>");
  EXPECT_EQ(report::InlineSvg("not a picture", "p-", "a plot"), "");
}

TEST(InlineSvgTest, WhatGnuplotDrawsInItsGroundsColourTakesThePagesInk) {
  EXPECT_EQ(report::InlineSvg(
                "<svg><g fill=\"none\" color=\"white\" stroke=\"currentColor\"/></svg>", "p-", "l"),
            "<svg role=\"img\" aria-label=\"l\"><g fill=\"none\" stroke=\"currentColor\"/></svg>");
}

TEST(InlineSvgTest, WhatCouldRunOrReachOutIsNotTaken) {
  const std::string good = "<svg><g id='a' style='x'><text>1 &lt; 2</text></g></svg>";
  EXPECT_NE(report::InlineSvg(good, "p-", "l"), "");
  for (const char* inside : {"<script>alert(1)</script>",
                             "<g onload='alert(1)'/>",
                             "<g ONLOAD = 'alert(1)'/>",
                             "<a href='http://x'><text>t</text></a>",
                             "<image href='http://x/i.png'/>",
                             "<use href='http://x/#a'/>",
                             "<use xlink:href=\"data:x\"/>",
                             "<foreignObject/>",
                             "<style>@import 'http://x'</style>",
                             "<rect fill='url(http://x)'/>",
                             "<rect fill='url(#a) url(//x)'/>",
                             "<rect style='background:u&#x72;l(//x)'/>",
                             "<animate attributeName='href' to='javascript:alert(1)'/>",
                             "<set to='x'/>",
                             "<!-- --!><script>--><g/>",
                             "<![CDATA[<script>]]>",
                             "<?xml-stylesheet href='x'?>",
                             "<g a=b onload=alert(1)>",
                             "<g a='1' onload>",
                             "<g a='"}) {
    EXPECT_EQ(report::InlineSvg("<svg>" + std::string(inside) + "</svg>", "p-", "l"), "") << inside;
  }
}

}  // namespace
}  // namespace sidestep::write_report_test
