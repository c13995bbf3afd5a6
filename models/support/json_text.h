// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// json_text: JSON from a file that may be anything, with bounds on what is taken.

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "models/support/config_error.h"
#include "models/support/text_place.h"

namespace sidestep {

inline constexpr std::size_t kMostJsonBytes = std::size_t{16} << 20;

/// Deeper than anything that this program writes.
inline constexpr int kDeepestJson = 32;

/// Likewise of one object's keys; an ordered_json looks for each from the first on.
inline constexpr int kMostJsonKeys = 10000;

/// Parses a whole JSON text.
///
/// @tparam Json  nlohmann::json or ordered_json.
/// @param file   Its name, for the errors.
/// @throws ConfigError of one line, with line and column where the JSON breaks off, if `text` is
///         not JSON, is larger than kMostJsonBytes, is nested deeper than kDeepestJson, has an
///         object of more than kMostJsonKeys or a number beyond the range of a double.
template <typename Json>
Json ParseJson(const std::string& text, const std::string& file) {
  if (text.size() > kMostJsonBytes) {
    throw ConfigError(file + ": error: is larger than " + std::to_string(kMostJsonBytes >> 20) +
                      " MiB");
  }
  std::array<int, kDeepestJson + 2> num_keys{};  // of the object that is open at a depth
  const auto is_bounded = [&](int depth, typename Json::parse_event_t event, const Json&) {
    using Event = typename Json::parse_event_t;
    const bool begins = event == Event::array_start || event == Event::object_start;
    if (begins && depth >= kDeepestJson) {
      throw ConfigError(file + ": error: is nested deeper than " + std::to_string(kDeepestJson));
    }
    if (begins) num_keys[static_cast<std::size_t>(depth) + 1] = 0;
    const bool is_key = event == Event::key;  // its depth is one more than its object's
    if (is_key && ++num_keys[static_cast<std::size_t>(depth)] > kMostJsonKeys) {
      throw ConfigError(file + ": error: has an object of more than " +
                        std::to_string(kMostJsonKeys) + " keys");
    }
    return true;
  };
  try {
    return Json::parse(text, is_bounded);
  } catch (const typename Json::parse_error& broken) {
    const TextPlace place = PlaceIn(text, broken.byte == 0 ? 0 : broken.byte - 1);
    throw ConfigError(file, place.line, place.column, "the JSON breaks off here");
  } catch (const typename Json::exception&) {
    throw ConfigError(file + ": error: holds a number beyond the range of a double");
  }
}

/// Reads and parses a file. @throws ConfigError also if it can't be read.
template <typename Json>
Json ReadJsonFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) {
    throw ConfigError(file.string() + ": error: can't be read");
  }
  std::string text;
  for (char block[4096];
       text.size() <= kMostJsonBytes && in.read(block, sizeof block).gcount() > 0;) {
    text.append(block, static_cast<std::size_t>(in.gcount()));
  }
  return ParseJson<Json>(text, file.string());
}

}  // namespace sidestep
