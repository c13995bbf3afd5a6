// SPDX-License-Identifier: BSD-3-Clause
// `keys`, `metrics` and `schema` as the shell sees them.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/process/process.h"
#include "tests/support/sidestep_program.h"

namespace sidestep::listing_commands_test {
namespace {

TEST(KeysTest, KeysAreListedWholeOrBelowAPrefixAndAMistypedOneIsTold) {
  const ProcessResult all = Sidestep({"keys"});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_NE(all.out.find("\nworld.friction "), std::string::npos) << all.out;
  const ProcessResult some = Sidestep({"keys", "control.mpc"});
  EXPECT_EQ(some.exit_code, 0) << some.err;
  EXPECT_NE(some.out.find("control.mpc.knots "), std::string::npos) << some.out;
  EXPECT_EQ(some.out.find("world.friction"), std::string::npos) << some.out;
  const ProcessResult mistyped = Sidestep({"keys", "control.mcp"});
  EXPECT_EQ(mistyped.exit_code, 2);
  EXPECT_EQ(mistyped.out, "");
  EXPECT_EQ(mistyped.err, "error: control.mcp is not a known key; did you mean 'mpc'?\n");
}

TEST(MetricsTest, MetricsAreListedAsTextOrMarkdownAndTakeNoArgument) {
  const ProcessResult text = Sidestep({"metrics"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out.find("METRIC "), 0U) << text.out;
  EXPECT_NE(text.out.find("\nfall_time_s "), std::string::npos) << text.out;
  const ProcessResult markdown = Sidestep({"metrics", "--markdown"});
  EXPECT_EQ(markdown.exit_code, 0) << markdown.err;
  EXPECT_NE(markdown.out.find("| `fall_time_s` | s |"), std::string::npos) << markdown.out;
  const ProcessResult surplus = Sidestep({"metrics", "fall"});
  EXPECT_EQ(surplus.exit_code, 2);
  EXPECT_EQ(surplus.out, "");
  EXPECT_EQ(surplus.err.find('\n'), surplus.err.size() - 1) << surplus.err;
}

TEST(SchemaTest, TheSchemaIsJsonThatRefusesKeysItDoesNotKnow) {
  const ProcessResult result = Sidestep({"schema"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json schema = nlohmann::json::parse(result.out);
  EXPECT_EQ(schema["type"], "object");
  EXPECT_EQ(schema["additionalProperties"], false);
  const nlohmann::json& friction = schema["properties"]["world"]["properties"]["friction"];
  EXPECT_EQ(friction["minimum"], 0.0);
  EXPECT_EQ(friction["maximum"], 10.0);
  EXPECT_FALSE(schema["properties"].contains("wrold"));
  EXPECT_EQ(Sidestep({"schema", "surplus"}).exit_code, 2);
}

}  // namespace
}  // namespace sidestep::listing_commands_test
