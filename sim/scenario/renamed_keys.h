// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// renamed_keys: old names of keys, which stay readable with a note.

#include <functional>
#include <string>

#include "models/support/config_tree.h"

namespace sidestep {

/// Takes a line that a user should see although nothing is wrong; may be empty.
using NoteSink = std::function<void(const std::string& note)>;

/// Gives every renamed key of a scenario or a robot.yaml its present name, at the place where it
/// is, and tells each: `file:line:column: note: control.wbc is now control.inverse_dynamics`.
/// Throws ConfigError if a map has both names.
void RenameOldKeys(ConfigTree* root, const NoteSink& note);

/// The dotted path under its present name: `control.wbc.friction` gives
/// `control.inverse_dynamics.friction`, with a note that names `place`.
std::string RenamedPath(const std::string& path, const ConfigPlace& place, const NoteSink& note);

}  // namespace sidestep
