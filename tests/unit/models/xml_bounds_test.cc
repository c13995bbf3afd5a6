// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/xml_bounds.h"

#include <gtest/gtest.h>

#include "models/support/config_error.h"
#include "models/support/xml_tags.h"

namespace sidestep::xml_bounds_test {
namespace {

std::string ErrorOf(const std::string& text) {
  try {
    CheckXmlBounds("a.xml", text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::string Repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

constexpr char kTooDeep[] = "a.xml:1:301: error: has elements nested deeper than 100";

TEST(XmlBoundsTest, NestingIsBoundedAndSiblingsAreNot) {
  EXPECT_EQ(ErrorOf(Repeated("<a>", 100) + Repeated("</a>", 100)), "no error");
  EXPECT_EQ(ErrorOf(Repeated("<a>", 101)), kTooDeep);
  EXPECT_EQ(ErrorOf(Repeated("<a>", 100'000)), kTooDeep);
  EXPECT_EQ(ErrorOf("<r>" + Repeated("<a></a><b/><c d='>'/>", 1000) + "</r>"), "no error");
  EXPECT_EQ(ErrorOf("<r>\n  " + Repeated("<a>", 100)),
            "a.xml:2:300: error: has elements nested deeper than 100");
}

TEST(XmlBoundsTest, WhatLooksLikeAnElementWithinCommentsAndValuesIsNone) {
  const std::string many = Repeated("<a>", 200);
  EXPECT_EQ(ErrorOf("<r><!-- " + many + " --><![CDATA[" + many + "]]></r>"), "no error");
  EXPECT_EQ(ErrorOf("<r b=\"" + many + "\" c='" + many + "'/>"), "no error");
}

// TinyXML ends a declaration at the first '>', and a tag of no letter is no element.
TEST(XmlBoundsTest, NothingHidesNestingFromIt) {
  EXPECT_NE(ErrorOf("<?x>" + Repeated("<a>", 101) + "?>"), "no error");
  EXPECT_NE(ErrorOf("<!-->-->" + Repeated("<a>", 101)), "no error");
  EXPECT_NE(ErrorOf("<!x>" + Repeated("<a b='/'>", 101)), "no error");
  EXPECT_NE(ErrorOf(Repeated("</a>", 500) + Repeated("<a>", 101)), "no error");
}

TEST(XmlBoundsTest, SizeElementsAndAttributesAreBounded) {
  EXPECT_EQ(ErrorOf(std::string(kMaxXmlBytes + 1, ' ')), "a.xml: error: is longer than 64 MiB");
  EXPECT_EQ(ErrorOf(Repeated("<a/>", kMaxXmlElements + 1)),
            "a.xml:1:2000001: error: has more than 500000 elements");
  EXPECT_EQ(ErrorOf("<a " + Repeated("b='1' ", kMaxXmlAttributes + 1) + "/>"),
            "a.xml:1:1: error: has an element with more than 1000 attributes");
}

TEST(XmlBoundsTest, TextsThatEndAnywhereAreScanned) {
  for (const char* text :
       {"", "<", "<a", "<a b", "<a b='", "<!--", "<![CDATA[", "<?", "</", "<!"}) {
    EXPECT_EQ(ErrorOf(text), "no error") << text;
  }
}

TEST(XmlBoundsTest, StrayBytesBecomeQuestionMarks) {
  EXPECT_EQ(WithoutStrayBytes("a\tb\r\nc"), "a\tb\r\nc");
  EXPECT_EQ(WithoutStrayBytes("gr\xC3\xBC\xC3\x9F"), "gr\xC3\xBC\xC3\x9F");
  EXPECT_EQ(WithoutStrayBytes("gr\xFC\xDF"), "gr??");
  EXPECT_EQ(WithoutStrayBytes(std::string("a\0b\x01\x7F", 5)), "a?b??");
}

}  // namespace
}  // namespace sidestep::xml_bounds_test
