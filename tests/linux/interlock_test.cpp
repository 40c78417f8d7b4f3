#include "firmware/boards/linux/interlock.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "firmware/boards/linux/settle_turn.hpp"

namespace board {
namespace {

struct ScriptedLines {
  hal::Error set(bool drive_on, bool brake_on) {
    ++sets;
    if (error == hal::Error::none) {
      drive = drive_on;
      brake = brake_on;
    }
    return error;
  }
  hal::Result<bool> stop_asserted() const { return stop; }

  hal::Result<bool> stop = false;
  hal::Error error = hal::Error::none;
  bool drive = false;
  bool brake = true;
  int sets = 0;
};

class Interlocked : public testing::Test {
 protected:
  void let_go() {
    static_cast<void>(brake_.set(false));
    static_cast<void>(drive_.set(true));
  }
  bool asserted() {
    const auto result = stop_.asserted();
    EXPECT_TRUE(result);
    return result && *result;
  }

  ScriptedLines lines_;
  Interlock<ScriptedLines> interlock_{lines_};
  Interlock<ScriptedLines>::Drive drive_{interlock_};
  Interlock<ScriptedLines>::Brake brake_{interlock_};
  Interlock<ScriptedLines>::Stop stop_{interlock_};
};

TEST_F(Interlocked, BeginsWithTheDriveOffAndTheBrakeOn) {
  EXPECT_EQ(drive_.set(false), hal::Error::off) << "nothing has been set yet";
  interlock_.isr_apply();
  EXPECT_EQ(lines_.sets, 1);
  EXPECT_FALSE(lines_.drive);
  EXPECT_TRUE(lines_.brake);
  EXPECT_EQ(drive_.set(false), hal::Error::none);
}

TEST_F(Interlocked, TheApplicationMovesTheLinesInTheNextPeriod) {
  let_go();
  EXPECT_FALSE(lines_.drive);
  interlock_.isr_apply();
  EXPECT_TRUE(lines_.drive);
  EXPECT_FALSE(lines_.brake);
  interlock_.isr_apply();
  EXPECT_EQ(lines_.sets, 1) << "nothing has changed";
}

TEST_F(Interlocked, AStopTakesTheDriveInThePeriodThatSeesIt) {
  let_go();
  interlock_.isr_apply();
  lines_.stop = true;
  interlock_.isr_apply();
  EXPECT_FALSE(lines_.drive);
  EXPECT_TRUE(lines_.brake);
  EXPECT_TRUE(asserted());
}

TEST_F(Interlocked, AfterAShortStopTheDriveStaysOffAndTheApplicationHearsOfIt) {
  let_go();
  interlock_.isr_apply();
  lines_.stop = true;
  interlock_.isr_apply();
  lines_.stop = false;
  interlock_.isr_apply();
  EXPECT_TRUE(asserted()) << "it was";
  EXPECT_FALSE(asserted());
  let_go();
  interlock_.isr_apply();
  EXPECT_FALSE(lines_.drive) << "until the next start";
  EXPECT_TRUE(lines_.brake);
}

TEST_F(Interlocked, AStopThatCannotBeReadIsAStop) {
  let_go();
  interlock_.isr_apply();
  lines_.stop = hal::Error::failed;
  interlock_.isr_apply();
  EXPECT_FALSE(lines_.drive);
  EXPECT_EQ(stop_.asserted().error(), hal::Error::failed);
}

TEST_F(Interlocked, LinesThatFailAreTriedAgainAndTold) {
  interlock_.isr_apply();
  let_go();
  lines_.error = hal::Error::failed;
  interlock_.isr_apply();
  EXPECT_EQ(drive_.set(true), hal::Error::failed);
  interlock_.isr_apply();
  EXPECT_EQ(lines_.sets, 3);
  lines_.error = hal::Error::none;
  interlock_.isr_apply();
  EXPECT_TRUE(lines_.drive);
  EXPECT_EQ(drive_.set(true), hal::Error::none);
}

TEST_F(Interlocked, LockedItLetsNothingGo) {
  let_go();
  interlock_.isr_apply();
  EXPECT_EQ(interlock_.lock(), hal::Error::none);
  EXPECT_FALSE(lines_.drive);
  EXPECT_TRUE(lines_.brake);
  EXPECT_FALSE(asserted()) << "that is no emergency";
}

TEST(SettleTurn, TheLoopSettlesWhileThereIsMoreUpToItsBound) {
  SettleTurn turn;
  int left = 5;
  int calls = 0;
  const auto settle = [&] {
    ++calls;
    return --left > 0;
  };
  turn.isr_settle(3, settle);
  EXPECT_EQ(calls, 3);
  turn.isr_settle(3, settle);
  EXPECT_EQ(calls, 5);
}

TEST(SettleTurn, TheLoopDoesNotWaitForAReader) {
  SettleTurn turn;
  turn.hold();
  int calls = 0;
  std::thread loop([&] { turn.isr_settle(1, [&] { return ++calls > 99; }); });
  loop.join();
  EXPECT_EQ(calls, 0);
  turn.release();
  turn.isr_settle(1, [&] { return ++calls > 99; });
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace board
