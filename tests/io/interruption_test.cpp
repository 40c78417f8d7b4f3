#include "host_sim/io/interruption.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace {

using host_sim::Interruption;
using host_sim::stop_if_interrupted;
using host_sim::watch_for_interruption;
using testing::ExitedWithCode;
using testing::KilledBySignal;

/// Ends this process with 0 where it is to stop, with 1 where it is not.
[[noreturn]] void end_with_wish() {
  try {
    stop_if_interrupted();
  } catch (const Interruption&) {
    std::exit(0);
  }
  std::exit(1);
}

TEST(InterruptionDeathTest, WithoutASignalNothingStops) {
  const auto run = [] {
    watch_for_interruption();
    end_with_wish();
  };
  EXPECT_EXIT(run(), ExitedWithCode(1), "");
}

TEST(InterruptionDeathTest, TheFirstSignalIsNoticed) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto run = [signal] {
      watch_for_interruption();
      ::raise(signal);
      end_with_wish();
    };
    EXPECT_EXIT(run(), ExitedWithCode(0), "");
  }
}

TEST(InterruptionDeathTest, AWishToldTwiceLeavesTimeToRemoveFiles) {
  const auto run = [] {
    watch_for_interruption();
    ::raise(SIGTERM);
    ::raise(SIGTERM);
    ::raise(SIGINT);
    end_with_wish();
  };
  EXPECT_EXIT(run(), ExitedWithCode(0), "");
}

TEST(InterruptionDeathTest, ASecondWishEndsTheProgramAtOnce) {
  const auto run = [] {
    watch_for_interruption();
    ::raise(SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    ::raise(SIGINT);
    end_with_wish();
  };
  EXPECT_EXIT(run(), KilledBySignal(SIGINT), "");
}

}  // namespace
