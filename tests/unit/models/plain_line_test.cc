// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/plain_line.h"

#include <gtest/gtest.h>

#include <string>

#include "models/support/config_error.h"
#include "models/support/config_tree.h"
#include "models/support/utf8.h"

namespace sidestep {
namespace {

TEST(PlainLineTest, NothingInItReachesTheTerminalButCharacters) {
  EXPECT_EQ(PlainLine("a\nb\r\tc"), "a b  c");
  EXPECT_EQ(PlainLine(std::string("x\x1b[31m\0\x7f", 8)), "x?[31m??");
  EXPECT_EQ(PlainLine("\xff\xc3 \xc3\xa9"), "?? \xc3\xa9");
}

TEST(PlainLineTest, ALongOneKeepsBothEnds) {
  const std::string line = PlainLine("begin" + std::string(5000, 'x') + "end");
  EXPECT_LE(line.size(), kLongestLine);
  EXPECT_TRUE(line.starts_with("begin"));
  EXPECT_TRUE(line.ends_with("end"));
}

TEST(PlainLineTest, ACutHalvesNoCharacter) {
  for (int shift = 0; shift < 4; ++shift) {
    std::string text(static_cast<std::size_t>(shift), 'x');
    for (int i = 0; i < 2000; ++i) text += "\xe2\x82\xac";  // euro signs
    const std::string line = PlainLine(text);
    for (std::size_t at = 0; at < line.size(); at += Utf8Length(line, at)) {
      ASSERT_NE(Utf8Length(line, at), 0U) << shift << " " << at;
    }
  }
}

TEST(ConfigErrorTest, QuotesOfAFileAreOneCleanLine) {
  EXPECT_STREQ(ConfigError("f: error: '\x1b[2J\n'").what(), "f: error: '?[2J '");
  EXPECT_STREQ(ConfigError("f", 1, 2, "\xff").what(), "f:1:2: error: ?");
  EXPECT_STREQ(ConfigError(std::vector<std::string>{"a\nb", "c\x07"}).what(), "a b\nc?");
}

TEST(ConfigErrorTest, AnOptionsOwnBytesAreCleanToo) {
  const ConfigSource option{"--set a=\x1b[2J", false};
  const ConfigPlace place{std::make_shared<const ConfigSource>(option), 1, 1};
  EXPECT_EQ(MessageAt(place, "note", "b"), "--set a=?[2J: note: b");
}

}  // namespace
}  // namespace sidestep
