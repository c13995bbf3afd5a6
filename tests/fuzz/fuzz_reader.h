// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fuzz_reader: what is asked of every reader, whatever the file: it reads, or it tells what is
// wrong.
//
// Anything else ends the program, which is how libFuzzer learns of it: an exception that is no
// ConfigError, a sanitizer's finding, an assert, an exit, or words that are no words for a user.

#include <string>

#include "models/support/config_error.h"

namespace sidestep::fuzz {

/// Prints `what` and ends the program if `holds` is false.
void Require(bool holds, const std::string& what);

/// Requires that every line of a message is `place: error: what` (or note, notice, warning), short,
/// in UTF-8 and without control characters. With FUZZ_TELL in the environment it is printed.
void RequireWords(const std::string& message);

/// Whether `read` reads. It may throw ConfigError, whose words are looked at, and nothing else.
template <typename Read>
bool IsRead(Read&& read) {
  try {
    read();
  } catch (const ConfigError& error) {
    RequireWords(error.what());
    return false;
  }
  return true;
}

/// Requires that `read` reads: what it reads was written by this program.
template <typename Read>
void RequireRead(Read&& read) {
  try {
    read();
  } catch (const ConfigError& error) {
    Require(false, std::string("what this program wrote can't be read: ") + error.what());
  }
}

}  // namespace sidestep::fuzz
