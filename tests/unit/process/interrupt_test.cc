// SPDX-License-Identifier: BSD-3-Clause
#include "sim/process/interrupt.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace sidestep::interrupt_test {
namespace {

// Leaves the program as interruptible as it was found.
class InterruptTest : public ::testing::Test {
 protected:
  InterruptTest() {
    sigaction(SIGINT, nullptr, &int_before_);
    sigaction(SIGTERM, nullptr, &term_before_);
  }
  ~InterruptTest() override {
    sigaction(SIGINT, &int_before_, nullptr);
    sigaction(SIGTERM, &term_before_, nullptr);
    internal::interrupt_flag = false;
    internal::interrupt_time_s = 0;
  }

 private:
  struct sigaction int_before_ {};
  struct sigaction term_before_ {};
};

TEST_F(InterruptTest, EitherSignalRaisesTheFlagAndTheSameRequestToldTwiceIsOne) {
  InstallInterruptHandlers();
  EXPECT_FALSE(InterruptRequested());
  std::raise(SIGTERM);
  EXPECT_TRUE(InterruptRequested());
  std::raise(SIGINT);  // at once: we are still here
  EXPECT_TRUE(InterruptRequested());
}

TEST_F(InterruptTest, ASignalThatComesLaterEndsTheProgram) {
  const auto insist = [] {
    InstallInterruptHandlers();
    std::raise(SIGINT);
    internal::interrupt_time_s = internal::interrupt_time_s.load() - 5;  // as if 5 s ago
    std::raise(SIGINT);
  };
  EXPECT_EXIT(insist(), ::testing::KilledBySignal(SIGINT), "");
}

TEST_F(InterruptTest, WhereNothingIsBegunItEndsTheProgramAtOnce) {
  constexpr int kExitCode = 3;
  const auto read_for_long = [] {
    InstallInterruptHandlers();
    const EndsAtOnce reading(kExitCode);
    std::raise(SIGTERM);
    ADD_FAILURE() << "we are still here";
  };
  EXPECT_EXIT(read_for_long(), ::testing::ExitedWithCode(kExitCode), "^sidestep: interrupted\n$");
  const auto read_then_run = [] {
    InstallInterruptHandlers();
    { const EndsAtOnce reading(kExitCode); }
    std::raise(SIGTERM);
    _exit(InterruptRequested() ? 0 : 1);
  };
  EXPECT_EXIT(read_then_run(), ::testing::ExitedWithCode(0), "");
}

TEST_F(InterruptTest, ASignalThatCameBeforeIsNotForgotten) {
  InstallInterruptHandlers();
  std::raise(SIGINT);
  EXPECT_THROW(EndsAtOnce(3), Interrupted);
}

}  // namespace
}  // namespace sidestep::interrupt_test
