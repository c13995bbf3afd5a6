// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/inline_svg.h"

#include <array>
#include <utility>

#include "sim/report/html.h"

namespace sidestep::report {
namespace {

void ReplaceAll(const std::string& what, const std::string& with, std::string* text) {
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = 0; (at = text->find(what, from)) != std::string::npos;) {
    result.append(*text, from, at - from).append(with);
    from = at + what.size();
  }
  *text = result.append(*text, from, std::string::npos);
}

// Removes from the first `begin` to the next `end`, both included.
void Remove(const std::string& begin, const std::string& end, std::string* text) {
  const std::size_t first = text->find(begin);
  if (first == std::string::npos) return;
  const std::size_t last = text->find(end, first + begin.size());
  if (last != std::string::npos) text->erase(first, last + end.size() - first);
}

}  // namespace

std::string InlineSvg(const std::string& svg, const std::string& prefix, const std::string& label) {
  const std::size_t first = svg.find("<svg");
  const std::size_t last = svg.rfind("</svg>");
  if (first == std::string::npos || last == std::string::npos) return {};
  std::string element = svg.substr(first, last + 6 - first);
  Remove("xmlns=\"", "\"", &element);
  Remove("xmlns:xlink=\"", "\"", &element);
  Remove("<title>", "</title>", &element);
  Remove("<desc>", "</desc>", &element);
  // A group's own `color` would be what currentColor means in it.
  const std::array<std::pair<std::string, std::string>, 11> replacements{
      {{" id='", " id='" + prefix},
       {" id=\"", " id=\"" + prefix},
       {"href='#", "href='#" + prefix},
       {"href=\"#", "href=\"#" + prefix},
       {"url(#", "url(#" + prefix},
       {" color=\"black\"", ""},
       {" color=\"white\"", ""},
       {"stroke='black'", "stroke='currentColor'"},
       {"stroke=\"black\"", "stroke=\"currentColor\""},
       {"fill='black'", "fill='currentColor'"},
       {"fill=\"black\"", "fill=\"currentColor\""}}};
  for (const auto& [what, with] : replacements) ReplaceAll(what, with, &element);
  element.insert(4, " role=\"img\" aria-label=\"" + Escaped(label) + "\"");
  return element;
}

}  // namespace sidestep::report
