// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/scenario_schema.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "models/support/config_node.h"
#include "sim/scenario/apply_override.h"
#include "sim/scenario/key_table.h"
#include "tests/unit/scenario/json_schema.h"
#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::scenario_schema_test {
namespace {

namespace fs = std::filesystem;

class ScenarioSchemaTest : public ScenarioFixture {
 protected:
  /// What the schema says of the valid scenario under one override; "" if nothing.
  std::string FaultOfSet(const std::string& assignment) const {
    ConfigTree root = ReadConfigFile(folder_.Write("a.yaml", full_));
    ApplyOverride(assignment, &root);
    return schema_.Fault(JsonOf(root));
  }

  /// Schema and reader refuse alike, and the reader because of the value that was set.
  void ExpectRefused(const std::string& assignment) const {
    EXPECT_NE(FaultOfSet(assignment), "") << assignment;
    const std::string error = ErrorIn(full_, {assignment});
    EXPECT_TRUE(error.starts_with("--set " + assignment + ": error: "))
        << assignment << ": " << error;
  }

  /// The schema accepts, and the reader finds no fault with the value itself; whether it suits the
  /// other keys is another matter.
  void ExpectInRange(const std::string& assignment) const {
    EXPECT_EQ(FaultOfSet(assignment), "") << assignment;
    const std::string error = ErrorIn(full_, {assignment});
    for (const char* complaint : {"violates", "is not a", "must be a", "greater than"}) {
      EXPECT_EQ(error.find(complaint), std::string::npos) << error;
    }
  }

  /// The valid scenario with an element in every list.
  const std::string full_ = Edit(
      valid_, "friction: 0.9", "friction: 0.9, ground: [{from_x_m: 1, to_x_m: 2, height_m: 0.1}]");
  const JsonSchema schema_{ScenarioSchema()};
};

bool IsListOfMaps(const KeyInfo& key) {
  return key.kind == KeyKind::kList || key.kind == KeyKind::kPushes;
}

/// Calls act(path, key) for every key, with a path that `--set` takes in the valid scenario, whose
/// first push has a force_N and whose second a magnitude.
void ForEachKey(const std::string& path, const KeyInfo& key,
                const std::function<void(const std::string&, const KeyInfo&)>& act) {
  act(path, key);
  for (const KeyInfo& child : key.children) {
    std::string parent = path.empty() ? "" : path + ".";
    const bool is_polar = child.name == "magnitude_N" || child.name == "magnitude_mg" ||
                          child.name == "impulse_Nspkg" || child.name == "direction_rad";
    if (IsListOfMaps(key)) parent += is_polar ? "1." : "0.";
    ForEachKey(parent + child.name, child, act);
  }
}

/// `value` as the key spells a number: alone, or as every entry of its list.
std::string Spelled(const KeyInfo& key, double value) {
  std::string text = NumberText(value);
  if (key.kind == KeyKind::kVector) return "[" + text + ", " + text + ", " + text + "]";
  if (key.kind == KeyKind::kPixelSize) return "[" + text + ", " + text + "]";
  return text;
}

TEST_F(ScenarioSchemaTest, AcceptsEveryScenarioThatShips) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SIDESTEP_SOURCE_DIR) / "scenarios")) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_EQ(schema_.Fault(JsonOf(ReadConfigFile(entry.path()))), "") << entry.path();
    ++count;
  }
  EXPECT_GE(count, 10);
  EXPECT_EQ(schema_.Fault(JsonOf(ReadConfigFile(folder_.Write("a.yaml", valid_)))), "");
}

TEST_F(ScenarioSchemaTest, EveryBoundIsTheReadersBound) {
  int bounds = 0;
  ForEachKey("", ScenarioKeys(), [&](const std::string& path, const KeyInfo& key) {
    const bool is_integer = key.kind == KeyKind::kInteger || key.kind == KeyKind::kPixelSize;
    if (key.min) {
      // Below any bound by more than the rounding of its decimal digits.
      const double below =
          is_integer ? *key.min - 1.0 : *key.min - 1e-3 * (1.0 + std::abs(*key.min));
      ExpectRefused(path + "=" + Spelled(key, below));
      if (key.excludes_min) ExpectRefused(path + "=" + Spelled(key, *key.min));
      if (!key.excludes_min) ExpectInRange(path + "=" + Spelled(key, *key.min));
      ++bounds;
    }
    if (key.max) {
      const double above =
          is_integer ? *key.max + 1.0 : *key.max + 1e-3 * (1.0 + std::abs(*key.max));
      ExpectRefused(path + "=" + Spelled(key, above));
      // A version that can't be read is refused by its number, not by its range.
      if (path != "sidestep") ExpectInRange(path + "=" + Spelled(key, *key.max));
      ++bounds;
    }
  });
  EXPECT_GT(bounds, 150) << "nearly every key has two";
}

