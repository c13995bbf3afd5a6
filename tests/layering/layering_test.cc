// SPDX-License-Identifier: BSD-3-Clause
// The architecture's guard: the sources of this tree against the table of rooms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/layering/include_rules.h"
#include "tests/layering/room_table.h"

namespace sidestep::layering {
namespace {

std::string Listed(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "\n  " + line;
  return text;
}

std::vector<Source> ProgramSources() {
  return ReadSources(SIDESTEP_SOURCE_DIR, {"models", "controller", "sim"});
}

// The room of an entry of the table: a single header stands in its room.
std::string RoomOfEntry(const std::string& entry) {
  const bool is_header = entry.size() > 2 && entry.substr(entry.size() - 2) == ".h";
  return is_header ? entry.substr(0, entry.rfind('/')) : entry;
}

// Height of a room in the house: a room may include its own floor and the ones below. The example
// of a user's own controller is a program, so it stands on top of all.
int Floor(const std::string& folder) {
  if (folder.rfind("controller/example", 0) == 0) return 3;
  const std::string top = folder.substr(0, folder.find('/'));
  return static_cast<int>(std::string("mcs").find(top.front()));
}

TEST(LayeringTest, EveryIncludeIsAllowedByTheTable) {
  const std::vector<std::string> violations = IncludeViolations(ProgramSources(), Rooms());
  EXPECT_TRUE(violations.empty()) << Listed(violations);
}

TEST(LayeringTest, EverySourceHasLicenceLineAndHeaderGuardAndIsShort) {
  const std::vector<Source> sources =
      ReadSources(SIDESTEP_SOURCE_DIR, {"models", "controller", "sim", "tests"});
  for (const std::string& note : LongFiles(sources)) std::cout << "long file: " << note << "\n";
  const std::vector<std::string> violations = FormViolations(sources);
  EXPECT_TRUE(violations.empty()) << Listed(violations);
}

TEST(LayeringTest, ColoursStandInThePaletteAlone) {
  const std::regex color("#[0-9A-Fa-f]{6}\\b");
  int found_in_palette = 0;
  for (const Source& source : ProgramSources()) {
    const bool is_palette = source.path == "sim/palette/palette.h";
    for (std::size_t i = 0; i < source.lines.size(); ++i) {
      if (!std::regex_search(source.lines[i], color)) continue;
      found_in_palette += is_palette;
      EXPECT_TRUE(is_palette) << source.path << ":" << i + 1 << ": " << source.lines[i];
    }
  }
  EXPECT_GT(found_in_palette, 0);
}

TEST(LayeringTest, SourcesOfEveryFloorAreSeen) {
  std::map<int, int> files_of_floor;
  for (const Source& source : ProgramSources()) ++files_of_floor[Floor(source.path)];
  EXPECT_GT(files_of_floor[0], 0) << "models/";
  EXPECT_GT(files_of_floor[1], 0) << "controller/";
  EXPECT_GT(files_of_floor[2], 0) << "sim/";
}

TEST(RoomTableTest, NoRoomMayIncludeAFloorAbove) {
  for (const Room& room : Rooms()) {
    for (const std::string& below : room.may_include) {
      EXPECT_LE(Floor(below), Floor(room.folder)) << room.folder << " -> " << below;
    }
  }
}

TEST(RoomTableTest, InControllerOnlyModelMayUseMujoco) {
  for (const Room& room : Rooms()) {
    if (Floor(room.folder) != 1) continue;
    EXPECT_EQ(room.may_use_mujoco, room.folder == "controller/model") << room.folder;
  }
}

TEST(RoomTableTest, VerdictAndSensorsSeeNoBelief) {
  for (const Room& room : Rooms()) {
    if (room.folder != "sim/verdict" && room.folder != "sim/sensors") continue;
    for (const std::string& other : room.may_include) {
      EXPECT_TRUE(Floor(other) != 1 || other == "controller/types")
          << room.folder << " -> " << other << ": truth only, no belief";
    }
  }
}

TEST(RoomTableTest, LoopAndVerdictKnowNoPartOfAController) {
  // The door, the types that cross it, and (for the scenario's nominal gait) a pure function.
  const std::vector<std::string> known{"controller/types", "controller/controller.h",
                                       "controller/make_controller.h"};
  for (const Room& room : Rooms()) {
    if (room.folder != "sim/episode" && room.folder != "sim/verdict") continue;
    for (const std::string& other : room.may_include) {
      if (Floor(other) != 1) continue;
      EXPECT_EQ(std::count(known.begin(), known.end(), other), 1) << room.folder << " -> " << other;
    }
  }
}

TEST(RoomTableTest, RoomsStandOnEachOtherWithoutACircle) {
  // Takes away rooms that stand on nothing until none is left. Single headers do not count: they
  // are allowed just where two rooms share words.
  std::map<std::string, std::vector<std::string>> below;
  for (const Room& room : Rooms()) below[room.folder] = room.may_include;
  for (bool is_smaller = true; is_smaller;) {
    is_smaller = false;
    for (const Room& room : Rooms()) {
      if (below.count(room.folder) == 0) continue;
      const auto& rests_on = below[room.folder];
      if (std::any_of(rests_on.begin(), rests_on.end(),
                      [&](const std::string& other) { return below.count(other) > 0; })) {
        continue;
      }
      below.erase(room.folder);
      is_smaller = true;
    }
  }
  for (const auto& [room, unused] : below) ADD_FAILURE() << room << " is part of a circle";
}

TEST(RoomTableTest, EveryRoomIsListedOnceAndIncludesOnlyRooms) {
  std::map<std::string, int> count;
  for (const Room& room : Rooms()) ++count[room.folder];
  for (const Room& room : Rooms()) {
    EXPECT_EQ(count[room.folder], 1) << room.folder;
    for (const std::string& other : room.may_include) {
      EXPECT_EQ(count[RoomOfEntry(other)], 1) << other;
    }
  }
}

}  // namespace
}  // namespace sidestep::layering
