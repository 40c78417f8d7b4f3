#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/app/rough/scenario.hpp"

namespace app {
namespace {

RC_GTEST_PROP(Faults, DoNotChangeWhatIsCounted, (const Roughness& rough)) {
  Scenario scenario(rough);
  scenario.run(3'000);
  scenario.rig.store.faults.clear();
  RC_ASSERT(scenario.rig.app->stop() == hal::Error::none);
  const auto expected = scenario.damage_beside();
  RC_ASSERT(scenario.rig.app->lives().damage(0) == expected);
  RC_ASSERT(scenario.rig.store.load(0)->lifetime_damage == expected);
  RC_ASSERT(scenario.rig.store.load(0)->epoch == 0);
}

RC_GTEST_PROP(Faults, DamageOnTheBusNeverFalls, (const Roughness& rough)) {
  Scenario scenario(rough);
  scenario.run(3'000);
  std::uint32_t last_ppb = 0;
  for (const auto& status : scenario.rig.sent<protocol::LifeStatus>()) {
    RC_ASSERT(status.damage_ppb >= last_ppb);
    last_ppb = status.damage_ppb;
  }
}

RC_GTEST_PROP(Faults, TheDriveIsOffFromTheStopOn, (const Roughness& rough)) {
  Scenario scenario(rough);
  bool stopped = false;
  for (int i = 0; i < 2'000; ++i) {
    scenario.run(1);
    stopped = stopped || *scenario.rig.stop.asserted();
    RC_ASSERT(scenario.rig.drive_enable.asserted() == !stopped);
    RC_ASSERT(scenario.rig.brake.asserted() == stopped);
  }
  RC_CLASSIFY(stopped);
}

RC_GTEST_PROP(Faults, TheControllerStaysAliveAndIsFedFor, (const Roughness& rough)) {
  Scenario scenario(rough);
  scenario.run(3'000);
  RC_ASSERT(!scenario.rig.watchdog.bitten());
}

RC_GTEST_PROP(Faults, APowerCutLosesNoMoreThanWasPublished, (Roughness rough)) {
  // What is unsaved has to fit into the 24 bits of its page, which stop: a tough wire, and no
  // overload, which takes a whole life.
  rough.highest_N = std::min(rough.highest_N, 170u);
  Scenario scenario(rough, 1e8);
  auto& rig = scenario.rig;
  for (int cut = 0; cut < 3; ++cut) {
    rig.bus.forget();
    scenario.run(1'000 + rough.seed % 1'500);
    const auto statuses = rig.sent<protocol::LifeStatus>();
    std::uint32_t published_ppb = 0;
    for (const auto& page : rig.sent<protocol::detail::Storage>()) {
      published_ppb = std::max(published_ppb, page.worst_unsaved_ppb);
    }
    scenario.restart();
    const std::uint32_t kept_ppb = rig.app->lives().damage_ppb(0);
    RC_ASSERT(published_ppb < 0xff'ffffu);
    if (!statuses.empty()) {
      RC_ASSERT(statuses.back().damage_ppb <= kept_ppb + published_ppb);
    }
  }
}

TEST(Faults, ABrokenEntropySourceOpensNothingAndStopsNothing) {
  Scenario scenario({.seed = 2, .requests_ppm = 200'000});
  scenario.rig.entropy.faults.during({}, hal::seconds(100), hal::Error::failed);
  scenario.run(5'000);
  EXPECT_EQ(scenario.rig.app->stop(), hal::Error::none);
  EXPECT_EQ(scenario.rig.store.load(0)->epoch, 0);
  EXPECT_FALSE(scenario.rig.watchdog.bitten());
}

}  // namespace
}  // namespace app
