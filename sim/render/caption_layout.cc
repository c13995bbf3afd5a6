// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/caption_layout.h"

#include <algorithm>
#include <utility>

namespace sidestep::render {
namespace {

struct TextSize {
  int width_px{0};
  int height_px{0};
};

TextSize SizeOf(const Caption& caption, const mjrContext& renderer) {
  const int* widths = caption.is_big ? renderer.charWidthBig : renderer.charWidth;
  TextSize size;
  for (const char c : caption.text) size.width_px += widths[static_cast<unsigned char>(c)];
  const int line_px = caption.is_big ? renderer.charHeightBig : renderer.charHeight;
  size.width_px += line_px;  // half a line of air on either side
  if (caption.swatch) size.width_px += line_px;
  size.height_px = line_px + line_px / 2;
  return size;
}

int Left(CaptionPlace place, const mjrRect& viewport, int margin_px, int width_px) {
  switch (place) {
    case CaptionPlace::kTopLeft:
    case CaptionPlace::kBottomLeft:
      return viewport.left + margin_px;
    case CaptionPlace::kTopRight:
      return viewport.left + viewport.width - margin_px - width_px;
    case CaptionPlace::kBottom:
      break;
  }
  return viewport.left + (viewport.width - width_px) / 2;
}

// The caption with its end cut off until it fits; keeps at least one character.
Caption Fitted(Caption caption, int width_px, const mjrContext& renderer) {
  while (SizeOf(caption, renderer).width_px > width_px && caption.text.size() > 3) {
    caption.text.replace(caption.text.size() - 3, 3, "..");
  }
  return caption;
}

// A line of a legend: a square of its colour, then its words.
void DrawSwatch(const Caption& caption, const mjrRect& box, const Eigen::Vector3f& ground,
                const mjrContext& renderer) {
  mjr_rectangle(box, ground.x(), ground.y(), ground.z(), 0.7F);
  const int side_px = renderer.charHeight * 3 / 4, air_px = (box.height - side_px) / 2;
  const Eigen::Vector3f& color = *caption.swatch;
  mjr_rectangle({box.left + air_px, box.bottom + air_px, side_px, side_px}, color.x(), color.y(),
                color.z(), 1.0F);
  const int words_px = box.left + side_px + 2 * air_px;
  int text_px = renderer.charHeight / 2;
  for (const char c : caption.text) text_px += renderer.charWidth[static_cast<unsigned char>(c)];
  mjr_label({words_px, box.bottom, text_px, box.height}, mjFONT_NORMAL, caption.text.c_str(),
            ground.x(), ground.y(), ground.z(), 0.0F, 1.0F, 1.0F, 1.0F, &renderer);
}

void LayOutStack(const std::vector<Caption>& captions, CaptionPlace place, mjrRect viewport,
                 const mjrContext& renderer, std::vector<PlacedCaption>* placed) {
  const int margin_px = std::max(4, viewport.height / 48);
  std::vector<PlacedCaption> stack;
  int height_px = 0, legend_px = 0;  // lines of a legend are of one width
  for (const Caption& whole : captions) {
    if (whole.place != place) continue;
    const Caption caption = Fitted(whole, viewport.width - 2 * margin_px, renderer);
    const TextSize size = SizeOf(caption, renderer);
    height_px += size.height_px;
    if (caption.swatch) legend_px = std::max(legend_px, size.width_px);
    stack.push_back({caption, {0, 0, size.width_px, size.height_px}});
  }
  const bool is_below = place == CaptionPlace::kBottom || place == CaptionPlace::kBottomLeft;
  int top = is_below ? viewport.bottom + margin_px + height_px
                     : viewport.bottom + viewport.height - margin_px;
  for (PlacedCaption& one : stack) {
    if (one.caption.swatch) one.box.width = legend_px;
    top -= one.box.height;
    one.box.bottom = top;
    one.box.left = Left(place, viewport, margin_px, one.box.width);
    placed->push_back(std::move(one));
  }
}

}  // namespace

std::vector<PlacedCaption> LayOutCaptions(const std::vector<Caption>& captions, mjrRect viewport,
                                          const mjrContext& renderer) {
  std::vector<PlacedCaption> placed;
  for (const CaptionPlace place : {CaptionPlace::kTopLeft, CaptionPlace::kTopRight,
                                   CaptionPlace::kBottom, CaptionPlace::kBottomLeft}) {
    LayOutStack(captions, place, viewport, renderer, &placed);
  }
  return placed;
}

void DrawCaptions(const std::vector<Caption>& captions, mjrRect viewport,
                  const mjrContext& renderer) {
  for (const auto& [caption, box] : LayOutCaptions(captions, viewport, renderer)) {
    const Eigen::Vector3f& color = caption.background;
    if (caption.swatch) {
      DrawSwatch(caption, box, color, renderer);
      continue;
    }
    mjr_label(box, caption.is_big ? mjFONT_BIG : mjFONT_NORMAL, caption.text.c_str(), color.x(),
              color.y(), color.z(), 0.85F, 1.0F, 1.0F, 1.0F, &renderer);
  }
}

}  // namespace sidestep::render
