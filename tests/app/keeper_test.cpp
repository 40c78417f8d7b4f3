#include "firmware/app/keeper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "ram_store.hpp"
#include "wire.hpp"

namespace app {
namespace {

using Records = std::array<storage::LifeRecord, 1>;

Records used(const lifemodel::Damage& damage) {
  Records records{};
  records[0].epoch_damage = damage;
  records[0].lifetime_damage = damage;
  return records;
}

// Its count stops at 4.294967295 lives: 70 * 500 / 8192 are 4.27 and 71 * 500 / 8192 are 4.33.
TEST(Keeper, HoweverMuchIsUnsavedTheNextMinuteSavesIt) {
  for (const std::uint32_t growth : {1u, 70u, 71u, 100u, 10'000u}) {
    hal::fake::Clock clock;
    RamStore store(clock);
    Keeper<1, RamStore> keeper(store);
    store.faults.during({}, hal::seconds(601), hal::Error::failed);
    keeper.start(clock.now(), used({}));
    std::uint32_t before_ppb = 0;
    for (std::uint32_t step = 1; step <= 600; ++step) {
      clock.advance(hal::seconds(1));
      const std::uint32_t share = std::min(step, 500u);
      keeper.keep(clock.now(), used(lives(growth * share, 13)), false);
      ASSERT_GE(keeper.unsaved_ppb(), before_ppb) << growth << " " << step;
      before_ppb = keeper.unsaved_ppb();
    }
    EXPECT_FALSE(keeper.ok());
    const Records records = used(lives(growth * 500, 13));
    for (std::uint32_t s = 0; s < 61; ++s) {
      clock.advance(hal::seconds(1));
      keeper.keep(clock.now(), records, false);
    }
    ASSERT_TRUE(keeper.ok()) << growth;
    ASSERT_TRUE(store.load(0)) << growth;
    EXPECT_EQ(store.load(0)->lifetime_damage, records[0].lifetime_damage) << growth;
    EXPECT_EQ(keeper.unsaved_ppb(), 0u);
  }
}

}  // namespace
}  // namespace app
