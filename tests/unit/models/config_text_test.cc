// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_text.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/temp_folder.h"

namespace sidestep::config_text_test {
namespace {

std::string FaultOf(const std::string& text) {
  const auto fault = FindTextFault(text);
  if (!fault) return "none";
  return std::to_string(fault->line) + ":" + std::to_string(fault->column) + " " + fault->what;
}

TEST(ConfigTextTest, AcceptsUtf8OfEveryLength) {
  EXPECT_EQ(FaultOf("a\tb\r\n\xC3\xA9 \xE2\x82\xAC \xF0\x9F\xA4\x96\n"), "none");
}

TEST(ConfigTextTest, FindsControlCharactersWithTheirPlace) {
  EXPECT_EQ(FaultOf("ab\ncd\x04"), "2:3 control character 0x04");
  EXPECT_EQ(FaultOf(std::string("a\0b", 3)), "1:2 control character 0x00");
  EXPECT_EQ(FaultOf("\x7F"), "1:1 control character 0x7F");
}

TEST(ConfigTextTest, FindsWhatIsNoUtf8) {
  EXPECT_EQ(FaultOf("a\xFF"), "1:2 byte 0xFF is no UTF-8");
  EXPECT_EQ(FaultOf("\x80"), "1:1 byte 0x80 is no UTF-8") << "continuation without lead";
  EXPECT_EQ(FaultOf("\xC3"), "1:1 byte 0xC3 is no UTF-8") << "cut short by the end";
  EXPECT_EQ(FaultOf("\xC0\xAF"), "1:1 byte 0xC0 is no UTF-8") << "overlong '/'";
  EXPECT_EQ(FaultOf("\xE0\x80\xAF"), "1:1 byte 0xE0 is no UTF-8") << "overlong '/'";
  EXPECT_EQ(FaultOf("\xED\xA0\x80"), "1:1 byte 0xED is no UTF-8") << "surrogate";
  EXPECT_EQ(FaultOf("\xF4\x90\x80\x80"), "1:1 byte 0xF4 is no UTF-8") << "above U+10FFFF";
}

TEST(ConfigTextTest, ReadsAFileByteForByte) {
  const TempFolder folder;
  const std::string text("a\r\nb\0c", 6);
  EXPECT_EQ(ReadConfigText(folder.Write("a.yaml", text)), text);
}

TEST(ConfigTextTest, NamesAMissingFile) {
  const TempFolder folder;
  EXPECT_EQ(folder.ErrorOf([&] { ReadConfigText(folder.path() / "none.yaml"); }),
            "none.yaml: error: can't be read: No such file or directory");
}

TEST(ConfigTextTest, RefusesAFolder) {
  const TempFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  EXPECT_EQ(folder.ErrorOf([&] { ReadConfigText(folder.path() / "sub"); }),
            "sub: error: can't be read: is a folder");
}

TEST(ConfigTextTest, RefusesMoreThanOneMebibyte) {
  const TempFolder folder;
  const std::string limit(1 << 20, '#');
  EXPECT_EQ(ReadConfigText(folder.Write("a.yaml", limit)).size(), limit.size());
  folder.Write("b.yaml", limit + "#");
  EXPECT_EQ(folder.ErrorOf([&] { ReadConfigText(folder.path() / "b.yaml"); }),
            "b.yaml: error: can't be read: is longer than 1 MiB");
}

}  // namespace
}  // namespace sidestep::config_text_test
