// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// interrupt: Ctrl-C and a polite kill end a run early but leave its files whole.
//
// The handler only raises a flag. The episode loop reads it each tick, ends, and everything after
// it (files, summary) goes on as usual with verdict INVALID, reason INTERRUPTED. What draws ends
// its programs and throws Interrupted. What reads may sit in a library for seconds, and has begun
// nothing: there the signal ends the program itself (EndsAtOnce).

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <stdexcept>

namespace sidestep {

namespace internal {

inline std::atomic<bool> interrupt_flag{false};
inline std::atomic<std::time_t> interrupt_time_s{0};
constexpr int kGoesOn = -1;
inline std::atomic<int> end_at_once{kGoesOn};  // or the exit code to end with
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
                  std::atomic<std::time_t>::is_always_lock_free,
              "a signal handler may not take a lock");

/// Ends the program at once where there is nothing to be kept (EndsAtOnce), and elsewhere on a
/// signal that comes more than a second after the first: the user insists.
/// Sooner, it is the same request told twice (a terminal and `timeout` tell process and group).
inline void HandleInterrupt(int signal) {
  constexpr std::time_t kPatience_s = 1;
  constexpr char kMessage[] = "sidestep: interrupted\n";
  if (const int exit_code = end_at_once.load(); exit_code != kGoesOn) {
    [[maybe_unused]] const auto ignored = write(STDERR_FILENO, kMessage, sizeof kMessage - 1);
    _exit(exit_code);
  }
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

/// While one lives, such a signal ends the program at once with this exit code. For reading and
/// computing: what may take long where no flag is looked at, and leaves no file to be made whole.
class EndsAtOnce {
 public:
  /// @throws Interrupted if a signal came before.
  explicit EndsAtOnce(int exit_code) {
    if (InterruptRequested()) throw Interrupted();
    std::fflush(stdout);  // what was said before is said
    before_ = internal::end_at_once.exchange(exit_code);
  }
  ~EndsAtOnce() { internal::end_at_once.store(before_); }
  EndsAtOnce(const EndsAtOnce&) = delete;
  EndsAtOnce& operator=(const EndsAtOnce&) = delete;

 private:
  int before_{internal::kGoesOn};
};

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
