// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// interrupt: Ctrl-C and a polite kill end a run early but leave its files whole.
//
// The handler only raises a flag. The episode loop reads it each tick, ends, and everything after
// it (files, summary) goes on as usual with verdict INVALID, reason INTERRUPTED.

#include <atomic>
#include <csignal>

namespace sidestep {

namespace internal {
inline std::atomic<bool> interrupt_flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not take a lock");
}  // namespace internal

/// True once SIGINT or SIGTERM arrived.
inline bool InterruptRequested() { return internal::interrupt_flag.load(); }

/// Makes the first SIGINT and the first SIGTERM raise the flag; a second one of the same kind ends
/// the program at once, as usual. Call once, from main.
inline void InstallInterruptHandlers() {
  struct sigaction action {};
  action.sa_handler = [](int) { internal::interrupt_flag.store(true); };
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace sidestep
