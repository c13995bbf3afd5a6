// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_node.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "models/support/config_error.h"

namespace sidestep::config_node_test {
namespace {

/// The error that `read` gives on the value of `key: <value>`, "no error" if it gives none.
template <typename Read>
std::string ErrorOn(const std::string& value, Read&& read) {
  try {
    const ConfigTree root = ParseConfig("top: {key: " + value + "}\n", {"a.yaml", true});
    ConfigMap map = ConfigNode(*root.Find("top"), "top").Map();
    read(map.Required("key"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::string NumberError(const std::string& value) {
  return ErrorOn(value, [](const ConfigNode& node) { node.Number(0.3, 1.2); });
}

std::string IntegerError(const std::string& value) {
  return ErrorOn(value, [](const ConfigNode& node) { node.Integer(2, 200); });
}

double NumberIn(const std::string& value) {
  const ConfigTree root = ParseConfig("key: " + value + "\n", {"a.yaml", true});
  return ConfigNode(*root.Find("key"), "key").Number(-1e300, 1e300);
}

TEST(ConfigNodeTest, ReadsEverySpellingOfANumber) {
  EXPECT_EQ(NumberIn("1"), 1.0);
  EXPECT_EQ(NumberIn("-0.25"), -0.25);
  EXPECT_EQ(NumberIn("+.5"), 0.5);
  EXPECT_EQ(NumberIn("5."), 5.0);
  EXPECT_EQ(NumberIn("1e-3"), 1e-3);
  EXPECT_EQ(NumberIn("2.5E+2"), 250.0);
}

TEST(ConfigNodeTest, AcceptsBothBounds) {
  EXPECT_EQ(NumberError("0.3"), "no error");
  EXPECT_EQ(NumberError("1.2"), "no error");
  EXPECT_EQ(IntegerError("2"), "no error");
  EXPECT_EQ(IntegerError("+200"), "no error");
}

TEST(ConfigNodeTest, RefusesANumberOutOfRange) {
  EXPECT_EQ(NumberError("62"), "a.yaml:1:12: error: top.key = 62 violates 0.3 <= key <= 1.2");
  EXPECT_EQ(NumberError("0.29999"),
            "a.yaml:1:12: error: top.key = 0.29999 violates 0.3 <= key <= 1.2");
}

TEST(ConfigNodeTest, RefusesWhatIsNoNumber) {
  EXPECT_EQ(NumberError("0.4s"), "a.yaml:1:12: error: top.key = '0.4s' is not a number");
  EXPECT_EQ(NumberError("1_0"), "a.yaml:1:12: error: top.key = '1_0' is not a number");
  EXPECT_EQ(NumberError("+-1"), "a.yaml:1:12: error: top.key = '+-1' is not a number");
  EXPECT_EQ(NumberError("true"), "a.yaml:1:12: error: top.key = 'true' is not a number");
  EXPECT_EQ(NumberError("'1'"), "a.yaml:1:12: error: top.key = '1' is quoted text, not a number");
  EXPECT_EQ(NumberError(""), "a.yaml:1:7: error: top.key must be a number, not empty");
  EXPECT_EQ(NumberError("[1]"), "a.yaml:1:12: error: top.key must be a number, not a list");
  EXPECT_EQ(NumberError("{a: 1}"), "a.yaml:1:12: error: top.key must be a number, not a map");
}

TEST(ConfigNodeTest, RefusesNumbersThatAreNotFinite) {
  for (const char* value : {".nan", ".inf", "-.inf", "nan", "inf", "-inf", "1e999"}) {
    EXPECT_EQ(NumberError(value),
              "a.yaml:1:12: error: top.key = '" + std::string(value) + "' is not a finite number");
  }
}

TEST(ConfigNodeTest, RefusesWhatIsNoInteger) {
  EXPECT_EQ(IntegerError("15.0"), "a.yaml:1:12: error: top.key = '15.0' is not an integer");
  EXPECT_EQ(IntegerError("1e2"), "a.yaml:1:12: error: top.key = '1e2' is not an integer");
  EXPECT_EQ(IntegerError("'15'"),
            "a.yaml:1:12: error: top.key = '15' is quoted text, not an integer");
  EXPECT_EQ(IntegerError("~"), "a.yaml:1:7: error: top.key must be an integer, not empty");
}

TEST(ConfigNodeTest, RefusesAnIntegerOutOfRange) {
  EXPECT_EQ(IntegerError("1"), "a.yaml:1:12: error: top.key = 1 violates 2 <= key <= 200");
  EXPECT_EQ(IntegerError("99999999999999999999"),
            "a.yaml:1:12: error: top.key = 99999999999999999999 violates 2 <= key <= 200");
}

TEST(ConfigNodeTest, KeepsTheLargestInteger) {
  const std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  const ConfigTree root = ParseConfig("key: 9223372036854775807\n", {"a.yaml", true});
  EXPECT_EQ(ConfigNode(*root.Find("key"), "key").Integer(0, largest), largest);
}

TEST(ConfigNodeTest, RefusesEveryOtherSpellingOfABool) {
  const auto read = [](const ConfigNode& node) { node.Bool(); };
  EXPECT_EQ(ErrorOn("true", read), "no error");
  EXPECT_EQ(ErrorOn("yes", read), "a.yaml:1:12: error: top.key must be true or false, not 'yes'");
  EXPECT_EQ(ErrorOn("'true'", read),
            "a.yaml:1:12: error: top.key must be true or false, not 'true'");
  EXPECT_EQ(ErrorOn("", read), "a.yaml:1:7: error: top.key must be true or false, not empty");
}

TEST(ConfigNodeTest, RefusesWhatIsNoText) {
  const auto read = [](const ConfigNode& node) { node.Text(); };
  EXPECT_EQ(ErrorOn("[a]", read), "a.yaml:1:12: error: top.key must be text, not a list");
  EXPECT_EQ(ErrorOn("", read), "a.yaml:1:7: error: top.key must be text, not empty");
  EXPECT_EQ(ErrorOn("''", read), "no error");
}

TEST(ConfigNodeTest, RefusesAnUnknownChoice) {
  const auto read = [](const ConfigNode& node) {
    const std::vector<std::string> names{"walk", "run"};
    node.Choice(names);
  };
  EXPECT_EQ(ErrorOn("run", read), "no error");
  EXPECT_EQ(ErrorOn("wlak", read),
            "a.yaml:1:12: error: top.key = 'wlak' is not known; did you mean 'walk'?");
  EXPECT_EQ(ErrorOn("crawling", read),
            "a.yaml:1:12: error: top.key = 'crawling' is not known; known values: walk, run");
}

TEST(ConfigNodeTest, RefusesAVectorThatHasNotThreeNumbers) {
  const auto read = [](const ConfigNode& node) { node.Vector3(-1, 1); };
  EXPECT_EQ(ErrorOn("[0, 1, -1]", read), "no error");
  EXPECT_EQ(ErrorOn("[0, 1]", read),
            "a.yaml:1:12: error: top.key must be a list of 3 numbers, not of 2");
  EXPECT_EQ(ErrorOn("1", read), "a.yaml:1:12: error: top.key must be a list of 3 numbers, not '1'");
  EXPECT_EQ(ErrorOn("[0, 1, 5]", read),
            "a.yaml:1:19: error: top.key.2 = 5 violates -1 <= key.2 <= 1");
  EXPECT_EQ(ErrorOn("[0, [], 0]", read),
            "a.yaml:1:16: error: top.key.1 must be a number, not a list");
}

TEST(ConfigNodeTest, RefusesWhatIsNoListOrMap) {
  EXPECT_EQ(ErrorOn("1", [](const ConfigNode& node) { node.List(); }),
            "a.yaml:1:12: error: top.key must be a list, not '1'");
  EXPECT_EQ(ErrorOn("[]", [](const ConfigNode& node) { node.Map(); }),
            "a.yaml:1:12: error: top.key must be a map of keys, not a list");
  EXPECT_EQ(ErrorOn("", [](const ConfigNode& node) { node.Map(); }),
            "a.yaml:1:7: error: top.key must be a map of keys, not empty");
}

TEST(ConfigNodeTest, RefusesATopLevelThatIsNoMap) {
  const ConfigTree root = ParseConfig("- a\n", {"a.yaml", true});
  try {
    const ConfigMap map(root, "");
    FAIL() << "a list was taken for a map";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "a.yaml:1:1: error: the file must be a map of keys, not a list");
  }
}

class ConfigMapTest : public testing::Test {
 protected:
  template <typename Read>
  std::string ErrorOf(Read&& read) {
    try {
      ConfigMap map = ConfigNode(*root_.Find("gait"), "gait").Map();
      read(map);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }

  const ConfigTree root_ = ParseConfig("gait:\n  swing_s: 1\n  steps: 2\n", {"a.yaml", true});
};

TEST_F(ConfigMapTest, RefusesAMissingKeyWhereTheMapBegins) {
  EXPECT_EQ(ErrorOf([](ConfigMap& map) { map.Required("height_m"); }),
            "a.yaml:2:3: error: gait.height_m is missing (required)");
}

TEST_F(ConfigMapTest, NamesAMisspelledRequiredKeyAtItsPlace) {
  EXPECT_EQ(ErrorOf([](ConfigMap& map) {
              map.Required("swing_s");
              map.Required("step_s");
            }),
            "a.yaml:3:3: error: gait.steps is not a known key; did you mean 'step_s'?");
}

TEST_F(ConfigMapTest, RefusesUnknownKeysAtTheirPlace) {
  EXPECT_EQ(ErrorOf([](ConfigMap& map) {
              map.Optional("swing_s");
              map.Optional("stride_m");
              map.RejectUnknownKeys();
            }),
            "a.yaml:3:3: error: gait.steps is not a known key; known keys: swing_s, stride_m");
}

TEST_F(ConfigMapTest, AcceptsAMapWhoseKeysWereAllAskedFor) {
  EXPECT_EQ(ErrorOf([](ConfigMap& map) {
              map.Optional("swing_s");
              map.Optional("steps");
              map.RejectUnknownKeys();
            }),
            "no error");
}

TEST(FailAtPathTest, FallsBackToTheInnermostPartThatTheFileHas) {
  const ConfigTree root = ParseConfig("a:\n  - b: 1\n", {"x.yaml", true});
  const auto error_at = [&](const std::string& path) -> std::string {
    try {
      FailAtPath(root, path, "is wrong");
    } catch (const ConfigError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(error_at("a.0.b"), "x.yaml:2:8: error: a.0.b is wrong");
  EXPECT_EQ(error_at("a.0.c.d"), "x.yaml:2:5: error: a.0.c.d is wrong");
  EXPECT_EQ(error_at("a.7"), "x.yaml:2:3: error: a.7 is wrong");
  EXPECT_EQ(error_at("z"), "x.yaml:1:1: error: z is wrong");
}

TEST(NumberTextTest, ReadsBackAsTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, 123456789.123456789, -0.0, 1e22}) {
    EXPECT_EQ(NumberIn(NumberText(value)), value) << NumberText(value);
  }
  EXPECT_EQ(NumberText(0.3), "0.3");
}

}  // namespace
}  // namespace sidestep::config_node_test
