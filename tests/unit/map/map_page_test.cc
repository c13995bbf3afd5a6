// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/map_page.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/map/pictures.h"
#include "tests/unit/map/made_map.h"

namespace sidestep::map {
namespace {

TEST(MapPageTest, HasFiguresPicturesAndASheetACell) {
  SweepMap map = MadeMap();
  map.cells[1].commands = {{"lost", "sidestep run 'a<b'"}};
  const std::string page = MapPage(map, {"runs/ray_1"});
  EXPECT_TRUE(Has(page, "<th scope=\"row\">ours</th><td>12</td><td>6</td><td>6</td><td>0</td>"));
  EXPECT_TRUE(Has(page, "id=\"cell-7\""));
  EXPECT_TRUE(Has(page, "href=\"#cell-7\""));
  EXPECT_TRUE(Has(page, "<pre>sidestep run &#39;a&lt;b&#39;</pre>"));
  EXPECT_TRUE(Has(page, "<a href=\"runs/ray_1\">kept</a>"));
  EXPECT_TRUE(Has(page, "ours less fixed"));
  EXPECT_TRUE(Has(page, "prefers-color-scheme: dark"));
  EXPECT_FALSE(Has(page, "<script"));
  EXPECT_FALSE(Has(page, "http")) << "it needs no network";
}

TEST(MapPageTest, TheFirstControllerIsComparedWithEveryOther) {
  const std::string page =
      MapPage(ParseMap(kHeader + MadeRay(0, "ours", "0", 3) + MadeRay(1, "ours", "1", 3) +
                           MadeRay(2, "fixed", "0", 1) + MadeRay(3, "fixed", "1", 1) +
                           MadeRay(4, "paper", "0", 3) + MadeRay(5, "paper", "1", 2),
                       "m", "f"),
              {});
  EXPECT_TRUE(Has(page, "ours less fixed"));
  EXPECT_TRUE(Has(page, "ours less paper"));
}

TEST(MapPageTest, ADifferenceOfRoundingIsNone) {
  const std::string rows =
      MadeRow(0, "a", "0", "0.30000000000000004", "RECOVERED") + MadeRow(0, "a", "0", "1", "LOST") +
      MadeRow(1, "b", "0", "0.3", "RECOVERED") + MadeRow(1, "b", "0", "1", "LOST");
  const std::string svg =
      SvgFile(DifferencePicture(ParseMap(kHeader + rows, "m", "f"), 1), "difference");
  EXPECT_TRUE(Has(svg, "(0)")) << svg;
}

TEST(MapPageTest, HostileNamesStayText) {
  SweepMap map = ParseMap(std::string(kHeader) + MadeRay(0, "<b>&", "0", 1, "\"><script>") +
                              MadeRay(1, "<b>&", "1", 2, "\"><script>"),
                          "</title><script>", "f");
  map.physics_note = "none: <i>";
  const std::string page = MapPage(map, {"runs/<x>"});
  EXPECT_FALSE(Has(page, "<script"));
  EXPECT_FALSE(Has(page, "<b>"));
  EXPECT_FALSE(Has(page, "<i>"));
  EXPECT_TRUE(Has(page, "&lt;b&gt;&amp;"));
}

TEST(MapPageTest, AnyTableMakesAPage) {
  const std::string head = kHeader;
  for (const std::string& rows :
       {std::string(), MadeRow(0, "a", "0", "1", "INVALID"), MadeRow(0, "a", "0", "nan", "LOST"),
        MadeRow(0, "a", "left", "1", "RECOVERED") + MadeRow(1, "a", "right", "1", "LOST"),
        MadeRow(0, "a", "0", "0", "RECOVERED"), MadeRay(0, "a", "0", 3),
        MadeRay(0, "a", "0", 3) + MadeRay(1, "b", "1", 0)}) {
    const SweepMap map = ParseMap(head + rows, "m", "f");
    EXPECT_TRUE(Has(MapPage(map, {}), "</html>")) << rows;
    EXPECT_FALSE(Has(SvgFile(SheetPicture(map), "l"), "nan")) << rows;
  }
}

TEST(MapPageTest, WithoutDirectionsItIsAStrip) {
  const std::string header =
      "ray,id,controller,world.friction,strength,stage,seed,outcome,reasons,impulse_Nspkg\n";
  std::string rows;
  for (int i = 0; i < 70; ++i) {
    const std::string n = std::to_string(i);
    rows += n + ",i,a,0." + n + ",1,ladder,,RECOVERED,,1\n";
  }
  const std::string page = MapPage(ParseMap(header + rows, "m", "f"), {});
  EXPECT_TRUE(Has(page, "Tested strengths"));
  EXPECT_TRUE(Has(page, "more in rays.csv"));
  EXPECT_FALSE(Has(page, "By direction"));
}

}  // namespace
}  // namespace sidestep::map
