// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/json_text.h"

#include <gtest/gtest.h>

#include <functional>

namespace sidestep::json_text_test {
namespace {

using Json = nlohmann::json;

std::string ErrorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::string ErrorIn(const std::string& text) {
  return ErrorOf([&] { ParseJson<Json>(text, "f.json"); });
}

TEST(JsonTextTest, TakesWhatIsWholeAndWithinBounds) {
  EXPECT_EQ(ParseJson<Json>("{\"a\": [1, 2.5]}", "f.json")["a"][1], 2.5);
  const std::string deep = std::string(32, '[') + std::string(32, ']');
  EXPECT_EQ(ErrorIn(deep), "no error");
}

TEST(JsonTextTest, TellsWhereItBreaksOff) {
  EXPECT_EQ(ErrorIn("{\n  \"a\": ]"), "f.json:2:8: error: the JSON breaks off here");
  EXPECT_EQ(ErrorIn("[1e999]"), "f.json: error: holds a number beyond the range of a double");
}

TEST(JsonTextTest, NeitherDeepNorLargeTextsAreTaken) {
  for (const std::size_t depth : {33U, 200000U}) {
    EXPECT_EQ(ErrorIn(std::string(depth, '[') + std::string(depth, ']')),
              "f.json: error: is nested deeper than 32");
    EXPECT_EQ(ErrorIn("{\"zz\":" + std::string(depth, '[')),
              "f.json: error: is nested deeper than 32");
  }
  EXPECT_EQ(ErrorIn("[" + std::string(kMostJsonBytes, ' ') + "]"),
            "f.json: error: is larger than 16 MiB");
}

TEST(JsonTextTest, AnObjectOfVeryManyKeysIsNotTaken) {
  const auto keys = [](int count) {
    std::string text = "{\"a\": [{\"b\": 1}, {";
    for (int i = 0; i < count; ++i) text += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":1";
    return text + "}, {\"c\": 1}]}";
  };
  EXPECT_EQ(ErrorIn(keys(kMostJsonKeys)), "no error") << "each object counts alone";
  EXPECT_EQ(ErrorIn(keys(kMostJsonKeys + 1)),
            "f.json: error: has an object of more than 10000 keys");
}

TEST(JsonTextTest, AFileThatNeverEndsIsTooLarge) {
  EXPECT_EQ(ErrorOf([] { ReadJsonFile<Json>("/dev/zero"); }),
            "/dev/zero: error: is larger than 16 MiB");
  EXPECT_EQ(ErrorOf([] { ReadJsonFile<Json>("/no/such.json"); }),
            "/no/such.json: error: can't be read");
  EXPECT_EQ(ErrorOf([] { ReadJsonFile<Json>("/tmp"); }), "/tmp: error: can't be read");
}

}  // namespace
}  // namespace sidestep::json_text_test
