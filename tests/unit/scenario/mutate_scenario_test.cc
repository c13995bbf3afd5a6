// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "models/support/plain_line.h"
#include "sim/scenario/write_scenario.h"
#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::mutate_scenario_test {
namespace {

constexpr int kCases = 2000;

class MutateScenarioTest : public ScenarioFixture {
 protected:
  std::size_t Below(std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random_);
  }

  /// Deletes, doubles, copies or replaces bytes: half of the mutants have one small edit, which
  /// many survive, the others up to four of up to 12 bytes.
  std::string Mutate(std::string text) {
    constexpr std::string_view kSpice = "{}[],:-#&*!|>'\"%@`~?. \n\t\r0129eExX\x04\xFF";
    const bool is_small = Below(2) == 0;
    const std::size_t longest = is_small ? 1 : 12;
    for (std::size_t edits = is_small ? 1 : 1 + Below(4); edits > 0; --edits) {
      const std::size_t at = Below(text.size());
      const std::size_t length = std::min(1 + Below(longest), text.size() - at);
      switch (Below(5)) {
        case 0:
          text.erase(at, length);
          break;
        case 1:
          text.insert(at, text.substr(at, length));
          break;
        case 2:
          text[at] = kSpice[Below(kSpice.size())];
          break;
        case 3:
          text.insert(Below(text.size()), text.substr(at, length));
          break;
        default:
          text[at] = static_cast<char>(1 + Below(255));  // an argument holds no 0
      }
      if (text.empty()) text = "a";
    }
    return text;
  }

  std::mt19937_64 random_{20240601};
};

TEST_F(MutateScenarioTest, EveryMutantIsReadOrRefusedWithItsPlace) {
  int read = 0, refused = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::string text = Mutate(valid_);
    try {
      const Scenario scenario = Read(text);
      const std::string resolved = ResolvedYaml(scenario);
      EXPECT_EQ(ResolvedYaml(Read(resolved)), resolved) << text;
      ++read;
    } catch (const ConfigError& error) {
      EXPECT_TRUE(folder_.Shorten(error.what()).starts_with("a.yaml:")) << error.what();
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "not a ConfigError: " << error.what() << "\n" << text;
    }
  }
  // Both kinds must be plenty, else the mutations test nothing; measured: 96 and 1904.
  EXPECT_GT(read, kCases / 50);
  EXPECT_GT(refused, kCases / 2);
}

TEST_F(MutateScenarioTest, EveryMutantOverrideIsAppliedOrRefusedByName) {
  const std::string valid = "pushes=[{body: trunk, force_N: [0, 1, 2], start_s: 1, duration_s: 1}]";
  int applied = 0, refused = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::string assignment = Mutate(valid);
    try {
      Read(valid_, {assignment});
      ++applied;
    } catch (const ConfigError& error) {
      // A mutant may also spoil the whole, which then shows at a place of the file.
      const std::string message = folder_.Shorten(error.what());
      EXPECT_TRUE(message.starts_with(PlainLine("--set " + assignment + ": error: ")) ||
                  message.starts_with("a.yaml:"))
          << message;
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "not a ConfigError: " << error.what() << "\n" << assignment;
    }
  }
  EXPECT_GT(applied, kCases / 50);
  EXPECT_GT(refused, kCases / 2);
}

}  // namespace
}  // namespace sidestep::mutate_scenario_test
