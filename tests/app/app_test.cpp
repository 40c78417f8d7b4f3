#include "firmware/app/app.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rig.hpp"

namespace app {
namespace {

using protocol::EmergencyCode;
using protocol::LifeState;
using protocol::LifeStatus;
using protocol::NmtState;

bool reported(const Rig<>& rig, EmergencyCode code) {
  const auto all = rig.sent<protocol::Emergency>();
  return std::any_of(all.begin(), all.end(),
                     [code](const auto& emergency) { return emergency.code == code; });
}

/// A wire so strong that seconds of run() do about a millionth of its life.
constexpr double kStrong = 1.53e9;

TEST(App, SpeaksTheFramePlanAtItsRates) {
  Rig rig;
  rig.start();
  rig.idle(10'000);
  const auto beats = rig.sent<protocol::Heartbeat>();
  ASSERT_EQ(beats.size(), 11u);
  EXPECT_EQ(beats[0].state, NmtState::boot_up);
  EXPECT_EQ(beats[1].state, NmtState::operational);
  EXPECT_NEAR(static_cast<double>(rig.sent<LifeStatus>().size()), 100, 2);
  // A hundred pages in turns of one of each kind.
  EXPECT_NEAR(static_cast<double>(rig.sent<protocol::detail::Identity>().size()),
              100.0 / protocol::detail::kPages, 1);
  EXPECT_NEAR(static_cast<double>(rig.sent<protocol::detail::Bus>().size()),
              100.0 / protocol::detail::kPages, 1);
}

TEST(App, TellsTheDamageOfTheEstimator) {
  Rig rig;
  lifemodel::Estimator<1> alone({rig.models[0]->nominal});
  rig.start();
  for (int i = 0; i < 5'000; ++i) {
    const double tension_N = 30 + 25 * std::sin(i * 0.05);
    rig.step(tension_N);
    alone.push(0, lifemodel::pack::tension(tension_N, 177.4));
    alone.flush(0);
  }
  EXPECT_EQ(rig.app->stop(), hal::Error::none);
  EXPECT_EQ(rig.app->lives().damage(0), alone.reading(0).total);
  EXPECT_EQ(rig.store.load(0)->epoch_damage, alone.reading(0).total);
  EXPECT_EQ(rig.store.load(0)->epoch_cycles, alone.reading(0).closed_cycles.raw());
}

TEST(App, RatesAreToldOnceAMinuteWasSeen) {
  Rig<2> rig(kStrong);
  rig.models[1].reset();  // has no rate, and hides none
  rig.start();
  rig.run(59'000);
  for (const auto& page : rig.sent<protocol::detail::Cycles>()) {
    EXPECT_EQ(page.cycles_per_min, 0xffff);
  }
  for (const auto& page : rig.sent<protocol::detail::DamageRate>()) {
    EXPECT_EQ(page.ppb_per_h, 0xffffffffu);
  }
  rig.run(3'000);
  // A cycle of 20 ms.
  EXPECT_NEAR(rig.sent<protocol::detail::Cycles>().back().cycles_per_min, 3'000, 2);
  const double per_minute = static_cast<double>(rig.app->lives().damage_ppb(0)) * 60 / 62;
  EXPECT_NEAR(rig.sent<protocol::detail::DamageRate>().back().ppb_per_h, 60 * per_minute,
              0.01 * 60 * per_minute);
}

TEST(App, StatesFollowTheLife) {
  // So short a life that a few seconds use it: 20 ms a cycle, 50 cycles a second.
  Rig rig(2'000);
  rig.start();
  rig.run(4'000);
  const auto statuses = rig.sent<LifeStatus>();
  std::vector<LifeState> states;
  std::uint32_t before_ppb = 0;
  for (const LifeStatus& status : statuses) {
    EXPECT_GE(status.damage_ppb, before_ppb);
    before_ppb = status.damage_ppb;
    if (states.empty() || states.back() != status.state) {
      states.push_back(status.state);
    }
  }
  EXPECT_EQ(states, (std::vector{LifeState::normal, LifeState::inspect, LifeState::replace,
                                 LifeState::worn}));
  EXPECT_TRUE(reported(rig, EmergencyCode::life_inspect));
  EXPECT_TRUE(reported(rig, EmergencyCode::life_replace));
  EXPECT_TRUE(reported(rig, EmergencyCode::life_worn));
}

TEST(App, TheEmergencyStopDropsTheDriveUntilARestart) {
  Rig rig;
  rig.start();
  EXPECT_TRUE(rig.drive_enable.asserted());
  EXPECT_FALSE(rig.brake.asserted());
  rig.idle(500);
  rig.stop.set(true);
  rig.idle(2);
  EXPECT_FALSE(rig.drive_enable.asserted());
  EXPECT_TRUE(rig.brake.asserted());
  EXPECT_TRUE(reported(rig, EmergencyCode::emergency_stop));
  rig.stop.set(false);
  rig.idle(500);
  EXPECT_FALSE(rig.drive_enable.asserted());
  EXPECT_TRUE(rig.sent<LifeStatus>().back().locked);
  EXPECT_EQ(rig.sent<protocol::Emergency>().back().code, EmergencyCode::none);
  rig.start();
  EXPECT_TRUE(rig.drive_enable.asserted());
}

TEST(App, AnEmergencyStopThatCannotBeReadCountsAsPulled) {
  Rig rig;
  rig.start();
  rig.idle(10);
  rig.stop.faults.during(rig.clock.now(), hal::seconds(100), hal::Error::failed);
  rig.idle(2);
  EXPECT_FALSE(rig.drive_enable.asserted());
}

TEST(App, WhileTheDriveDoesNotObeyTheWatchdogIsNotFed) {
  Rig rig;
  rig.start();
  rig.idle(100);
  rig.drive_enable.faults.during(rig.clock.now(), hal::seconds(100), hal::Error::failed);
  rig.stop.set(true);
  rig.idle(1);
  const std::uint32_t feeds = rig.watchdog.feeds();
  rig.idle(600);
  EXPECT_EQ(rig.watchdog.feeds(), feeds);
  EXPECT_TRUE(rig.watchdog.bitten());
}

TEST(App, TheDriveStaysOffWhileTheBrakeDoesNotOpen) {
  Rig rig;
  rig.brake.faults.during({}, hal::milliseconds(100), hal::Error::failed);
  rig.start();
  rig.idle(90);
  EXPECT_EQ(rig.drive_enable.changes(), 0u);
  EXPECT_EQ(rig.watchdog.feeds(), 0u);
  rig.idle(20);
  EXPECT_FALSE(rig.brake.asserted());
  EXPECT_TRUE(rig.drive_enable.asserted());
}

TEST(App, ADriveThatFailsWhileItRunsIsNotFedFor) {
  Rig rig;
  rig.start();
  rig.idle(100);
  rig.drive_enable.faults.during(rig.clock.now(), hal::seconds(100), hal::Error::failed);
  const std::uint32_t feeds = rig.watchdog.feeds();
  rig.idle(10);
  EXPECT_EQ(rig.watchdog.feeds(), feeds) << "nobody has pulled the stop";
}

TEST(App, AControlLoopThatStandsStillIsNotFedFor) {
  Rig rig;
  rig.start();
  rig.idle(100);
  for (int i = 0; i < 1'000; ++i) {
    rig.clock.advance(hal::milliseconds(1));
    rig.app->poll();
  }
  EXPECT_TRUE(rig.watchdog.bitten());
}

TEST(App, ARestartGoesOnWhereTheLastSaveWas) {
  Rig rig(kStrong);
  rig.start();
  rig.run(130'000);
  ASSERT_GE(rig.store.saved_at.size(), 2u);
  const lifemodel::Damage saved = rig.store.load(0)->epoch_damage;
  const lifemodel::Damage known = rig.app->lives().damage(0);
  EXPECT_LE(saved, known);
  const std::uint32_t published_ppb =
      rig.sent<protocol::detail::Storage>().back().worst_unsaved_ppb;
  rig.start();
  EXPECT_EQ(rig.app->lives().damage(0), saved);
  EXPECT_LE(lifemodel::Damage::difference(known, saved).parts_per_billion(), published_ppb);
}

TEST(App, NoStatusIsFurtherAheadOfTheStoreThanWasPublished) {
  Rig rig(kStrong);
  rig.start();
  std::uint32_t published_ppb = 0;
  std::uint32_t most_ahead_ppb = 0;
  std::size_t seen = 0;
  for (int i = 0; i < 4'500; ++i) {
    rig.run(20);
    const auto record = rig.store.load(0);
    const std::uint32_t saved_ppb = record ? record->epoch_damage.parts_per_billion() : 0;
    for (; seen < rig.bus.sent().size(); ++seen) {
      const hal::CanFrame& frame = rig.bus.sent()[seen].frame;
      if (const auto page = protocol::decode<protocol::detail::Storage>(frame)) {
        published_ppb = page->worst_unsaved_ppb;
      }
      if (const auto status = protocol::decode<LifeStatus>(frame)) {
        if (status->damage_ppb > saved_ppb) {
          const std::uint32_t ahead_ppb = status->damage_ppb - saved_ppb;
          ASSERT_GE(published_ppb, ahead_ppb);
          most_ahead_ppb = std::max(most_ahead_ppb, ahead_ppb);
        }
      }
    }
  }
  EXPECT_GT(most_ahead_ppb, 100u);
}

TEST(App, ASaveThatFailsIsToldAndTheLifeGoesOn) {
  Rig rig;
  rig.store.faults.during({}, hal::seconds(150), hal::Error::failed);
  rig.start();
  rig.run(70'000);
  EXPECT_TRUE(reported(rig, EmergencyCode::storage));
  EXPECT_FALSE(rig.sent<LifeStatus>().back().storage_ok);
  EXPECT_GT(rig.sent<LifeStatus>().back().damage_ppb, 0u);
  rig.run(150'000);
  EXPECT_TRUE(rig.sent<LifeStatus>().back().storage_ok);
  EXPECT_TRUE(rig.store.load(0).has_value());
}

TEST(App, ALostRecordIsToldAndTheLifeIsUnknown) {
  Rig rig;
  rig.store.lost = true;
  rig.start();
  rig.idle(500);
  EXPECT_TRUE(reported(rig, EmergencyCode::record_damaged));
  EXPECT_EQ(rig.sent<LifeStatus>().back().state, LifeState::unknown);
  EXPECT_EQ(rig.sent<LifeStatus>().back().quality, protocol::Quality::untrusted);
}

TEST(App, ATendonWithoutParametersIsLeftOut) {
  Rig<2> rig;
  rig.models[1].reset();
  rig.start();
  rig.run(1'000);
  const auto all = rig.sent<protocol::Emergency>();
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.front().code, EmergencyCode::parameters);
  EXPECT_GT(rig.app->lives().damage(0), lifemodel::Damage{});
  EXPECT_EQ(rig.app->lives().damage(1), lifemodel::Damage{});
}

TEST(App, ASensorWithoutSamplesIsToldAndComesBack) {
  Rig rig;
  rig.start();
  rig.idle(100);
  rig.sensor.faults.during(rig.clock.now(), rig.clock.now() + hal::milliseconds(300),
                           hal::Error::failed);
  rig.idle(200);
  EXPECT_TRUE(reported(rig, EmergencyCode::sensor));
  EXPECT_FALSE(rig.sent<LifeStatus>().back().sensor_ok);
  rig.idle(400);
  EXPECT_TRUE(rig.sent<LifeStatus>().back().sensor_ok);
  EXPECT_TRUE(rig.sent<LifeStatus>().back().gap);
  EXPECT_EQ(rig.sent<LifeStatus>().back().quality, protocol::Quality::gaps);
}

TEST(App, MissedPeriodsAreGapsAndTold) {
  Rig rig;
  rig.start();
  rig.idle(100);
  rig.app->isr_missed(3);
  rig.idle(200);
  EXPECT_TRUE(reported(rig, EmergencyCode::deadline));
  EXPECT_TRUE(rig.sent<LifeStatus>().back().gap);
}

TEST(App, AnEmergencyOutlivesBusOff) {
  Rig rig;
  rig.start();
  rig.idle(300);
  rig.bus.forget();
  rig.can.go_off();
  rig.idle(5);
  rig.stop.set(true);
  rig.idle(50);
  EXPECT_TRUE(rig.bus.sent().empty());
  rig.idle(500);
  EXPECT_TRUE(reported(rig, EmergencyCode::bus));
  EXPECT_TRUE(reported(rig, EmergencyCode::emergency_stop));
  rig.idle(1'000);
  EXPECT_EQ(rig.sent<protocol::detail::Bus>().back().bus_offs, 1);
}

TEST(App, WhatWasToldJustBeforeBusOffIsToldAgain) {
  Rig rig;
  rig.start();
  rig.idle(300);
  rig.stop.set(true);
  rig.idle(2);
  ASSERT_TRUE(reported(rig, EmergencyCode::emergency_stop));
  rig.bus.forget();
  rig.can.go_off();
  rig.idle(1'000);
  EXPECT_TRUE(reported(rig, EmergencyCode::emergency_stop));
}

TEST(App, AFullQueueDropsDetailPagesAndCountsThem) {
  Rig rig;
  rig.start();
  rig.idle(300);
  rig.can.faults.during(rig.clock.now(), rig.clock.now() + hal::seconds(1),
                        hal::fake::SendFault::full);
  rig.stop.set(true);
  rig.idle(1'000);
  rig.idle(1'500);
  EXPECT_TRUE(reported(rig, EmergencyCode::emergency_stop));
  EXPECT_NEAR(rig.sent<protocol::detail::Bus>().back().dropped, 9, 2);
}

}  // namespace
}  // namespace app
