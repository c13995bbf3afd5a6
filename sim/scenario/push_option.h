// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// push_option: `--push 'r_hand 60N@90deg 9.5s+1s'`, a push in one line.

#include <string>
#include <string_view>

#include "models/support/config_tree.h"

namespace sidestep {

/// How an override that is a push begins, where others read `a.b=c`.
inline constexpr std::string_view kPushOption = "--push ";

/// Appends a push to those of a scenario.
///
/// @param text  `BODY SIZE@DIRECTION START+DURATION`. Sizes are in N, mg (weights of the plant) or
///              Ns/kg (impulse over its mass); directions in deg or rad from the heading, to the
///              left; START is `9.5s`, or an instant of a stride, `mid_swing`, with the foot,
///              `mid_swing:left`, and the time from which it counts, `mid_swing:left>5s`.
/// @param root  The scenario's tree; gets a list `pushes` if it has none.
/// @throws ConfigError `--push 'text': error: ...`. What the reader later finds wrong with the push
///         reads the same way.
void AddPush(const std::string& text, ConfigTree* root);

}  // namespace sidestep
