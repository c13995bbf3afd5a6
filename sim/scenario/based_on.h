// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// based_on: a scenario's file that starts from another's and tells only what differs.
//
// In : a file.     Out: one tree without `based_on`, whose values know the files they came from.
// Flow: file (and the file that it is based on, ...) -> [based_on] -> overrides -> read strictly.

#include <filesystem>
#include <string>

#include "controller/types/field.h"
#include "models/support/config_node.h"
#include "models/support/config_tree.h"
#include "sim/scenario/renamed_keys.h"

namespace sidestep {

/// The key of a file that its Scenario no longer has.
struct BasedOn {
  std::string base;

  static constexpr const char* kKey = "based_on";

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit(kKey, self.base,
          "another scenario to start from: a path beside this file, or one that ships; maps are "
          "merged key by key, other values, lists and `expect` replace its own");
  }
};

/// Refuses a sweep's file and other formats than version 1. `map` is of `root`.
void CheckFormat(const ConfigTree& root, ConfigMap* map);

/// Reads a scenario's file and those that it is based on, at most 8 in all, as one tree.
///
/// What the file says goes before what its base says: maps are merged key by key, at any depth;
/// anything else replaces the base's value, lists too, and so does `expect` at the top: what is to
/// come of one run is not what is to come of another. `sidestep` and `name` are never the base's.
///
/// @param note  Told of keys under an old name.
/// @throws ConfigError at the place of `based_on` if it names no file, leads back to a file of the
///         chain or too far; as ReadConfigFile; and for files of another format than 1.
ConfigTree ReadWithBases(const std::filesystem::path& file, const NoteSink& note);

}  // namespace sidestep
