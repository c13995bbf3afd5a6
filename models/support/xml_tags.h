// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// xml_tags: the tags of an XML text, one after the other, without a parser.
//
// What is looked for before a parser may see the text -- depth, sizes, the names of other files --
// is found by this scan alone. It reads what TinyXML, TinyXML-2 (in MuJoCo) and urdfdom read alike,
// and refuses what they take differently, so that none of them sees a tag that it does not.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sidestep {

/// Of one element; parsers search them one by one.
inline constexpr int kMaxXmlAttributes = 1000;

/// An attribute's value as parsers read it: its character references (`&#47;`, `&#x2F;`), the five
/// names (`&amp;`) and line ends replaced; other ampersands stay. Empty for a reference to what is
/// no character, of which parsers make what they like.
std::optional<std::string> XmlDecoded(std::string_view text);

struct XmlAttribute {
  std::string_view name;
  std::string_view value;  ///< Between the quotes, as it stands there.
};

/// A tag that opens an element.
struct XmlTag {
  std::string_view name;
  std::vector<XmlAttribute> attributes;
  int depth{1};          ///< Of the element; 1 is the outermost.
  bool is_empty{false};  ///< `<a/>`, which closes it, too.
  std::size_t begin{0};  ///< Where its '<' is in the text.
  std::size_t end{0};    ///< Past its '>'.

  /// The attribute's value, as it stands; null where there is none.
  const std::string_view* Find(std::string_view attribute) const;
};

/// Whether the tag stands for another file's elements. MuJoCo takes it in letters of either case.
bool IsInclude(const XmlTag& tag);

/// Goes from tag to tag.
class XmlTags {
 public:
  /// Both outlive this. @param file  Its name, for messages.
  XmlTags(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  /// The next tag that opens an element; empty at the end of the text. Comments, CDATA, closing
  /// tags and declarations are passed over. A text that ends within a tag ends with that tag.
  /// Throws ConfigError (`file:line:column: error: ...`) at a '<' that begins nothing known, at a
  /// declaration with a '>' before its end, and at more attributes than kMaxXmlAttributes.
  std::optional<XmlTag> Next();

  const std::string& file() const { return file_; }
  std::string_view text() const { return text_; }

  /// Throws ConfigError at a byte of the text, such as a tag's begin.
  [[noreturn]] void Fail(std::size_t at, const std::string& what) const;

 private:
  /// Passes what begins here with `begin` and ends with `end`, if it does begin so.
  bool Skip(std::string_view begin, std::string_view end);
  bool SkipDeclaration();
  bool IsName(std::size_t at) const;
  XmlTag Open();
  void ReadAttribute(XmlTag* tag);
  std::string_view Word();
  void SkipBlanks();
  char Here() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_{0};
  int depth_{0};
};

}  // namespace sidestep
