#include "firmware/storage/flash_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "firmware/storage/save_policy.hpp"
#include "hal/fake/random.hpp"
#include "tests/storage/lives.hpp"
#include "tests/storage/rig.hpp"

namespace storage_test {
namespace {

using hal::Error;
using hal::fake::BadPage;
using hal::fake::FlashFault;

template <class Geometry, std::size_t kTendons>
class Rig {
 public:
  using Store = StoreOn<Geometry, kTendons>;

  Store start() { return Store(socket); }

  typename Geometry::Flash flash;
  Socket<typename Geometry::Flash> socket{flash};
};

/// Where record `n` of a blank store with one tendon lies.
template <class Geometry>
constexpr std::uint32_t slot_address(std::uint32_t n) {
  constexpr auto kPage = static_cast<std::uint32_t>(Geometry::Flash::kPageBytes);
  return n / (kPage / 88) * kPage + n % (kPage / 88) * 88;
}

TEST(FlashStore, BlankHoldsNothingAndHasLostNothing) {
  Rig<Large, 2> rig;
  auto store = rig.start();
  EXPECT_FALSE(store.load(0));
  EXPECT_FALSE(store.load(2));
  EXPECT_FALSE(store.past_lost());
  EXPECT_EQ(store.sequence(), 0u);
  EXPECT_FALSE(store.load_parameters(1));
  EXPECT_FALSE(store.load_parameters(2));
  EXPECT_FALSE(store.log(0));
  EXPECT_EQ(rig.flash.operations(), 0u);
}

TEST(FlashStore, ARecordIsElevenUnitsWithTheCrcLast) {
  Rig<Large, 1> rig;
  auto store = rig.start();
  ASSERT_EQ(store.save(records_of<1>(1)), Error::none);
  EXPECT_EQ(rig.flash.operations(), 11u);
  for (std::uint64_t last = 0; last < 11; ++last) {
    Rig<Large, 1> cut;
    cut.flash.fault(last, {FlashFault::Kind::cut_after});
    auto first = cut.start();
    (void)first.save(records_of<1>(1));
    cut.flash.power_on();
    EXPECT_EQ(cut.start().load(0).has_value(), last == 10) << last;
    const auto crc_unit = cut.flash.content().subspan(80, 8);
    const bool blank = std::ranges::count(crc_unit, std::byte{0xff}) == 8;
    EXPECT_EQ(blank, last != 10) << last;
  }
}

TEST(FlashStore, RefusesWhatMayNotFollowAndWritesNothing) {
  Rig<Large, 2> rig;
  auto store = rig.start();
  ASSERT_EQ(store.save(records_of<2>(10)), Error::none);
  const auto before = rig.flash.operations();
  EXPECT_EQ(store.save(records_of<2>(9)), Error::out_of_range);
  EXPECT_EQ(store.save(records_of<1>(11)), Error::out_of_range);
  auto swapped = records_of<2>(11);
  std::swap(swapped[0], swapped[1]);
  EXPECT_EQ(store.save(swapped), Error::out_of_range);
  auto one_falls = records_of<2>(11);
  one_falls[1] = record_of(1, 9);
  EXPECT_EQ(store.save(one_falls), Error::out_of_range);
  auto implausible = records_of<2>(11);
  implausible[0].flags = 0x80;
  EXPECT_EQ(store.save(implausible), Error::out_of_range);
  EXPECT_EQ(rig.flash.operations(), before);
  EXPECT_TRUE(store.healthy());
  EXPECT_EQ(store.sequence(), 1u);
  EXPECT_EQ(store.save_parameters(2, block_of(1)), Error::out_of_range);
}

TEST(FlashStore, ARottenRecordGivesWayToTheOneBefore) {
  for (const bool noticed : {false, true}) {
    Rig<Large, 1> rig;
    auto store = rig.start();
    for (std::uint32_t step = 0; step < 40; ++step) {
      ASSERT_EQ(store.save(records_of<1>(step)), Error::none);
    }
    const std::uint32_t newest = slot_address<Large>(39);
    noticed ? rig.flash.spoil(newest + 40) : rig.flash.flip(newest + 40, 3);
    auto next = rig.start();
    ASSERT_TRUE(next.load(0));
    EXPECT_TRUE(same_life(*next.load(0), record_of(0, 38)));
    EXPECT_FALSE(next.past_lost());
    // The number of the lost one is not used again.
    ASSERT_EQ(next.save(records_of<1>(41)), Error::none);
    EXPECT_EQ(next.sequence(), 41u);
  }
}

TEST(FlashStore, ALossIsRememberedUntilTheNextWire) {
  Rig<Large, 2> rig;
  {
    auto store = rig.start();
    for (std::uint32_t step = 0; step < 5; ++step) {
      ASSERT_EQ(store.save(records_of<2>(step)), Error::none);
    }
    for (std::uint32_t n = 1; n < 10; n += 2) {
      rig.flash.flip(slot_address<Large>(n) + 30, 0);  // all of tendon 1
    }
  }
  {
    auto store = rig.start();
    EXPECT_TRUE(store.load(0));
    EXPECT_FALSE(store.load(1));
    EXPECT_TRUE(store.past_lost());
    ASSERT_EQ(store.save(records_of<2>(10)), Error::none);
    EXPECT_TRUE(store.past_lost());
  }
  {
    auto store = rig.start();
    EXPECT_TRUE(store.past_lost());
    EXPECT_FALSE(store.load(0)->past_lost);
    EXPECT_TRUE(store.load(1)->past_lost);
    auto records = records_of<2>(11);
    records[1] = record_of(1, 11, 1, 11);
    ASSERT_EQ(store.save(records), Error::none);
    EXPECT_FALSE(store.past_lost());
  }
  EXPECT_FALSE(rig.start().past_lost());
}

TEST(FlashStore, AFirstSaveThatWasCutIsNoLoss) {
  for (std::uint64_t operation = 0; operation < 16; ++operation) {
    Rig<Large, 2> rig;
    rig.flash.fault(operation, {FlashFault::Kind::cut_torn});
    auto store = rig.start();
    EXPECT_EQ(store.save(records_of<2>(1)), Error::failed);
    rig.flash.power_on();
    EXPECT_FALSE(rig.start().past_lost()) << operation;
  }
}

TEST(FlashStore, GarbageIsALossAndDoesNotStandInTheWay) {
  hal::fake::Random random(3);
  Rig<Large, 2> rig;
  std::vector<std::byte> image(Large::Flash::kBytes);
  std::ranges::generate(image, [&] { return static_cast<std::byte>(random.next()); });
  rig.flash.load(image);
  auto store = rig.start();
  EXPECT_FALSE(store.load(0));
  EXPECT_TRUE(store.past_lost());
  EXPECT_FALSE(store.load_parameters(0));
  EXPECT_FALSE(store.log(0));
  EXPECT_EQ(store.save(records_of<2>(1)), Error::none);
  EXPECT_EQ(store.save_parameters(0, block_of(1)), Error::none);
  EXPECT_EQ(store.append(entry_of(1)), Error::full);
  auto next = rig.start();
  EXPECT_TRUE(same_life(*next.load(1), record_of(1, 1)));
  EXPECT_TRUE(next.past_lost());
  EXPECT_EQ(next.load_parameters(0), block_of(1));
}

TEST(FlashStore, TheSequenceDoesNotWrap) {
  Rig<Large, 1> rig;
  auto record = record_of(0, 1);
  record.sequence = 0xffff'fffe;
  const auto bytes = storage::encode(record);
  for (std::uint32_t at = 0; at < 88; at += 8) {
    ASSERT_EQ(rig.flash.program(at, std::span(bytes).subspan(at, 8)), Error::none);
  }
  auto store = rig.start();
  EXPECT_EQ(store.sequence(), 0xffff'fffe);
  EXPECT_EQ(store.save(records_of<1>(2)), Error::none);
  EXPECT_EQ(store.sequence(), 0xffff'ffff);
  EXPECT_EQ(store.save(records_of<1>(3)), Error::full);
  EXPECT_TRUE(same_life(*rig.start().load(0), record_of(0, 2)));
}

TEST(FlashStore, TheLogFillsUpAndKeepsItsFirst) {
  Rig<Large, 1> rig;
  auto store = rig.start();
  constexpr std::uint32_t kRoom = 2 * (2'048 / 24);
  for (std::uint32_t i = 0; i < kRoom; ++i) {
    ASSERT_EQ(store.append(entry_of(i)), Error::none) << i;
  }
  const auto full = rig.flash;
  EXPECT_EQ(store.append(entry_of(999)), Error::full);
  EXPECT_TRUE(std::ranges::equal(full.content(), rig.flash.content()));
  auto next = rig.start();
  EXPECT_EQ(next.append(entry_of(999)), Error::full);
  for (std::uint32_t i = 0; i < kRoom; ++i) {
    auto expected = entry_of(i);
    expected.number = i;
    ASSERT_EQ(next.log(i), expected) << i;
  }
  EXPECT_FALSE(next.log(kRoom));
}

TEST(FlashStore, ARottenEntryIsPassedOver) {
  Rig<Large, 1> rig;
  auto store = rig.start();
  for (std::uint32_t i = 0; i < 5; ++i) {
    ASSERT_EQ(store.append(entry_of(i)), Error::none);
  }
  rig.flash.flip(18 * 2'048 + 2 * 24 + 5, 2);
  auto next = rig.start();
  EXPECT_EQ(next.log(1)->number, 1u);
  EXPECT_EQ(next.log(2)->number, 3u);
  EXPECT_EQ(next.log(3)->number, 4u);
  EXPECT_FALSE(next.log(4));
}

template <class Geometry, std::size_t kTendons>
std::uint64_t erases(const Rig<Geometry, kTendons>& rig) {
  std::uint64_t sum = 0;
  for (std::uint32_t page = 0; page < 20; ++page) {
    sum += rig.flash.erases(page);
  }
  return sum;
}

TEST(FlashStore, ASaveErasesAtMostOnePage) {
  Rig<LargeNominal, 4> rig;
  auto store = rig.start();
  for (std::uint32_t step = 0; step < 1'000; ++step) {
    const auto before = erases(rig);
    ASSERT_EQ(store.save(records_of<4>(step)), Error::none);
    ASSERT_LE(erases(rig) - before, 1u);
  }
}

TEST(FlashStore, ASaveErasesNothingAfterPrepare) {
  Rig<LargeNominal, 4> rig;
  auto store = rig.start();
  for (std::uint32_t step = 0; step < 1'000; ++step) {
    const auto idle = erases(rig);
    ASSERT_EQ(store.prepare(), Error::none);
    const auto before = erases(rig);
    ASSERT_LE(before - idle, 1u);
    ASSERT_EQ(store.save(records_of<4>(step)), Error::none);
    ASSERT_EQ(erases(rig), before) << step;
  }
  EXPECT_GT(erases(rig), 100u);
}

// What is computed in Wear is what the flash sees.
TEST(FlashStore, WearsAllPagesTheSame) {
  for (const bool prepared : {false, true}) {
    Rig<Large, 1> rig;
    auto store = rig.start();
    constexpr std::uint32_t kSaves = 20'000;
    for (std::uint32_t step = 0; step < kSaves; ++step) {
      ASSERT_EQ(store.save(records_of<1>(step)), Error::none);
      if (prepared) {
        ASSERT_EQ(store.prepare(), Error::none);
      }
    }
    std::uint32_t least = ~0u;
    std::uint32_t most = 0;
    for (std::uint32_t page = 0; page < 16; ++page) {
      least = std::min(least, rig.flash.erases(page));
      most = std::max(most, rig.flash.erases(page));
    }
    EXPECT_LE(most - least, 1u);
    constexpr storage::Wear kOneErase{.erases = 1};
    EXPECT_EQ(most, kSaves / kOneErase.writes());
    for (std::uint32_t page = 16; page < 20; ++page) {
      EXPECT_EQ(rig.flash.erases(page), 0u);
    }
  }
}

TEST(FlashStore, PrepareTellsOfAPageThatCannotBeErasedAndTakesTheNext) {
  for (const BadPage how : {BadPage::erase_fails, BadPage::keeps_bits}) {
    Rig<Small, 1> rig;
    auto store = rig.start();
    for (std::uint32_t step = 0; step < 35; ++step) {
      ASSERT_EQ(store.save(records_of<1>(step)), Error::none);
    }
    rig.flash.make_bad(0, how);  // comes next
    EXPECT_EQ(store.prepare(), Error::failed);
    EXPECT_EQ(store.prepare(), Error::none);
    EXPECT_EQ(rig.flash.erases(1), 1u);
    const auto operations = rig.flash.operations();
    EXPECT_EQ(store.prepare(), Error::none);
    EXPECT_EQ(rig.flash.operations(), operations);
  }
}

// Each page fails once, and all are still good.
TEST(FlashStore, PassingFailuresDoNotAddUp) {
  Rig<Small, 2> rig;
  auto store = rig.start();
  for (std::uint32_t step = 0; step < 300; ++step) {
    if (step % 13 == 12) {
      rig.flash.fault(rig.flash.operations() + 3, {FlashFault::Kind::refuse});
    }
    ASSERT_EQ(store.save(records_of<2>(step)), Error::none) << step;
  }
}

/// Of four pages those whose bit is set are bad, from the start or from some save on.
class BadPages : public testing::TestWithParam<BadPage> {
 protected:
  static void make_bad(Rig<Small, 2>& rig, unsigned bad) {
    for (std::uint32_t page = 0; page < 4; ++page) {
      if ((bad & (1u << page)) != 0) {
        rig.flash.make_bad(page, GetParam());
      }
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Ways, BadPages,
                         testing::Values(BadPage::erase_fails, BadPage::keeps_bits,
                                         BadPage::program_fails));

TEST_P(BadPages, TwoGoodOnesAreEnough) {
  for (unsigned bad = 0; bad < 15; ++bad) {
    if (__builtin_popcount(bad) > 2) {
      continue;
    }
    for (std::uint32_t from = 0; from < 60; ++from) {
      Rig<Small, 2> rig;
      auto store = rig.start();
      for (std::uint32_t step = 0; step < 120; ++step) {
        if (step == from) {
          make_bad(rig, bad);
        }
        if (step % 3 == 0) {
          (void)store.prepare();
        }
        ASSERT_EQ(store.save(records_of<2>(step)), Error::none)
            << "bad " << bad << " from " << from << " step " << step;
      }
      auto next = rig.start();
      ASSERT_TRUE(same_life(*next.load(0), record_of(0, 119)));
      ASSERT_TRUE(same_life(*next.load(1), record_of(1, 119)));
      ASSERT_FALSE(next.past_lost());
    }
  }
}

TEST_P(BadPages, WithFewerTheLastSaveStays) {
  for (unsigned bad = 1; bad < 16; ++bad) {
    for (std::uint32_t from = 1; from < 60; ++from) {
      Rig<Small, 2> rig;
      auto store = rig.start();
      std::array<std::uint32_t, 2> last{};
      bool failed = false;
      for (std::uint32_t step = 0; step < 120; ++step) {
        if (step == from) {
          make_bad(rig, bad);
        }
        const Error error = store.save(records_of<2>(step));
        failed = failed || error != Error::none;
        ASSERT_EQ(store.healthy(), error == Error::none);
        for (std::size_t tendon = 0; tendon < 2; ++tendon) {
          ASSERT_TRUE(store.load(tendon));
          const bool written = same_life(*store.load(tendon), record_of(tendon, step));
          ASSERT_TRUE(written || error != Error::none);
          ASSERT_TRUE(written || same_life(*store.load(tendon), record_of(tendon, last[tendon])));
          last[tendon] = written ? step : last[tendon];
        }
      }
      ASSERT_EQ(failed, bad == 15 || __builtin_popcount(bad) == 3) << bad << " from " << from;
      const auto next = rig.start();
      ASSERT_EQ(next.load(0), store.load(0));
      ASSERT_EQ(next.load(1), store.load(1));
    }
  }
}

TEST(FlashStore, ParametersOfOneTendonSurviveThoseOfTheOthers) {
  Rig<Small, 4> rig;
  auto store = rig.start();
  ASSERT_EQ(store.save_parameters(2, block_of(200)), Error::none);
  for (std::uint32_t i = 0; i < 100; ++i) {
    ASSERT_EQ(store.save_parameters(i % 2, block_of(i)), Error::none);
    if (i % 9 == 0) {
      store = rig.start();
    }
    ASSERT_EQ(store.load_parameters(2), block_of(200)) << i;
  }
  auto next = rig.start();
  EXPECT_EQ(next.load_parameters(0), block_of(98));
  EXPECT_EQ(next.load_parameters(1), block_of(99));
  EXPECT_EQ(next.load_parameters(2), block_of(200));
  EXPECT_FALSE(next.load_parameters(3));
}

TEST(FlashStore, ABlockThatWasCutIsToldAndTheOneBeforeStays) {
  using hal::fake::FlashFault;
  Rig<Large, 1> rig;
  auto store = rig.start();
  EXPECT_FALSE(store.parameters_torn(0));
  constexpr std::size_t kMost = lifemodel::kMostExtendedBytes;
  for (std::uint32_t i = 1; i < 12; ++i) {
    const auto last = store.load_parameters(0);
    // In the middle of its 80 double words; an erase may come before them.
    rig.flash.fault(rig.flash.operations() + 40, {FlashFault::Kind::cut_torn, i});
    EXPECT_NE(store.save_parameters(0, block_of(i, kMost)), Error::none);
    rig.flash.power_on();
    store = rig.start();
    EXPECT_TRUE(store.parameters_torn(0)) << i;
    EXPECT_EQ(store.load_parameters(0), last) << i;
    EXPECT_FALSE(store.past_lost());
    ASSERT_EQ(store.save_parameters(0, block_of(100 + i, i % 2 == 0 ? kMost : 84)), Error::none);
    EXPECT_FALSE(store.parameters_torn(0)) << i;
    store = rig.start();
    EXPECT_FALSE(store.parameters_torn(0)) << i;
    EXPECT_EQ(store.load_parameters(0), block_of(100 + i, i % 2 == 0 ? kMost : 84)) << i;
  }
}

TEST(FlashStore, ABlockLargerThanItsRoomIsRefused) {
  Rig<LargeNominal, 1> rig;
  auto store = rig.start();
  EXPECT_EQ(store.save_parameters(0, block_of(1, 85)), Error::out_of_range);
  EXPECT_EQ(store.save_parameters(0, block_of(1, 84)), Error::none);
  EXPECT_EQ(store.load_parameters(0), block_of(1, 84));
}

// What firmware with records of schema 1 and blocks of schema 2 left.
template <class Geometry, std::size_t kTendons>
class FormerStore {
 public:
  using Memory = Socket<typename Geometry::Flash>;
  using BlockSlot = storage::ParameterSlot<Geometry::kLayout.largest_block>;

  explicit FormerStore(Memory& memory) : life_(memory), parameters_(memory) {}

  void save(std::uint32_t step) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      auto record = record_of(tendon, step);
      record.sequence = step;
      ASSERT_EQ(life_.append(former_bytes(record)), Error::none);
    }
  }
  void save_parameters(std::uint32_t tendon, std::uint32_t number, std::size_t size) {
    const storage::SlotName name{tendon, number};
    ASSERT_EQ(parameters_.append(BlockSlot::Former::make(name, block_of(number, size).bytes())),
              Error::none);
  }

 private:
  storage::NewestLog<Memory, storage::RecordSlot::Former, kTendons, Geometry::kLayout.life> life_;
  storage::NewestLog<Memory, typename BlockSlot::Former, kTendons, Geometry::kLayout.parameters>
      parameters_;
};

storage::LifeRecord without_history(storage::LifeRecord record) {
  record.history = {};
  return record;
}

template <class Geometry, std::size_t kTendons>
void expect_life(typename Rig<Geometry, kTendons>::Store& store, std::uint32_t step,
                 const char* what) {
  EXPECT_FALSE(store.past_lost()) << what;
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    ASSERT_TRUE(store.load(tendon)) << what;
    EXPECT_TRUE(same_life(*store.load(tendon), without_history(record_of(tendon, step)))) << what;
  }
}

template <class Geometry, std::size_t kTendons>
void update_after(std::uint32_t former_saves) {
  SCOPED_TRACE(former_saves);
  Rig<Geometry, kTendons> rig;
  {
    FormerStore<Geometry, kTendons> former(rig.socket);
    for (std::uint32_t step = 1; step <= former_saves; ++step) {
      former.save(step);
    }
  }
  auto store = rig.start();
  EXPECT_EQ(store.sequence(), former_saves);
  expect_life<Geometry, kTendons>(store, former_saves, "at the first start");
  // Enough to go around all pages.
  for (std::uint32_t step = former_saves + 1; step < former_saves + 400; ++step) {
    ASSERT_EQ(store.save(records_of<kTendons>(step)), Error::none) << step;
    store = rig.start();
    ASSERT_EQ(store.sequence(), step);
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      ASSERT_TRUE(same_life(*store.load(tendon), record_of(tendon, step))) << step;
    }
    ASSERT_FALSE(store.past_lost());
    (void)store.prepare();
  }
  EXPECT_EQ(rig.flash.overwrites(), 0u);
}

TEST(FlashStore, AnUpdateKeepsTheLife) {
  for (const std::uint32_t saves : {1u, 2u, 12u, 13u, 14u, 25u, 26u, 51u, 52u, 53u, 100u}) {
    update_after<Small, 1>(saves);
    update_after<Small, 2>(saves);
    update_after<Tiny, 2>(saves);
  }
  update_after<Large, 1>(31);
  update_after<Large, 1>(600);
}

/// At each operation of the first saves after the update.
template <std::size_t kTendons>
void cut_after(std::uint32_t former_saves) {
  Rig<Small, kTendons> former;
  {
    FormerStore<Small, kTendons> store(former.socket);
    for (std::uint32_t step = 1; step <= former_saves; ++step) {
      store.save(step);
    }
  }
  using Kind = FlashFault::Kind;
  for (std::uint64_t operation = 0;; ++operation) {
    for (const Kind kind : {Kind::cut_before, Kind::cut_torn, Kind::cut_after}) {
      Rig<Small, kTendons> rig;
      rig.flash.load(former.flash.content());
      rig.flash.fault(operation, {kind, static_cast<std::uint32_t>(operation)});
      std::uint32_t saved = former_saves;
      {
        auto store = rig.start();
        while (saved < former_saves + 3 &&
               store.save(records_of<kTendons>(saved + 1)) == Error::none) {
          ++saved;
        }
      }
      const bool reached = rig.flash.operations() > operation;
      if (!reached) {
        return;
      }
      rig.flash.power_on();
      auto store = rig.start();
      ASSERT_FALSE(store.past_lost()) << former_saves << ' ' << operation;
      for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
        const auto life = store.load(tendon);
        ASSERT_TRUE(life) << former_saves << ' ' << operation;
        const auto before = saved == former_saves ? without_history(record_of(tendon, saved))
                                                  : record_of(tendon, saved);
        ASSERT_TRUE(same_life(*life, before) || same_life(*life, record_of(tendon, saved + 1)))
            << former_saves << ' ' << operation;
      }
      ASSERT_EQ(store.save(records_of<kTendons>(saved + 2)), Error::none);
      auto next = rig.start();
      ASSERT_TRUE(same_life(*next.load(0), record_of(0, saved + 2)));
    }
  }
}

TEST(FlashStore, APowerCutInTheFirstSavesAfterAnUpdateLosesNothing) {
  for (const std::uint32_t saves : {1u, 5u, 12u, 13u, 26u, 51u, 52u, 60u}) {
    cut_after<1>(saves);
    cut_after<2>(saves);
  }
}

TEST(FlashStore, AnUpdateKeepsTheParameters) {
  Rig<Large, 2> rig;
  {
    FormerStore<Large, 2> former(rig.socket);
    former.save_parameters(0, 1, 572);
    former.save_parameters(1, 2, 84);
    former.save_parameters(0, 3, 100);
    former.save_parameters(1, 4, 90);
  }
  auto store = rig.start();
  EXPECT_FALSE(store.parameters_torn(0));
  EXPECT_EQ(store.load_parameters(0), block_of(3, 100));
  EXPECT_EQ(store.load_parameters(1), block_of(4, 90));
  for (std::uint32_t i = 10; i < 30; ++i) {
    ASSERT_EQ(store.save_parameters(1, block_of(i, 616)), Error::none);
    store = rig.start();
    EXPECT_EQ(store.load_parameters(0), block_of(3, 100));
    EXPECT_EQ(store.load_parameters(1), block_of(i, 616));
  }
  EXPECT_FALSE(store.parameters_torn(0));
}

struct Unit4 {
  using Flash = hal::fake::Flash<6, 512, 4>;
  static constexpr storage::FlashLayout kLayout{{0, 2}, {2, 2}, {4, 2}, lifemodel::kBlockBytes};
};
struct Unit16 {
  using Flash = hal::fake::Flash<6, 512, 16>;
  static constexpr storage::FlashLayout kLayout{{4, 2}, {0, 2}, {2, 2}, lifemodel::kBlockBytes};
};
struct Unit32 {
  using Flash = hal::fake::Flash<6, 1'024, 32>;
  static constexpr storage::FlashLayout kLayout{{0, 2}, {2, 2}, {4, 2}, lifemodel::kBlockBytes};
};
template <class GeometryT>
class Units : public testing::Test {};
using Geometries = testing::Types<Unit4, Unit16, Unit32>;
TYPED_TEST_SUITE(Units, Geometries);

TYPED_TEST(Units, OfOtherFlash) {
  Rig<TypeParam, 2> rig;
  for (std::uint32_t step = 0; step < 100; ++step) {
    auto store = rig.start();
    ASSERT_EQ(store.save(records_of<2>(step)), Error::none) << step;
    ASSERT_EQ(store.save_parameters(step % 2, block_of(step)), Error::none) << step;
    if (step < 20) {
      ASSERT_EQ(store.append(entry_of(step)), Error::none) << step;
    }
  }
  auto store = rig.start();
  EXPECT_TRUE(same_life(*store.load(0), record_of(0, 99)));
  EXPECT_EQ(store.load_parameters(0), block_of(98));
  EXPECT_EQ(store.load_parameters(1), block_of(99));
  EXPECT_EQ(store.log(19)->detail, entry_of(19).detail);
  EXPECT_EQ(rig.flash.overwrites(), 0u);
}

}  // namespace
}  // namespace storage_test
