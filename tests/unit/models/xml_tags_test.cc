// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/xml_tags.h"

#include <gtest/gtest.h>

#include <string>

#include "models/support/config_error.h"

namespace sidestep::xml_tags_test {
namespace {

/// Names, depths and attributes of all tags: "a1 b='x'; c2;".
std::string TagsOf(const std::string& text) {
  const std::string file = "a.xml";
  XmlTags tags(file, text);
  std::string told;
  try {
    while (const auto tag = tags.Next()) {
      told += std::string(tag->name) + std::to_string(tag->depth);
      for (const XmlAttribute& attribute : tag->attributes) {
        told += " " + std::string(attribute.name) + "='" + std::string(attribute.value) + "'";
      }
      told += tag->is_empty ? "/;" : ";";
    }
  } catch (const ConfigError& error) {
    return told + " " + error.what();
  }
  return told;
}

TEST(XmlTagsTest, TellsOfTagsAttributesAndDepth) {
  EXPECT_EQ(TagsOf("<?xml version='1.0'?><a b=\"x\" c = '>/'>text<d/><e f='\"'></e></a><g/>"),
            "a1 b='x' c='>/';d2/;e2 f='\"';g1/;");
  EXPECT_EQ(TagsOf("<a\n\fb='1'c='2'\v/>"), "a1 b='1' c='2'/;");
}

TEST(XmlTagsTest, PassesOverWhatIsNoElement) {
  EXPECT_EQ(TagsOf("<!-- <a> --><![CDATA[<b>]]><!DOCTYPE c><d/>"), "d1/;");
  EXPECT_EQ(TagsOf("<!--><a>-->"), "");
}

TEST(XmlTagsTest, EndsWhereTheTextDoes) {
  EXPECT_EQ(TagsOf("<a b='c"), "a1 b='c';");
  EXPECT_EQ(TagsOf("<a b="), "a1 b='';");
  EXPECT_EQ(TagsOf("<a b"), "a1;");
  EXPECT_EQ(TagsOf("<"), "1;");
}

// TinyXML takes these for declarations that end at the first '>', TinyXML-2 does not.
TEST(XmlTagsTest, RefusesWhatParsersTakeDifferently) {
  const std::string name = "'<' must be followed by an element's name, '/', '!' or '?'";
  EXPECT_EQ(TagsOf("<a>\n < b>"), "a1; a.xml:2:2: error: " + name);
  EXPECT_EQ(TagsOf("<1>"), " a.xml:1:1: error: " + name);
  EXPECT_EQ(TagsOf("<\xFF>"), " a.xml:1:1: error: " + name);
  EXPECT_EQ(TagsOf("<\xC3\xBC/>"),
            "\xC3\xBC"
            "1/;");
  EXPECT_EQ(TagsOf("<?a > <!-- ?><b/>"), " a.xml:1:1: error: has a '>' in it, before its '?>'");
  EXPECT_EQ(TagsOf("<?>?>"), " a.xml:1:1: error: has a '>' in it, before its '?>'");
}

TEST(XmlTagsTest, ValuesAreDecodedAsParsersDo) {
  EXPECT_EQ(XmlDecoded("&#47;&#x2f;&#x2F;"), "///");
  EXPECT_EQ(XmlDecoded("&lt;&amp;#47;&gt;&quot;&apos;"), "<&#47;>\"'");
  EXPECT_EQ(XmlDecoded("&#252;&#x20AC;&#x1F600;"), "\xC3\xBC\xE2\x82\xAC\xF0\x9F\x98\x80");
  EXPECT_EQ(XmlDecoded("a & b &c; &"), "a & b &c; &");
  EXPECT_EQ(XmlDecoded("a\r\nb\rc\n\rd\ne"), "a\nb\nc\nd\ne");
  for (const char* bad : {"&#0;", "&#;", "&#x;", "&#X2F;", "&#47", "&#4 7;", "&#xD800;",
                          "&#x110000;", "&#x10000000000000002F;", "&#-47;"}) {
    EXPECT_EQ(XmlDecoded(bad), std::nullopt) << bad;
  }
}

TEST(XmlTagsTest, IncludesHaveLettersOfEitherCase) {
  const std::string file = "a.xml";
  for (const char* text : {"<include file='b'/>", "<InCLUDE file='b'/>"}) {
    const auto tag = XmlTags(file, text).Next();
    ASSERT_TRUE(tag.has_value());
    EXPECT_TRUE(IsInclude(*tag));
    ASSERT_NE(tag->Find("file"), nullptr);
    EXPECT_EQ(*tag->Find("file"), "b");
    EXPECT_EQ(tag->Find("File"), nullptr);
  }
  EXPECT_FALSE(IsInclude(*XmlTags(file, "<includes/>").Next()));
}

}  // namespace
}  // namespace sidestep::xml_tags_test
