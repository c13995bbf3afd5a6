// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// interrupt: Ctrl-C and a polite kill end a run early but leave its files whole.
//
// The handler only raises a flag. The episode loop reads it each tick, ends, and everything after
// it (files, summary) goes on as usual with verdict INVALID, reason INTERRUPTED. What draws ends
// its programs and throws Interrupted.

#include <atomic>
#include <csignal>
#include <ctime>
#include <stdexcept>

namespace sidestep {

namespace internal {

inline std::atomic<bool> interrupt_flag{false};
inline std::atomic<std::time_t> interrupt_time_s{0};
static_assert(std::atomic<bool>::is_always_lock_free &&
                  std::atomic<std::time_t>::is_always_lock_free,
              "a signal handler may not take a lock");

/// Ends the program on a signal that comes more than a second after the first: the user insists.
/// Sooner, it is the same request told twice (a terminal and `timeout` tell process and group).
inline void HandleInterrupt(int signal) {
  constexpr std::time_t kPatience_s = 1;
  const std::time_t now_s = std::time(nullptr);
  if (!interrupt_flag.exchange(true)) {
    interrupt_time_s.store(now_s);
  } else if (now_s > interrupt_time_s.load() + kPatience_s) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace internal

/// Work was given up because the user asked for it; what was begun is cleared away.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// True once SIGINT or SIGTERM arrived.
inline bool InterruptRequested() { return internal::interrupt_flag.load(); }

/// Makes the first such signal raise the flag; a later one ends the program at once.
inline void InterruptOn(int signal) {
  struct sigaction action {};
  action.sa_handler = internal::HandleInterrupt;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

/// InterruptOn SIGINT and SIGTERM. Call once, from main.
inline void InstallInterruptHandlers() {
  InterruptOn(SIGINT);
  InterruptOn(SIGTERM);
}

}  // namespace sidestep
