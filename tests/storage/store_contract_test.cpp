// What every store promises.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "firmware/storage/file_store.hpp"
#include "firmware/storage/store.hpp"
#include "tests/storage/folder.hpp"
#include "tests/storage/lives.hpp"
#include "tests/storage/memory_files.hpp"
#include "tests/storage/rig.hpp"

namespace storage_test {
namespace {

using hal::Error;
constexpr std::size_t kContractTendons = 2;

template <class GeometryT>
struct InFlash {
  using Store = StoreOn<GeometryT, kContractTendons>;
  Store open() { return Store(socket); }

  typename GeometryT::Flash flash;
  Socket<typename GeometryT::Flash> socket{flash};
};

struct InFiles {
  using Store = storage::FileStore<kContractTendons>;
  Store open() { return std::get<Store>(Store::open(folder.path())); }

  Folder folder;
};

struct InMemoryFiles {
  using Store = storage::FileStore<kContractTendons, MemoryCalls>;
  Store open() { return std::get<Store>(Store::open("/store", MemoryCalls(files))); }

  MemoryFiles files{"/store"};
};

template <class BenchT>
class StoreContract : public testing::Test {
 protected:
  using Store = typename BenchT::Store;
  static_assert(storage::Store<Store>);

  void SetUp() override { restart(); }
  void restart() {
    store_.reset();
    store_.emplace(bench_.open());
  }
  Store& store() { return *store_; }
  void save(std::uint32_t step) {
    ASSERT_EQ(store().save(records_of<kContractTendons>(step)), Error::none);
  }

  BenchT bench_;
  std::optional<Store> store_;
};

using Benches = testing::Types<InFlash<Large>, InFlash<Small>, InFiles, InMemoryFiles>;
class BenchName {
 public:
  template <class BenchT>
  static std::string GetName(int i) {
    constexpr const char* kNames[] = {"LargeFlash", "SmallFlash", "Files", "MemoryFiles"};
    return kNames[i];
  }
};
TYPED_TEST_SUITE(StoreContract, Benches, BenchName);

TYPED_TEST(StoreContract, ANewOneIsEmpty) {
  EXPECT_FALSE(this->store().load(0));
  EXPECT_FALSE(this->store().past_lost());
  EXPECT_EQ(this->store().sequence(), 0u);
  EXPECT_FALSE(this->store().load_parameters(0));
  EXPECT_FALSE(this->store().log(0));
}

TYPED_TEST(StoreContract, WhatIsSavedIsThereAtOnceAndAfterARestart) {
  for (std::uint32_t step = 0; step < 50; ++step) {
    this->save(step);
    for (std::size_t tendon = 0; tendon < kContractTendons; ++tendon) {
      ASSERT_TRUE(this->store().load(tendon));
      ASSERT_TRUE(same_life(*this->store().load(tendon), record_of(tendon, step)));
    }
    const auto before = this->store().load(1);
    this->restart();
    ASSERT_EQ(this->store().load(1), before);
    ASSERT_TRUE(same_life(*this->store().load(0), record_of(0, step)));
  }
}

TYPED_TEST(StoreContract, EachSaveHasItsSequence) {
  for (std::uint32_t step = 0; step < 20; ++step) {
    this->save(step);
    EXPECT_EQ(this->store().sequence(), step + 1);
    EXPECT_EQ(this->store().load(0)->sequence, step + 1);
    EXPECT_EQ(this->store().load(1)->sequence, step + 1);
    if (step % 4 == 3) {
      this->restart();
      EXPECT_EQ(this->store().sequence(), step + 1);
    }
  }
}

TYPED_TEST(StoreContract, TheSequenceAndTheLossOfTheCallerAreNotTaken) {
  auto records = records_of<kContractTendons>(1);
  records[0].sequence = 77;
  records[1].past_lost = true;
  ASSERT_EQ(this->store().save(records), Error::none);
  EXPECT_EQ(this->store().load(0)->sequence, 1u);
  EXPECT_FALSE(this->store().load(1)->past_lost);
  EXPECT_FALSE(this->store().past_lost());
}

TYPED_TEST(StoreContract, LifeDoesNotRunBack) {
  this->save(10);
  const auto before = this->store().load(1);
  EXPECT_EQ(this->store().save(records_of<kContractTendons>(9)), Error::out_of_range);
  EXPECT_EQ(this->store().save(records_of<1>(11)), Error::out_of_range);
  EXPECT_EQ(this->store().save({}), Error::out_of_range);
  auto swapped = records_of<kContractTendons>(11);
  std::swap(swapped[0], swapped[1]);
  EXPECT_EQ(this->store().save(swapped), Error::out_of_range);
  this->restart();
  EXPECT_EQ(this->store().load(1), before);
  EXPECT_EQ(this->store().sequence(), 1u);
  this->save(10);
  this->save(11);
}

TYPED_TEST(StoreContract, ANewWireStartsAtZeroAndTheLifetimeDoesNot) {
  this->save(10);
  auto records = records_of<kContractTendons>(11);
  records[1] = record_of(1, 11, 1, 11);
  ASSERT_EQ(this->store().save(records), Error::none);
  this->restart();
  EXPECT_EQ(this->store().load(1)->epoch, 1u);
  EXPECT_EQ(this->store().load(1)->epoch_damage.words()[2], 0u);
  EXPECT_EQ(this->store().load(1)->lifetime_damage, record_of(1, 11).lifetime_damage);
  EXPECT_EQ(this->store().save(records_of<kContractTendons>(12)), Error::out_of_range);
}

TYPED_TEST(StoreContract, ParametersAreThoseLastSaved) {
  ASSERT_EQ(this->store().save_parameters(0, block_of(0)), Error::none);
  EXPECT_EQ(this->store().load_parameters(0), block_of(0));
  EXPECT_FALSE(this->store().load_parameters(1));
  for (std::uint32_t i = 1; i < 30; ++i) {
    ASSERT_EQ(this->store().save_parameters(i % 2, block_of(i)), Error::none);
    this->restart();
    ASSERT_EQ(this->store().load_parameters(i % 2), block_of(i));
    ASSERT_EQ(this->store().load_parameters((i - 1) % 2), block_of(i - 1));
  }
  EXPECT_EQ(this->store().save_parameters(kContractTendons, block_of(1)), Error::out_of_range);
  EXPECT_FALSE(this->store().load_parameters(kContractTendons));
  EXPECT_FALSE(this->store().load(kContractTendons));
  EXPECT_FALSE(this->store().load(0));
}

TYPED_TEST(StoreContract, TheLogKeepsItsOrderAndNumbers) {
  for (std::uint32_t i = 0; i < 40; ++i) {
    ASSERT_EQ(this->store().append(entry_of(i)), Error::none);
    if (i % 7 == 0) {
      this->restart();
    }
  }
  for (std::uint32_t i = 0; i < 40; ++i) {
    auto expected = entry_of(i);
    expected.number = i;
    EXPECT_EQ(this->store().log(i), expected);
  }
  EXPECT_FALSE(this->store().log(40));
}

TYPED_TEST(StoreContract, LifeParametersAndLogDoNotMix) {
  this->save(1);
  ASSERT_EQ(this->store().save_parameters(1, block_of(7)), Error::none);
  ASSERT_EQ(this->store().append(entry_of(3)), Error::none);
  this->save(2);
  this->restart();
  EXPECT_TRUE(same_life(*this->store().load(0), record_of(0, 2)));
  EXPECT_EQ(this->store().load_parameters(1), block_of(7));
  EXPECT_EQ(this->store().log(0)->detail, entry_of(3).detail);
}

}  // namespace
}  // namespace storage_test
