#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>

#include "firmware/app/safety.hpp"
#include "firmware/boards/interlock.hpp"

namespace hal_test {

/// What the emergency stop of every board does, from the contact to the drive, under the
/// application's own Safety. `Rig`, which begins with the contact at rest:
///   using Lock                          the board's Interlock
///   Lock& interlock()
///   kPeriod_us, kPeriodsInTime          of the control loop
///   kShortest_us                        stops of this length are seen
///   kOffWithin_us                       from the contact to the drive off
///   void pull(bool pulled)              the world
///   void period(bool in_time)           one period of the control loop, as the board runs it
///   void wait(periods, after)           the application waits as long as this for its store;
///   after()
///                                       is called after each period of the control loop
///   bool drive(), bool brake()          what the world sees
///   void break_brake(bool broken)       the brake stays closed, whatever its line is set to
///   bool break_stop()                   the stop cannot be read; false where that cannot be
template <class Rig>
class EmergencyStopBench {
 public:
  static constexpr std::uint32_t kPollPeriods = 1'000 / Rig::kPeriod_us;

  /// As the boards start the application.
  void start() {
    rig.interlock().isr_apply(false);
    safety.start();
  }
  /// The application looks each millisecond.
  void run_ms(std::uint32_t time_ms, bool in_time = true) {
    for (std::uint32_t i = 0; i < time_ms; ++i) {
      for (std::uint32_t j = 0; j < kPollPeriods; ++j) {
        rig.period(in_time);
      }
      safety.check();
    }
  }
  void let_go() {
    start();
    run_ms(Rig::kPeriodsInTime + 1);
    ASSERT_TRUE(rig.drive());
    ASSERT_FALSE(rig.brake());
  }
  void expect_held(const char* when) {
    EXPECT_FALSE(rig.drive()) << when;
    EXPECT_TRUE(rig.brake()) << when;
  }

  Rig rig;

 private:
  struct Devices {
    typename Rig::Lock::Drive drive_enable;
    typename Rig::Lock::Brake brake;
    typename Rig::Lock::Stop emergency_stop;
  };

  Devices devices_{typename Rig::Lock::Drive(rig.interlock()),
                   typename Rig::Lock::Brake(rig.interlock()),
                   typename Rig::Lock::Stop(rig.interlock())};

 public:
  app::Safety<Devices> safety{devices_};
};

template <class Rig>
class EmergencyStopContract : public testing::Test {
 protected:
  EmergencyStopBench<Rig> bench_;
};

TYPED_TEST_SUITE_P(EmergencyStopContract);

TYPED_TEST_P(EmergencyStopContract, NothingIsLetGoWithoutAControlLoop) {
  this->bench_.start();
  for (int i = 0; i < 1'000; ++i) {
    this->bench_.safety.check();
  }
  this->bench_.expect_held("the application alone");
}

TYPED_TEST_P(EmergencyStopContract, NothingIsLetGoBeforeTheLoopRanInTime) {
  this->bench_.start();
  const auto in_time = [this](std::uint32_t periods) {
    for (std::uint32_t i = 0; i < periods; ++i) {
      this->bench_.rig.period(true);
    }
  };
  this->bench_.run_ms(1'000, false);
  this->bench_.expect_held("each period late");
  in_time(TypeParam::kPeriodsInTime - 1);
  this->bench_.expect_held("one short");
  this->bench_.rig.period(false);
  in_time(TypeParam::kPeriodsInTime - 1);
  this->bench_.expect_held("one short again after a late one");
  in_time(1);
  EXPECT_TRUE(this->bench_.rig.drive());
  EXPECT_FALSE(this->bench_.rig.brake());
  this->bench_.run_ms(10, false);
  EXPECT_TRUE(this->bench_.rig.drive()) << "a late period later is reported, not stopped for";
}

TYPED_TEST_P(EmergencyStopContract, AStopWhileTheApplicationWaitsIsNeverMissed) {
  constexpr std::uint32_t kWait_us = 40'000;
  for (std::uint32_t length_us = TypeParam::kShortest_us; length_us <= 25'000; length_us += 1'000) {
    for (const std::uint32_t begin_us : {1'000u, 9'000u, kWait_us - 1'000 - length_us}) {
      SCOPED_TRACE(testing::Message() << length_us << " us from " << begin_us << " us on");
      EmergencyStopBench<TypeParam> bench;
      bench.let_go();
      std::uint32_t now_us = 0;
      std::uint32_t off_us = 0;
      bench.rig.wait(kWait_us / TypeParam::kPeriod_us, [&] {
        now_us += TypeParam::kPeriod_us;
        off_us = off_us == 0 && !bench.rig.drive() ? now_us : off_us;
        if (now_us == begin_us || now_us == begin_us + length_us) {
          bench.rig.pull(now_us == begin_us);
        }
      });
      EXPECT_EQ(now_us, kWait_us);
      EXPECT_GT(off_us, begin_us);
      EXPECT_LE(off_us, begin_us + TypeParam::kOffWithin_us);
      bench.expect_held("before the application has looked");
      bench.safety.check();
      EXPECT_TRUE(bench.safety.pulled()) << "the application never heard of it";
      bench.run_ms(100);
      EXPECT_FALSE(bench.safety.pulled());
      EXPECT_TRUE(bench.safety.locked());
      bench.expect_held("until the next start");
    }
  }
}

TYPED_TEST_P(EmergencyStopContract, AStopThatIsPulledAtTheStartHolds) {
  this->bench_.rig.pull(true);
  this->bench_.run_ms(10);
  this->bench_.start();
  this->bench_.run_ms(100);
  this->bench_.expect_held("pulled");
  this->bench_.rig.pull(false);
  this->bench_.run_ms(100);
  this->bench_.expect_held("released");
}

TYPED_TEST_P(EmergencyStopContract, AStopThatCannotBeReadIsAStop) {
  this->bench_.let_go();
  if (!this->bench_.rig.break_stop()) {
    GTEST_SKIP() << "this back end cannot fail";
  }
  this->bench_.rig.period(true);
  this->bench_.expect_held("broken");
}

TYPED_TEST_P(EmergencyStopContract, TheDriveStaysOffWhileTheBrakeDoesNotOpen) {
  this->bench_.rig.break_brake(true);
  this->bench_.start();
  for (int i = 0; i < 100; ++i) {
    this->bench_.run_ms(1);
    ASSERT_FALSE(this->bench_.rig.drive()) << "after " << i << " ms";
  }
  for (int i = 0; i < 100; ++i) {
    this->bench_.run_ms(1);
    ASSERT_FALSE(this->bench_.safety.obeyed()) << "the watchdog would be fed";
  }
  this->bench_.rig.break_brake(false);
  this->bench_.run_ms(2);
  EXPECT_TRUE(this->bench_.rig.drive());
  EXPECT_TRUE(this->bench_.safety.obeyed());
}

REGISTER_TYPED_TEST_SUITE_P(EmergencyStopContract, NothingIsLetGoWithoutAControlLoop,
                            NothingIsLetGoBeforeTheLoopRanInTime,
                            AStopWhileTheApplicationWaitsIsNeverMissed,
                            AStopThatIsPulledAtTheStartHolds, AStopThatCannotBeReadIsAStop,
                            TheDriveStaysOffWhileTheBrakeDoesNotOpen);

}  // namespace hal_test
