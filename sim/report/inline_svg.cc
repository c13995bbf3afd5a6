// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/inline_svg.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/palette/palette.h"
#include "sim/report/html.h"

namespace sidestep::report {
namespace {

// What gnuplot's svg terminal draws with. Neither scripts, animations, links nor foreign content.
constexpr std::array<std::string_view, 20> kElements{
    "svg",    "g",    "defs",    "symbol",  "use",      "path",       "rect",
    "circle", "line", "polygon", "ellipse", "polyline", "text",       "tspan",
    "title",  "desc", "filter",  "feFlood", "clipPath", "feComposite"};

void ReplaceAll(const std::string& what, const std::string& with, std::string* text) {
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = 0; (at = text->find(what, from)) != std::string::npos;) {
    result.append(*text, from, at - from).append(with);
    from = at + what.size();
  }
  *text = result.append(*text, from, std::string::npos);
}

// Removes each stretch from a `begin` to the next `end`, both included.
void Remove(const std::string& begin, const std::string& end, std::string* text) {
  std::string result;
  std::size_t from = 0;
  while (true) {
    const std::size_t first = text->find(begin, from);
    const std::size_t last =
        first == std::string::npos ? first : text->find(end, first + begin.size());
    if (last == std::string::npos) break;
    result.append(*text, from, first - from);
    from = last + end.size();
  }
  *text = result.append(*text, from, std::string::npos);
}

bool IsSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// A reference may only point into the drawing itself, and nothing may run.
bool IsHarmlessAttribute(std::string name, std::string value) {
  for (std::string* word : {&name, &value}) {
    std::transform(word->begin(), word->end(), word->begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  }
  if (name.starts_with("xmlns")) return true;
  if (name.starts_with("on")) return false;
  if (name == "href" || name == "xlink:href") return value.starts_with("#");
  if (value.find('&') != std::string::npos) return false;  // what it spells is not what it says
  if (value.find("url(") != std::string::npos) return value.find("url(#") == value.rfind("url(");
  return value.find("script:") == std::string::npos && value.find("@import") == std::string::npos;
}

// The words of one tag, from after its `<` to before its `>`.
bool IsHarmlessTag(std::string_view tag) {
  if (tag.starts_with('/')) tag.remove_prefix(1);
  std::size_t at = 0;
  while (at < tag.size() && !IsSpace(tag[at]) && tag[at] != '/') ++at;
  if (std::find(kElements.begin(), kElements.end(), tag.substr(0, at)) == kElements.end()) {
    return false;
  }
  while (true) {
    while (at < tag.size() && (IsSpace(tag[at]) || tag[at] == '/')) ++at;
    if (at >= tag.size()) return true;
    const std::size_t equals = tag.find('=', at);
    if (equals == std::string_view::npos) return false;
    std::string_view name = tag.substr(at, equals - at);
    while (!name.empty() && IsSpace(name.back())) name.remove_suffix(1);
    std::size_t quote = equals + 1;
    while (quote < tag.size() && IsSpace(tag[quote])) ++quote;
    if (quote >= tag.size() || (tag[quote] != '"' && tag[quote] != '\'')) return false;
    const std::size_t end = tag.find(tag[quote], quote + 1);
    if (end == std::string_view::npos) return false;
    const std::string_view value = tag.substr(quote + 1, end - quote - 1);
    if (!IsHarmlessAttribute(std::string(name), std::string(value))) return false;
    at = end + 1;
  }
}

// Where the tag that begins at `open` ends: a `>` outside quotes.
std::optional<std::size_t> EndOfTag(std::string_view text, std::size_t open) {
  char quote = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '>') {
      return i;
    }
  }
  return std::nullopt;
}

bool IsHarmless(std::string_view svg) {
  for (std::size_t open = svg.find('<'); open != std::string_view::npos;) {
    const std::optional<std::size_t> close = EndOfTag(svg, open);
    if (!close || !IsHarmlessTag(svg.substr(open + 1, *close - open - 1))) return false;
    open = svg.find('<', *close);
  }
  return true;
}

// The page's ink, light or dark, for what gnuplot draws in black or in its background's white.
void UseThePagesInk(std::string* svg) {
  for (const std::string quote : {"'", "\""}) {
    for (const std::string color : {"black", "rgb(  0,   0,   0)", palette::kPlanned}) {
      for (const std::string name : {"stroke", "fill"}) {
        ReplaceAll(name + "=" + quote + color + quote, name + "=" + quote + "currentColor" + quote,
                   svg);
      }
      ReplaceAll(" color=" + quote + color + quote, "", svg);
    }
    for (const std::string color : {"white", "gray"}) {
      ReplaceAll(" color=" + quote + color + quote, "", svg);
    }
  }
}

}  // namespace

std::string InlineSvg(const std::string& svg, const std::string& prefix, const std::string& label) {
  const std::size_t first = svg.find("<svg");
  const std::size_t last = svg.rfind("</svg>");
  if (first == std::string::npos || last == std::string::npos) return {};
  std::string element = svg.substr(first, last + 6 - first);
  if (!IsHarmless(element)) return {};
  Remove("xmlns=\"", "\"", &element);
  Remove("xmlns:xlink=\"", "\"", &element);
  Remove("<title>", "</title>", &element);
  Remove("<desc>", "</desc>", &element);
  const std::array<std::pair<std::string, std::string>, 5> replacements{
      {{" id='", " id='" + prefix},
       {" id=\"", " id=\"" + prefix},
       {"href='#", "href='#" + prefix},
       {"href=\"#", "href=\"#" + prefix},
       {"url(#", "url(#" + prefix}}};
  for (const auto& [what, with] : replacements) ReplaceAll(what, with, &element);
  UseThePagesInk(&element);
  element.insert(4, " role=\"img\" aria-label=\"" + Escaped(label) + "\"");
  return element;
}

}  // namespace sidestep::report
