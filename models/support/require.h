// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// require: an always-on check of contracts between parts of the program.
//
// A broken contract is our bug, never a user's mistake or a hard control problem: those have
// ConfigError and status values. It ends the program with exit code 3.

#include <sstream>
#include <stdexcept>
#include <string>

namespace sidestep {

/// Thrown by SIDESTEP_REQUIRE; caught only in main, which exits with 3.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace internal {

/// Throws ContractViolation naming the condition, the value that broke it and the place.
template <typename Value>
[[noreturn]] void FailRequirement(const char* condition, const Value& value, const char* file,
                                  int line) {
  std::ostringstream message;
  message << file << ":" << line << ": requirement violated: " << condition << " (got " << value
          << ")";
  throw ContractViolation(message.str());
}

}  // namespace internal
}  // namespace sidestep

/// Checks `condition` in every build type; `value` is printed when it does not hold.
/// `value` is evaluated only on failure and needs an operator<<; the check costs one branch and
/// does not allocate while it holds.
#define SIDESTEP_REQUIRE(condition, value)                                            \
  do {                                                                                \
    if (!(condition)) {                                                               \
      ::sidestep::internal::FailRequirement(#condition, (value), __FILE__, __LINE__); \
    }                                                                                 \
  } while (false)
