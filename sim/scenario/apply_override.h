// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// apply_override: `--set a.b=c`, an edit of a scenario's tree before it is read strictly.

#include <string>

#include "models/support/config_tree.h"
#include "sim/scenario/renamed_keys.h"

namespace sidestep {

/// Replaces or adds one value. `assignment` is a dotted path, `=`, and any YAML value; list
/// elements go by index: `pushes.0.start_s=2`, `gait={type: hop}`. A key that the file lacks is
/// added (the reader refuses unknown ones); a list is not lengthened. Of a push, the file's other
/// ways to tell what the override tells (force_N for magnitude_N, start_s for at_phase) are
/// dropped. Old names of keys, in the path and in the value, become their present ones, with a
/// note. Throws ConfigError: `--set a.b=c: error: ...`. Errors that the reader later finds in the
/// new value read the same way. An assignment that begins with `--push ` adds a push instead: see
/// push_option.h.
void ApplyOverride(const std::string& assignment, ConfigTree* root, const NoteSink& note = {});

}  // namespace sidestep
