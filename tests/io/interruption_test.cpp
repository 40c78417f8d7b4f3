#include "hal/files/interruption.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

using hal::files::Interruption;
using hal::files::stop_if_interrupted;
using hal::files::wait_to_read;
using hal::files::wait_to_write;
using hal::files::watch_for_interruption;
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
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto run = [signal] {
      watch_for_interruption();
      ::raise(signal);
      end_with_wish();
    };
    EXPECT_EXIT(run(), ExitedWithCode(0), "");
  }
}

TEST(InterruptionDeathTest, ASignalBeforeOrDuringAWaitEndsIt) {
  const auto run = [](bool before, bool writing) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_NONBLOCK) != 0) {
      std::exit(2);
    }
    while (writing && ::write(ends[1], "x", 1) == 1) {
    }
    watch_for_interruption();
    if (before) {
      ::raise(SIGTERM);
    }
    const std::jthread later([before] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      if (!before) {
        ::kill(::getpid(), SIGTERM);
      }
    });
    try {
      writing ? wait_to_write(ends[1]) : wait_to_read(ends[0]);
    } catch (const Interruption&) {
      ::_exit(0);
    }
    ::_exit(1);
  };
  for (const bool before : {true, false}) {
    for (const bool writing : {true, false}) {
      EXPECT_EXIT(run(before, writing), ExitedWithCode(0), "");
    }
  }
}

TEST(InterruptionDeathTest, WhatDoesNotBlockIsDoneAllTheSame) {
  const auto run = [] {
    std::array<int, 2> ends{};
    watch_for_interruption();
    ::raise(SIGTERM);
    if (::pipe(ends.data()) != 0) {
      std::exit(2);
    }
    wait_to_write(ends[1]);
    std::exit(::write(ends[1], "x", 1) == 1 ? (wait_to_read(ends[0]), 0) : 1);
  };
  EXPECT_EXIT(run(), ExitedWithCode(0), "");
}

TEST(InterruptionDeathTest, EveryThreadThatWaitsIsWoken) {
  const auto run = [] {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) {
      std::exit(2);
    }
    watch_for_interruption();
    std::atomic<int> woken = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        try {
          wait_to_read(ends[0]);
        } catch (const Interruption&) {
          ++woken;
        }
      });
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::kill(::getpid(), SIGTERM);
    for (std::thread& thread : threads) {
      thread.join();
    }
    ::_exit(woken);
  };
  EXPECT_EXIT(run(), ExitedWithCode(4), "");
}

TEST(InterruptionDeathTest, ABrokenPipeIsAnErrorOfTheWrite) {
  const auto run = [] {
    std::array<int, 2> ends{};
    watch_for_interruption();
    if (::pipe(ends.data()) != 0) {
      std::exit(2);
    }
    ::close(ends[0]);
    ::_exit(::write(ends[1], "x", 1) < 0 && errno == EPIPE ? 0 : 1);
  };
  EXPECT_EXIT(run(), ExitedWithCode(0), "");
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