TEST_F(ScenarioSchemaTest, AWrongTypeIsRefusedForEveryKey) {
  int keys = 0;
  ForEachKey("", ScenarioKeys(), [&](const std::string& path, const KeyInfo& key) {
    if (path.empty()) return;
    ++keys;
    switch (key.kind) {
      case KeyKind::kText:
        ExpectRefused(path + "=[word]");
        break;
      case KeyKind::kInteger:
        ExpectRefused(path + "=1.5");
        ExpectRefused(path + "=word");
        break;
      case KeyKind::kVector:
        ExpectRefused(path + "=[0, 0]");
        ExpectRefused(path + "=0");
        break;
      case KeyKind::kChoice:
        ExpectRefused(path + "=wrong_word");
        break;
      default:
        ExpectRefused(path + "=word");
    }
  });
  EXPECT_GT(keys, 100);
}

TEST_F(ScenarioSchemaTest, EveryChoiceAndDefaultIsAccepted) {
  ForEachKey("", ScenarioKeys(), [&](const std::string& path, const KeyInfo& key) {
    for (const std::string& choice : key.choices) {
      EXPECT_EQ(FaultOfSet(path + "=" + choice), "");
      EXPECT_EQ(ErrorIn(full_, {path + "=" + choice}).find("is not known"), std::string::npos)
          << path;
    }
    if (!key.default_value.empty()) ExpectInRange(path + "=" + key.default_value);
  });
}

TEST_F(ScenarioSchemaTest, AnUnknownKeyIsRefusedInEveryMap) {
  int maps = 0;
  ForEachKey("", ScenarioKeys(), [&](const std::string& path, const KeyInfo& key) {
    if (!key.has_children() && key.kind != KeyKind::kMetricsMap) return;
    const std::string map = path.empty() ? "" : path + (IsListOfMaps(key) ? ".0." : ".");
    ExpectRefused(map + "no_such_key=1");
    ++maps;
  });
  EXPECT_GE(maps, 15);
}

TEST_F(ScenarioSchemaTest, RequiredKeysAreRequired) {
  const auto faulty = [&](const std::string& from) {
    const std::string text = Edit(valid_, from, "");
    return schema_.Fault(JsonOf(ReadConfigFile(folder_.Write("a.yaml", text))));
  };
  for (const char* line : {"sidestep: 1\n", "name: hop\n", "robot: mini\n", "duration_s: 6\n",
                           "body: trunk, ", "force_N: [0, 5, 0], ", "magnitude_N: 2, ",
                           "direction_rad: 0, ", "start_s: 2, ", ", duration_s: 0.1"}) {
    EXPECT_NE(faulty(line), "") << line;
    EXPECT_NE(ErrorOfEdit(line, ""), "no error") << line;
  }
  EXPECT_EQ(faulty("seed: 7\n"), "") << "has a default";
}

TEST_F(ScenarioSchemaTest, FormsOfTheirOwn) {
  for (const char* good :
       {"video=false", "video=true", "gait=[{type: hop}, {start_s: 2}]", "pushes=[]",
        "expect.fall=true", "expect.energy_J=3", "expect.energy_J={min: 1}", "expect={}"}) {
    EXPECT_EQ(FaultOfSet(good), "") << good;
    EXPECT_EQ(ErrorOfSet(good), "no error") << good;
  }
  for (const char* bad :
       {"gait=[]", "pushes={}", "expect.fall=0", "expect.energy_J=true", "expect.energy_J={}",
        "expect.energy_J={mean: 1}", "video.size=[321, 240]", "pushes.0.magnitude_N=3",
        "pushes.0.direction_rad=1"}) {
    EXPECT_NE(FaultOfSet(bad), "") << bad;
    EXPECT_NE(ErrorOfSet(bad), "no error") << bad;
  }
}

}  // namespace
}  // namespace sidestep::scenario_schema_test
