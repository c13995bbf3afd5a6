// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// key_text: tables of keys and of metrics, for the screen and for scenarios/README.md.

#include <string>

namespace sidestep {

/// What `sidestep keys [PREFIX]` prints: one aligned row a key with path, unit, range, default and
/// meaning; all keys below `prefix`, or itself. Throws ConfigError on an unknown prefix.
std::string KeysText(const std::string& prefix);

/// The same as Markdown, one table a map.
std::string KeysMarkdown(const std::string& prefix);

/// What `sidestep metrics` prints: name, unit and meaning of every metric.
std::string MetricsText();

/// The same as Markdown.
std::string MetricsMarkdown();

}  // namespace sidestep
