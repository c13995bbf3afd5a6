// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/canvas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "models/support/config_error.h"

namespace sidestep::canvas_test {
namespace {

using plot::Canvas;
using plot::ReadCanvas;

TEST(CanvasTest, MillimetresAreThoseOfPaper) {
  const Canvas canvas = ReadCanvas("160x100mm");
  EXPECT_NEAR(canvas.width_px, 160.0 / 25.4 * 96.0, 1e-9);
  EXPECT_NEAR(canvas.height_px, 100.0 / 25.4 * 96.0, 1e-9);
  EXPECT_NEAR(canvas.font_px, 7.0 * 96.0 / 72.0, 1e-9) << "7 points";
  EXPECT_EQ(canvas.suffix, "_160x100mm");
  EXPECT_FALSE(canvas.is_narrow());
}

TEST(CanvasTest, WithoutAHeightAColumnIsUprightAndAPageIsNot) {
  const Canvas column = ReadCanvas("88mm"), page = ReadCanvas("800px");
  EXPECT_TRUE(column.is_narrow());
  EXPECT_DOUBLE_EQ(column.height_px, 1.25 * column.width_px);
  EXPECT_DOUBLE_EQ(page.width_px, 800.0);
  EXPECT_DOUBLE_EQ(page.height_px, 560.0);
  EXPECT_DOUBLE_EQ(page.png_scale, 1.0);
}

TEST(CanvasTest, SmallScreensHaveSmallWords) {
  EXPECT_DOUBLE_EQ(ReadCanvas("1000px").font_px, 14.0);
  EXPECT_DOUBLE_EQ(ReadCanvas("400x300px").font_px, 8.0);
}

TEST(CanvasTest, NoWidthOfAScreenIsAColumnByRounding) {
  for (int width_px = 163; width_px <= 1000; ++width_px) {  // 30 mm high and more
    const Canvas canvas = ReadCanvas(std::to_string(width_px) + "px");
    EXPECT_FALSE(canvas.is_narrow()) << width_px;
    EXPECT_NEAR(canvas.height_px, 0.7 * width_px, 1e-9);
  }
}

TEST(CanvasTest, WhatIsNoSizeIsToldInALine) {
  for (const char* size : {"", "88", "mm", "88 mm", "88cm", "x60mm", "88xmm", "-88mm", "8e1mm",
                           "nanmm", "29mm", "1001mm", "88x5mm", "1e9px", "88mmx60mm", "999999px"}) {
    try {
      ReadCanvas(size);
      ADD_FAILURE() << size;
    } catch (const ConfigError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find("expected a size such as 88mm"), std::string::npos) << what;
      EXPECT_EQ(std::count(what.begin(), what.end(), '\n'), 0);
    }
  }
}

}  // namespace
}  // namespace sidestep::canvas_test
