// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/caption_layout.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace sidestep::render::caption_layout_test {
namespace {

constexpr mjrRect kFrame{0, 0, 320, 240};

// A font whose letters are all 10 pixels wide and 20 high; no OpenGL is asked for.
std::unique_ptr<mjrContext> PlainFont() {
  auto font = std::make_unique<mjrContext>();
  mjr_defaultContext(font.get());
  std::fill(std::begin(font->charWidth), std::end(font->charWidth), 10);
  std::fill(std::begin(font->charWidthBig), std::end(font->charWidthBig), 10);
  font->charHeight = font->charHeightBig = 20;
  return font;
}

Caption LegendLine(std::size_t letters) {
  Caption line;
  line.place = CaptionPlace::kBottomLeft;
  line.text = std::string(letters, 'a');
  line.swatch = Eigen::Vector3f::Ones();
  return line;
}

TEST(CaptionLayoutTest, LinesOfALegendAreAsWideAsItsWidestOne) {
  const auto placed =
      LayOutCaptions({LegendLine(4), LegendLine(12), LegendLine(1)}, kFrame, *PlainFont());
  ASSERT_EQ(placed.size(), 3U);
  for (const PlacedCaption& line : placed) EXPECT_EQ(line.box.width, 12 * 10 + 2 * 20);
  EXPECT_EQ(placed[0].box.bottom, placed[1].box.bottom + placed[1].box.height);
}

TEST(CaptionLayoutTest, NothingIsWiderThanThePicture) {
  std::vector<Caption> captions{LegendLine(60), LegendLine(3)};
  for (const CaptionPlace place :
       {CaptionPlace::kTopLeft, CaptionPlace::kTopRight, CaptionPlace::kBottom}) {
    captions.push_back({place, std::string(60, 'b')});
  }
  const auto placed = LayOutCaptions(captions, kFrame, *PlainFont());
  ASSERT_EQ(placed.size(), captions.size());
  for (const auto& [caption, box] : placed) {
    EXPECT_GT(box.left, 0) << caption.text;
    EXPECT_LT(box.left + box.width, kFrame.width) << caption.text;
  }
  EXPECT_EQ(placed.back().caption.text, "aaa");
}

}  // namespace
}  // namespace sidestep::render::caption_layout_test
