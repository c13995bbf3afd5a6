// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// browser_page: opens a page in headless Chromium and asks it what a reader would see.

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "sim/process/process.h"
#include "tests/support/run_files.h"

namespace sidestep {

enum class ColorScheme { kDark = 0, kLight = 1 };

constexpr int kDesk_px = 1280;
constexpr int kPhone_px = 500;  // the narrowest window that Chromium opens

// WCAG 2: AA for text, and for large text and graphics.
constexpr double kLegibleText = 4.5;
constexpr double kLegiblePlot = 3.0;

/// Opens a copy of `page` with `script` run at its end, which leaves its answer in
/// `document.body.dataset.answer` as JSON; returns the answer.
inline nlohmann::json AskPage(const std::filesystem::path& page, const std::string& script,
                              ColorScheme scheme, int width_px) {
  const std::filesystem::path copy = page.parent_path() / "asked.html";
  std::string text = TextOf(page);
  const std::size_t end = text.rfind("</body>");
  text.insert(end, "<script>document.body.dataset.answer = JSON.stringify((() => {" + script +
                       "})());</script>\n");
  std::ofstream(copy, std::ios::binary) << text;
  const ProcessResult result = RunOrThrow(
      {"chromium", "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=10000",
       "--blink-settings=preferredColorScheme=" + std::to_string(static_cast<int>(scheme)),
       "--window-size=" + std::to_string(width_px) + ",1600", "--dump-dom",
       "file://" + copy.string()});
  const std::string key = "data-answer=\"";
  const std::size_t begin = result.out.find(key) + key.size();
  std::string answer = result.out.substr(begin, result.out.find('"', begin) - begin);
  for (std::size_t at = 0; (at = answer.find("&quot;", at)) != std::string::npos;) {
    answer.replace(at, 6, "\"");
  }
  return nlohmann::json::parse(answer);
}

/// Script: the WCAG 2 contrast of every text of the page, opened wholly, with the tile of its
/// picture that it is written on, or else with the page; {count, page, plot}, where page and plot
/// are the worst of each with its words.
inline constexpr const char* kAskContrast = R"(
  document.querySelectorAll('details').forEach(d => d.open = true);
  const channel = c => c <= 10 ? c / 3294 : Math.pow((c / 255 + 0.055) / 1.055, 2.4);
  const numbers = color => (color.match(/[\d.]+/g) || []).map(Number);
  const luminance = color => { const [r, g, b] = numbers(color);
    return 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b); };
  const ground = e => { for (; e; e = e.parentElement) {
      const color = getComputedStyle(e).backgroundColor;
      if (!(numbers(color).length === 4 && numbers(color)[3] === 0)) return color; }
    return getComputedStyle(document.documentElement).colorScheme; };
  const tile = (e, svg) => { const a = e.getBoundingClientRect();
    const x = (a.left + a.right) / 2, y = (a.top + a.bottom) / 2;
    return [...svg.querySelectorAll('rect, polygon')].filter(r => { const b = r.getBoundingClientRect();
      return (r.compareDocumentPosition(e) & Node.DOCUMENT_POSITION_FOLLOWING) &&
        getComputedStyle(r).fill !== 'none' && getComputedStyle(r).fillOpacity > 0.5 &&
        b.left <= x && x <= b.right && b.top <= y && y <= b.bottom; }).pop(); };
  const worst = {count: 0, page: [99, ''], plot: [99, '']};
  for (const e of document.querySelectorAll('body *')) {
    const own = [...e.childNodes].filter(n => n.nodeType === 3).map(n => n.data.trim()).join('');
    if (!own || ['SCRIPT', 'STYLE', 'title'].includes(e.tagName)) continue;
    const svg = e.closest('svg');
    const style = getComputedStyle(e);
    const under = svg && tile(e, svg);
    const a = luminance(svg ? style.fill : style.color);
    const b = luminance(under ? getComputedStyle(under).fill : ground(svg || e));
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const kind = svg ? 'plot' : 'page';
    worst.count += 1;
    if (contrast < worst[kind][0]) worst[kind] = [contrast, own.slice(0, 60).replace(/["&]/g, ' ')];
  }
  return worst;)";

/// Script: how far the page is wider than its window (px).
inline constexpr const char* kAskOverflow =
    "return document.documentElement.scrollWidth - window.innerWidth;";

}  // namespace sidestep
