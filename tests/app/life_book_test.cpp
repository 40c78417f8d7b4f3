#include "firmware/app/life_book.hpp"

#include <gtest/gtest.h>

#include "wire.hpp"

namespace app {
namespace {

using lifemodel::Flag;

lifemodel::Reading reading(lifemodel::Damage total, std::uint64_t cycles) {
  lifemodel::Reading result;
  result.total = total;
  result.closed_cycles = lifemodel::Cycles::from_raw(cycles);
  return result;
}

storage::LifeRecord stored() {
  storage::LifeRecord record;
  record.sequence = 7;
  record.epoch = 2;
  record.epoch_damage = lives(4, 5);      // 4/32
  record.lifetime_damage = lives(20, 5);  // 20/32
  record.epoch_cycles = 100;
  return record;
}
const storage::LifeRecord kStored = stored();

TEST(TendonLife, AddsWhatIsCountedToWhatWasStored) {
  TendonLife life;
  life.resume(&kStored, false, 1, 0xabcd);
  life.take(reading(lives(3, 5), 30));
  const storage::LifeRecord now = life.record();
  EXPECT_EQ(now.tendon, 1);
  EXPECT_EQ(now.epoch, 2);
  EXPECT_EQ(now.configuration, 0xabcdu);
  EXPECT_EQ(now.epoch_damage, lives(7, 5));
  EXPECT_EQ(now.lifetime_damage, lives(23, 5));
  EXPECT_EQ(now.epoch_cycles, 130u);
}

TEST(TendonLife, BeginsAtNothingWithoutARecord) {
  TendonLife life;
  life.resume(nullptr, false, 0, 1);
  EXPECT_EQ(life.damage(), lifemodel::Damage{});
  EXPECT_EQ(life.record().epoch, 0);
}

TEST(TendonLife, ANewEpochBeginsAtNothingAndTheLifetimeGoesOn) {
  TendonLife life;
  life.resume(&kStored, false, 0, 1);
  lifemodel::Reading before = reading(lives(3, 5), 30);
  before.flags.raise(Flag::overload);
  life.take(before);
  const storage::LifeRecord next = life.next_epoch();
  EXPECT_EQ(next.epoch, 3);
  EXPECT_EQ(next.epoch_damage, lifemodel::Damage{});
  EXPECT_EQ(next.epoch_cycles, 0u);
  EXPECT_EQ(next.flags, 0);
  EXPECT_EQ(next.lifetime_damage, lives(23, 5));

  life.open(next);
  EXPECT_EQ(life.record(), next);
  life.take(reading(lives(5, 5), 33));
  EXPECT_EQ(life.record().epoch_damage, lives(2, 5));
  EXPECT_EQ(life.record().lifetime_damage, lives(25, 5));
  EXPECT_EQ(life.record().epoch_cycles, 3u);
}

TEST(TendonLife, FlagsStayOverARestart) {
  storage::LifeRecord record = stored();
  record.flags = static_cast<std::uint8_t>(Flag::gap);
  TendonLife life;
  life.resume(&record, false, 0, 1);
  lifemodel::Reading now = reading({}, 0);
  now.flags.raise(Flag::overrun);
  life.take(now);
  EXPECT_TRUE(life.flags().has(Flag::gap));
  EXPECT_TRUE(life.flags().has(Flag::overrun));
  EXPECT_FALSE(life.flags().has(Flag::overload));
}

}  // namespace
}  // namespace app
