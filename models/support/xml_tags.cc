// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/xml_tags.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <system_error>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/text_place.h"
#include "models/support/utf8.h"

namespace sidestep {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";  // as isspace() has it

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The character as UTF-8; empty if it is none.
std::string Utf8Of(std::uint32_t code) {
  const auto byte = [](std::uint32_t bits) { return static_cast<char>(bits & 0xFFU); };
  const auto tail = [&](unsigned shift) { return byte(0x80U | ((code >> shift) & 0x3FU)); };
  std::string text;
  if (code < 0x80U) {
    text = {byte(code)};
  } else if (code < 0x800U) {
    text = {byte(0xC0U | (code >> 6U)), tail(0)};
  } else if (code < 0x10000U) {
    text = {byte(0xE0U | (code >> 12U)), tail(6), tail(0)};
  } else if (code < 0x110000U) {
    text = {byte(0xF0U | (code >> 18U)), tail(12), tail(6), tail(0)};
  }
  return code > 0U && Utf8Length(text, 0) == text.size() ? text : "";
}

/// Of `#47` or `#x2F`; empty if it is no character.
std::string ReferredTo(std::string_view reference) {
  reference.remove_prefix(1);
  const bool is_hex = reference.starts_with('x');
  if (is_hex) reference.remove_prefix(1);
  std::uint32_t code = 0;
  const char* const end = reference.data() + reference.size();
  const auto [stop, error] = std::from_chars(reference.data(), end, code, is_hex ? 16 : 10);
  return error == std::errc() && stop == end ? Utf8Of(code) : "";
}

}  // namespace

std::optional<std::string> XmlDecoded(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kNames{
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string decoded;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const auto* const name = std::find_if(kNames.begin(), kNames.end(), [&](const auto& known) {
      return rest.starts_with(known.first);
    });
    if (name != kNames.end()) {
      decoded += name->second;
      at += name->first.size();
    } else if (rest.starts_with("&#")) {
      const std::size_t stop = rest.find(';');
      const std::string character =
          stop == std::string_view::npos ? "" : ReferredTo(rest.substr(1, stop - 1));
      if (character.empty()) return std::nullopt;
      decoded += character;
      at += stop + 1;
    } else if (rest.starts_with("\r\n") || rest.starts_with("\n\r")) {
      decoded += '\n';
      at += 2;
    } else {
      decoded += text[at] == '\r' ? '\n' : text[at];
      ++at;
    }
  }
  return decoded;
}

const std::string_view* XmlTag::Find(std::string_view attribute) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(),
                   [&](const XmlAttribute& known) { return known.name == attribute; });
  return found == attributes.end() ? nullptr : &found->value;
}

bool IsInclude(const XmlTag& tag) {
  constexpr std::string_view kName = "include";
  return std::equal(tag.name.begin(), tag.name.end(), kName.begin(), kName.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

std::optional<XmlTag> XmlTags::Next() {
  while ((at_ = text_.find('<', at_)) < text_.size()) {
    if (Skip("<!--", "-->") || Skip("<![CDATA[", "]]>") || Skip("<!", ">")) continue;
    if (SkipDeclaration()) continue;
    if (Skip("</", ">")) {
      depth_ = std::max(depth_ - 1, 0);
    } else {
      return Open();
    }
  }
  at_ = text_.size();
  return std::nullopt;
}

void XmlTags::Fail(std::size_t at, const std::string& what) const {
  const TextPlace place = PlaceIn(text_, at);
  throw ConfigError(file_, place.line, place.column, what);
}

bool XmlTags::Skip(std::string_view begin, std::string_view end) {
  if (!text_.substr(at_).starts_with(begin)) return false;
  const std::size_t stop = text_.find(end, at_ + begin.size());
  at_ = stop == std::string_view::npos ? text_.size() : stop + end.size();
  return true;
}

// TinyXML ends it at the first '>' outside quotes, or at the first one; TinyXML-2 at "?>".
bool XmlTags::SkipDeclaration() {
  const std::size_t begin = at_;
  if (!Skip("<?", ">")) return false;
  if (text_[at_ - 1] != '>') return true;  // the text ends within it
  if (at_ < begin + 4 || text_[at_ - 2] != '?') Fail(begin, "has a '>' in it, before its '?>'");
  return true;
}

bool XmlTags::IsName(std::size_t at) const {
  if (at >= text_.size() || IsLetter(text_[at]) || text_[at] == '_') return true;
  constexpr std::size_t kLongest = 4;
  return static_cast<unsigned char>(text_[at]) >= 0x80U &&
         Utf8Length(std::string(text_.substr(at, kLongest)), 0) > 0;
}

XmlTag XmlTags::Open() {
  XmlTag tag;
  tag.begin = at_++;
  if (!IsName(at_)) Fail(tag.begin, "'<' must be followed by an element's name, '/', '!' or '?'");
  tag.name = Word();
  tag.depth = ++depth_;
  for (SkipBlanks(); at_ < text_.size() && Here() != '>'; SkipBlanks()) ReadAttribute(&tag);
  tag.is_empty = Here() == '>' && text_[at_ - 1] == '/';
  tag.end = at_ = std::min(at_ + 1, text_.size());
  if (tag.is_empty) --depth_;
  return tag;
}

void XmlTags::ReadAttribute(XmlTag* tag) {
  XmlAttribute attribute{Word(), {}};
  SkipBlanks();
  const bool has_value = Here() == '=';
  if (has_value) {
    ++at_;
    SkipBlanks();
  }
  const char quote = Here();
  if (quote == '"' || quote == '\'') {
    const std::size_t end = std::min(text_.find(quote, at_ + 1), text_.size());
    attribute.value = text_.substr(at_ + 1, end - at_ - 1);
    at_ = std::min(end + 1, text_.size());
  } else if (!has_value && attribute.name.empty()) {
    ++at_;  // a slash, or what is no XML
  }
  if (!has_value) return;
  if (tag->attributes.size() == kMaxXmlAttributes) {
    Fail(tag->begin,
         "has an element with more than " + std::to_string(kMaxXmlAttributes) + " attributes");
  }
  tag->attributes.push_back(attribute);
}

/// What stands here up to a blank, a quote or one of <>/=.
std::string_view XmlTags::Word() {
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n\v\f<>/='\"", at_), text_.size());
  const std::string_view word = text_.substr(at_, end - at_);
  at_ = end;
  return word;
}

void XmlTags::SkipBlanks() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }

}  // namespace sidestep
