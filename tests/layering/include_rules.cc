// SPDX-License-Identifier: BSD-3-Clause
#include "tests/layering/include_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <set>
#include <string_view>

namespace sidestep::layering {
namespace {

constexpr std::string_view kSpdxLine = "// SPDX-License-Identifier: BSD-3-Clause";

// A controller reads no clock, prints nothing, starts no thread, opens no file, draws no number.
constexpr std::array<std::string_view, 19> kBannedInController{"chrono",
                                                               "ctime",
                                                               "time.h",
                                                               "sys/time.h",
                                                               "iostream",
                                                               "fstream",
                                                               "cstdio",
                                                               "stdio.h",
                                                               "thread",
                                                               "mutex",
                                                               "shared_mutex",
                                                               "future",
                                                               "condition_variable",
                                                               "semaphore",
                                                               "barrier",
                                                               "latch",
                                                               "stop_token",
                                                               "random",
                                                               "unistd.h"};

std::string FolderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

bool StartsWith(const std::string& text, std::string_view prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

bool EndsWith(const std::string& text, std::string_view suffix) {
  return text.size() >= suffix.size() &&
         text.compare(text.size() - suffix.size(), suffix.size(), suffix) == 0;
}

// The example is a program with a console of its own.
bool IsInController(const std::string& path) {
  return StartsWith(path, "controller/") && !StartsWith(path, "controller/example/");
}

const Room* RoomOf(const std::vector<Room>& rooms, const std::string& folder) {
  const auto found = std::find_if(rooms.begin(), rooms.end(),
                                  [&](const Room& room) { return room.folder == folder; });
  return found == rooms.end() ? nullptr : &*found;
}

// Why `room` may not have this include, or nothing.
std::string ViolationOf(const Include& include, const Room& room, const std::vector<Room>& rooms,
                        const std::set<std::string>& paths) {
  if (StartsWith(include.target, "mujoco/") && !room.may_use_mujoco) {
    return room.folder + " may not use MuJoCo";
  }
  if (!include.is_quoted) {
    const bool is_banned =
        std::count(kBannedInController.begin(), kBannedInController.end(), include.target) > 0;
    return IsInController(room.folder + "/") && is_banned
               ? "<" + include.target + "> is banned in controller/"
               : std::string();
  }
  if (paths.count(include.target) == 0) {
    return "\"" + include.target + "\" is no file of ours by its path from the root";
  }
  const std::string folder = FolderOf(include.target);
  if (folder == room.folder || RoomOf(rooms, folder) == nullptr) return {};
  const auto& allowed = room.may_include;
  const bool is_allowed = std::count(allowed.begin(), allowed.end(), folder) > 0 ||
                          std::count(allowed.begin(), allowed.end(), include.target) > 0;
  return is_allowed ? std::string() : room.folder + " may not include " + folder;
}

}  // namespace

std::vector<Include> IncludesOf(const Source& source) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for (std::size_t i = 0; i < source.lines.size(); ++i) {
    std::smatch match;
    if (std::regex_search(source.lines[i], match, kInclude)) {
      includes.push_back({static_cast<int>(i) + 1, match[2].str(), match[1].str() == "\""});
    }
  }
  return includes;
}

std::vector<std::string> IncludeViolations(const std::vector<Source>& sources,
                                           const std::vector<Room>& rooms) {
  std::vector<std::string> violations;
  if (sources.empty()) violations.emplace_back("no source file was seen");
  std::set<std::string> paths;
  for (const Source& source : sources) paths.insert(source.path);
  for (const Source& source : sources) {
    const Room* room = RoomOf(rooms, FolderOf(source.path));
    if (room == nullptr) {
      violations.push_back(source.path + ":1: no room owns this file; see room_table.cc");
      continue;
    }
    for (const Include& include : IncludesOf(source)) {
      const std::string what = ViolationOf(include, *room, rooms, paths);
      if (what.empty()) continue;
      violations.push_back(source.path + ":" + std::to_string(include.line) + ": " + what);
    }
  }
  return violations;
}

std::vector<std::string> FormViolations(const std::vector<Source>& sources) {
  std::vector<std::string> violations;
  if (sources.empty()) violations.emplace_back("no source file was seen");
  for (const Source& source : sources) {
    const auto& lines = source.lines;
    if (lines.empty() || lines.front() != kSpdxLine) {
      violations.push_back(source.path + ":1: the first line is not `" + std::string(kSpdxLine) +
                           "`");
    }
    if (EndsWith(source.path, ".h") &&
        std::count(lines.begin(), lines.end(), "#pragma once") != 1) {
      violations.push_back(source.path + ":1: a header needs one `#pragma once`");
    }
    if (static_cast<int>(lines.size()) >= kMostLines) {
      violations.push_back(source.path + ": " + std::to_string(lines.size()) +
                           " lines; split it: fewer than " + std::to_string(kMostLines) +
                           ", better " + std::to_string(kManyLines));
    }
  }
  return violations;
}

std::vector<std::string> LongFiles(const std::vector<Source>& sources) {
  std::vector<std::string> notes;
  for (const Source& source : sources) {
    if (static_cast<int>(source.lines.size()) < kManyLines) continue;
    notes.push_back(source.path + ": " + std::to_string(source.lines.size()) + " lines");
  }
  return notes;
}

std::vector<Source> ReadSources(const std::filesystem::path& root,
                                const std::vector<std::string>& folders) {
  constexpr auto kFollow = std::filesystem::directory_options::follow_directory_symlink;
  std::vector<Source> sources;
  for (const std::string& folder : folders) {
    if (!std::filesystem::is_directory(root / folder)) continue;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(root / folder, kFollow)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file() || (extension != ".h" && extension != ".cc")) continue;
      Source source{entry.path().lexically_relative(root).generic_string(), {}};
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) source.lines.push_back(line);
      sources.push_back(std::move(source));
    }
  }
  std::sort(sources.begin(), sources.end(),
            [](const Source& a, const Source& b) { return a.path < b.path; });
  return sources;
}

}  // namespace sidestep::layering
