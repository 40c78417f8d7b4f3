#include "firmware/boards/interlock.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "firmware/boards/linux/devices.hpp"

namespace boards::linux_controller {
namespace {

struct ScriptedOutput {
  hal::Error set(bool on) {
    ++sets;
    asserted = error == hal::Error::none ? on : asserted;
    return error;
  }

  bool asserted = false;
  hal::Error error = hal::Error::none;
  int sets = 0;
};
struct ScriptedStop {
  [[nodiscard]] hal::Result<bool> asserted() const { return now; }

  hal::Result<bool> now = false;
};
struct ScriptedLines {
  ScriptedOutput drive_enable;
  ScriptedOutput brake;
  ScriptedStop emergency_stop;
};

class Interlocked : public testing::Test {
 protected:
  using Lock = Interlock<ScriptedLines, 1>;

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
  Lock interlock_{lines_};
  Lock::Drive drive_{interlock_};
  Lock::Brake brake_{interlock_};
  Lock::Stop stop_{interlock_};
};

TEST_F(Interlocked, BeginsWithTheDriveOffAndTheBrakeOn) {
  EXPECT_EQ(drive_.set(false), hal::Error::off) << "nothing has been set yet";
  interlock_.isr_apply(true);
  EXPECT_EQ(lines_.drive_enable.sets, 1);
  EXPECT_FALSE(lines_.drive_enable.asserted);
  EXPECT_TRUE(lines_.brake.asserted);
  EXPECT_EQ(drive_.set(false), hal::Error::none);
}

TEST_F(Interlocked, BeforeTheFirstPeriodNobodyKnowsOfTheStop) {
  EXPECT_EQ(stop_.asserted().error(), hal::Error::off);
  interlock_.isr_apply(false);
  EXPECT_FALSE(asserted());
}

TEST_F(Interlocked, TheApplicationMovesTheLinesInTheNextPeriod) {
  let_go();
  EXPECT_FALSE(lines_.drive_enable.asserted);
  interlock_.isr_apply(true);
  EXPECT_TRUE(lines_.drive_enable.asserted);
  EXPECT_FALSE(lines_.brake.asserted);
  interlock_.isr_apply(true);
  EXPECT_EQ(lines_.drive_enable.sets, 1) << "nothing has changed";
}

TEST_F(Interlocked, AStopTakesTheDriveInThePeriodThatSeesIt) {
  let_go();
  interlock_.isr_apply(true);
  lines_.emergency_stop.now = true;
  interlock_.isr_apply(true);
  EXPECT_FALSE(lines_.drive_enable.asserted);
  EXPECT_TRUE(lines_.brake.asserted);
  EXPECT_TRUE(asserted());
}

TEST_F(Interlocked, AfterAShortStopTheDriveStaysOffAndTheApplicationHearsOfIt) {
  let_go();
  interlock_.isr_apply(true);
  lines_.emergency_stop.now = true;
  interlock_.isr_apply(true);
  lines_.emergency_stop.now = false;
  interlock_.isr_apply(true);
  EXPECT_TRUE(asserted()) << "it was";
  EXPECT_FALSE(asserted());
  let_go();
  interlock_.isr_apply(true);
  EXPECT_FALSE(lines_.drive_enable.asserted) << "until the next start";
  EXPECT_TRUE(lines_.brake.asserted);
}

TEST_F(Interlocked, AStopThatCannotBeReadIsAStop) {
  let_go();
  interlock_.isr_apply(true);
  lines_.emergency_stop.now = hal::Error::failed;
  interlock_.isr_apply(true);
  EXPECT_FALSE(lines_.drive_enable.asserted);
  EXPECT_EQ(stop_.asserted().error(), hal::Error::failed);
}

TEST_F(Interlocked, LinesThatFailAreTriedAgainAndTold) {
  interlock_.isr_apply(true);
  let_go();
  for (ScriptedOutput* const line : {&lines_.drive_enable, &lines_.brake}) {
    line->error = hal::Error::failed;
    interlock_.isr_apply(true);
    EXPECT_EQ(drive_.set(true), hal::Error::failed);
    interlock_.isr_apply(true);
    EXPECT_EQ(drive_.set(true), hal::Error::failed);
    EXPECT_FALSE(lines_.drive_enable.asserted);
    line->error = hal::Error::none;
  }
  EXPECT_EQ(lines_.drive_enable.sets, 5);
  interlock_.isr_apply(true);
  EXPECT_TRUE(lines_.drive_enable.asserted);
  EXPECT_EQ(drive_.set(true), hal::Error::none);
}

TEST_F(Interlocked, LockedItLetsNothingGo) {
  let_go();
  interlock_.isr_apply(true);
  EXPECT_EQ(interlock_.lock(), hal::Error::none);
  EXPECT_FALSE(lines_.drive_enable.asserted);
  EXPECT_TRUE(lines_.brake.asserted);
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
}  // namespace boards::linux_controller
