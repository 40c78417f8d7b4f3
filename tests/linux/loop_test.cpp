#include "hal/linux/loop.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <vector>

namespace hal::linux_os {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(Schedule, AWakeUpInTimeMovesOnByOnePeriod) {
  Schedule schedule(10 * kMs, kMs);
  EXPECT_EQ(schedule.deadline_ns(), 10 * kMs);
  const Wake wake = schedule.wake(10 * kMs);
  EXPECT_EQ(wake.late_ns, 0);
  EXPECT_EQ(wake.missed, 0U);
  EXPECT_EQ(schedule.deadline_ns(), 11 * kMs);
}

TEST(Schedule, ALateWakeUpDoesNotShiftTheDeadlines) {
  Schedule schedule(10 * kMs, kMs);
  const Wake wake = schedule.wake(10 * kMs + 999'999);
  EXPECT_EQ(wake.late_ns, 999'999);
  EXPECT_EQ(wake.missed, 0U);
  EXPECT_EQ(schedule.deadline_ns(), 11 * kMs);
}

TEST(Schedule, MissedDeadlinesAreCountedAndNotCaughtUp) {
  Schedule schedule(10 * kMs, kMs);
  const Wake wake = schedule.wake(13 * kMs);
  EXPECT_EQ(wake.late_ns, 3 * kMs);
  EXPECT_EQ(wake.missed, 3U) << "those at 11, 12 and 13 ms; this call is the one of 10 ms";
  EXPECT_EQ(schedule.deadline_ns(), 14 * kMs);
}

RC_GTEST_PROP(ScheduleProperty, EveryDeadlineIsMetOrMissed, ()) {
  const auto period_ns = *rc::gen::inRange<std::int64_t>(1, 100 * kMs);
  const auto delays =
      *rc::gen::container<std::vector<std::int64_t>>(rc::gen::inRange<std::int64_t>(0, 500 * kMs));
  Schedule schedule(period_ns, period_ns);
  std::int64_t calls = 0;
  std::int64_t missed = 0;
  for (const std::int64_t delay_ns : delays) {
    const std::int64_t now_ns = schedule.deadline_ns() + delay_ns;
    missed += schedule.wake(now_ns).missed;
    ++calls;
    RC_ASSERT(schedule.deadline_ns() > now_ns);
    RC_ASSERT(schedule.deadline_ns() - now_ns <= period_ns);
    RC_ASSERT(schedule.deadline_ns() == (1 + calls + missed) * period_ns);
  }
}

TEST(Jitter, QuantilesAreUpperBoundsOfTheirClass) {
  Jitter jitter;
  EXPECT_EQ(jitter.quantile_us(990), 0U);
  for (int i = 0; i < 99; ++i) {
    jitter.note(3'400, 0);
  }
  jitter.note(50'000, 0);
  EXPECT_EQ(jitter.quantile_us(990), 4U) << "99 of 100 within 4 us";
  EXPECT_EQ(jitter.quantile_us(991), 50U);
  EXPECT_EQ(jitter.quantile_us(1'000), 50U);
  EXPECT_EQ(jitter.worst_us(), 50U);
  EXPECT_EQ(jitter.count(3), 99U);
}

TEST(Jitter, WhatIsBeyondTheClassesIsInTheWorst) {
  Jitter jitter;
  jitter.note(2'000'000'000, 7);
  jitter.note(0, 2);
  EXPECT_EQ(jitter.worst_us(), 2'000'000U);
  EXPECT_EQ(jitter.quantile_us(990), 2'000'000U);
  EXPECT_EQ(jitter.quantile_us(500), 1U);
  EXPECT_EQ(jitter.count(Jitter::kClasses - 1), 1U);
  EXPECT_EQ(jitter.missed(), 9U);
}

/// Wakes up as late as the script says; a negative delay is a signal that came before the time.
struct ScriptedClock {
  [[nodiscard]] std::int64_t now_ns() const { return time_ns; }
  void wait_until(std::int64_t until_ns) {
    waits.push_back(until_ns);
    std::int64_t delay_ns = 0;
    if (!delays_ns.empty()) {
      delay_ns = delays_ns.front();
      delays_ns.pop_front();
    }
    time_ns = std::max(time_ns, until_ns + delay_ns);
  }

  std::int64_t time_ns = 0;
  std::deque<std::int64_t> delays_ns;
  std::vector<std::int64_t> waits;
};

struct LoopRun {
  ScriptedClock clock;
  Jitter jitter;
  std::atomic<bool> stop{false};
  std::vector<std::uint32_t> ticks;

  void calls(std::size_t count) {
    run_periodic(clock, kMs, jitter, stop, [&](std::uint32_t missed) {
      ticks.push_back(missed);
      return ticks.size() < count;
    });
  }
};

TEST(Loop, WaitsForAbsoluteTimes) {
  LoopRun run;
  run.clock.time_ns = 5 * kMs;
  run.clock.delays_ns = {0, 20'000, 0};
  run.calls(3);
  EXPECT_EQ(run.clock.waits, (std::vector<std::int64_t>{6 * kMs, 7 * kMs, 8 * kMs}));
  EXPECT_EQ(run.ticks, (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_EQ(run.jitter.worst_us(), 20U);
}

TEST(Loop, TellsOfMissedPeriodsOnce) {
  LoopRun run;
  run.clock.delays_ns = {0, 4 * kMs + 100, 0, 0};
  run.calls(4);
  EXPECT_EQ(run.ticks, (std::vector<std::uint32_t>{0, 4, 0, 0}));
  EXPECT_EQ(run.clock.waits, (std::vector<std::int64_t>{1 * kMs, 2 * kMs, 7 * kMs, 8 * kMs}));
  EXPECT_EQ(run.jitter.missed(), 4U);
}

TEST(Loop, AWorkThatTakesTooLongMissesItsNextDeadline) {
  LoopRun run;
  run_periodic(run.clock, kMs, run.jitter, run.stop, [&](std::uint32_t missed) {
    run.ticks.push_back(missed);
    if (run.ticks.size() == 1) {
      run.clock.time_ns += 2 * kMs + 300'000;  // began at 1 ms, ends at 3.3 ms
    }
    return run.ticks.size() < 3;
  });
  // The call of 2 ms comes at 3.3 ms, with the period of 3 ms left out.
  EXPECT_EQ(run.ticks, (std::vector<std::uint32_t>{0, 1, 0}));
  EXPECT_EQ(run.clock.waits.back(), 4 * kMs);
}

TEST(Loop, ASignalDoesNotMakeAPeriodShorter) {
  LoopRun run;
  run.clock.delays_ns = {0, -400'000, 0};
  run.calls(2);
  EXPECT_EQ(run.clock.waits, (std::vector<std::int64_t>{kMs, 2 * kMs, 2 * kMs}));
}

TEST(Loop, StopsWhenAskedTo) {
  LoopRun run;
  run_periodic(run.clock, kMs, run.jitter, run.stop, [&](std::uint32_t) {
    run.ticks.push_back(0);
    run.stop = run.ticks.size() == 2;
    return true;
  });
  EXPECT_EQ(run.ticks.size(), 2U);
}

}  // namespace
}  // namespace hal::linux_os
