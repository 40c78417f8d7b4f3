// Fails and cuts every system call of a file store on a disk that loses what was not synced.
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdint>
#include <variant>

#include "firmware/storage/file_store.hpp"
#include "tests/storage/memory_files.hpp"
#include "tests/storage/model.hpp"

namespace storage_test {
namespace {

constexpr std::size_t kTendons = 2;
constexpr std::uint32_t kSteps = 40;
using MemoryStore = storage::FileStore<kTendons, MemoryCalls>;
using Expected = Model<kTendons>;
using Fault = MemoryFiles::Fault;

#ifdef TENDONLIFE_SANITIZED
constexpr std::uint64_t kSeeds = 4;
#else
constexpr std::uint64_t kSeeds = 16;
#endif

/// A store that has made some steps, and what it must hold.
struct Life {
  explicit Life(std::uint32_t steps) {
    auto opened = MemoryStore::open("/store", MemoryCalls(files));
    MemoryStore& store = std::get<MemoryStore>(opened);
    for (std::uint32_t i = 0; i < steps; ++i) {
      EXPECT_EQ(expected.call(store, i), hal::Error::none);
    }
  }

  /// Opens it anew, makes a step and gives how many calls were made up to then.
  hal::Error step(std::uint32_t i) {
    auto opened = MemoryStore::open("/store", MemoryCalls(files));
    if (MemoryStore* store = std::get_if<MemoryStore>(&opened)) {
      return expected.call(*store, i);
    }
    return hal::Error::failed;
  }

  void check_and_continue(std::uint32_t from) {
    {
      auto opened = MemoryStore::open("/store", MemoryCalls(files));
      ASSERT_TRUE(std::holds_alternative<MemoryStore>(opened))
          << to_string(std::get<storage::FileError>(opened));
      MemoryStore& store = std::get<MemoryStore>(opened);
      expected.check(store);
      for (std::uint32_t i = from; i < from + 10; ++i) {
        ASSERT_EQ(expected.call(store, i), hal::Error::none);
      }
    }
    auto again = MemoryStore::open("/store", MemoryCalls(files));
    expected.check(std::get<MemoryStore>(again));
    ASSERT_FALSE(std::get<MemoryStore>(again).past_lost());
    ASSERT_TRUE(std::get<MemoryStore>(again).notices().empty());
  }

  MemoryFiles files{"/store"};
  Expected expected;
};

/// Calls that opening and a step take, all of them.
std::uint64_t calls_of(const Life& life, std::uint32_t i) {
  Life copy = life;
  EXPECT_EQ(copy.step(i), hal::Error::none);
  return copy.files.calls() - life.files.calls();
}

TEST(FileFaults, PowerCutAtEveryCall) {
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const Life before(i);
    const std::uint64_t calls = calls_of(before, i);
    ASSERT_GT(calls, 5);
    for (std::uint64_t call = 0; call < calls; ++call) {
      for (const auto kind : {Fault::FaultKind::cut_before, Fault::FaultKind::cut_after}) {
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
          Life life = before;
          life.files.fault({life.files.calls() + call, kind});
          (void)life.step(i);
          ASSERT_FALSE(life.files.powered());
          life.files.restart(seed);
          life.check_and_continue(i + 1);
          ASSERT_FALSE(testing::Test::HasFatalFailure())
              << "step " << i << " call " << call << " seed " << seed;
        }
      }
    }
  }
}

TEST(FileFaults, AnErrorOfEveryCallIsToldAndLosesNothing) {
  std::uint32_t reported = 0;
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const Life before(i);
    const std::uint64_t calls = calls_of(before, i);
    for (std::uint64_t call = 0; call < calls; ++call) {
      for (const int error : {EIO, ENOSPC, EINTR, EACCES}) {
        Life life = before;
        life.files.fault({life.files.calls() + call, Fault::FaultKind::error, error});
        reported += life.step(i) != hal::Error::none ? 1u : 0u;
        life.files.restart(2);
        life.check_and_continue(i + 1);
        ASSERT_FALSE(testing::Test::HasFatalFailure())
            << "step " << i << " call " << call << " error " << error;
      }
    }
  }
  EXPECT_GT(reported, 1'000u);
}

TEST(FileFaults, AShortWriteIsWrittenToItsEnd) {
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const Life before(i);
    const std::uint64_t calls = calls_of(before, i);
    for (std::uint64_t call = 0; call < calls; ++call) {
      Life life = before;
      life.files.fault({life.files.calls() + call, Fault::FaultKind::short_write});
      ASSERT_EQ(life.step(i), hal::Error::none);
      life.check_and_continue(i + 1);
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "step " << i << " call " << call;
    }
  }
}

// Nothing but the opening has synced the folder before the first entry.
TEST(FileFaults, TheFirstEntryOfANewLogIsThere) {
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    MemoryFiles files("/store");
    {
      auto opened = MemoryStore::open("/store", MemoryCalls(files));
      ASSERT_EQ(std::get<MemoryStore>(opened).append(entry_of(1)), hal::Error::none);
    }
    files.restart(seed);
    auto opened = MemoryStore::open("/store", MemoryCalls(files));
    ASSERT_TRUE(std::get<MemoryStore>(opened).log(0)) << seed;
  }
}

// A store that stays open over errors, as a controller does on a disk that is full for a while.
TEST(FileFaults, AFullDiskForAWhile) {
  Life life(6);
  auto opened = MemoryStore::open("/store", MemoryCalls(life.files));
  MemoryStore& store = std::get<MemoryStore>(opened);
  const auto committed = store.load(1);
  for (std::uint32_t i = 0; i < 5; ++i) {
    life.files.fault({life.files.calls() + 1, Fault::FaultKind::error, ENOSPC});
    EXPECT_EQ(store.save(records_of<kTendons>(20 + i)), hal::Error::failed);
    ASSERT_TRUE(store.problem());
    EXPECT_EQ(to_string(*store.problem()),
              "/store/life.partial: cannot write it: No space left on device");
    EXPECT_EQ(store.load(1), committed);
  }
  EXPECT_EQ(store.save(records_of<kTendons>(30)), hal::Error::none);
  EXPECT_FALSE(store.problem());
  EXPECT_TRUE(same_life(*store.load(1), record_of(1, 30)));
  EXPECT_EQ(store.sequence(), committed->sequence + 6);
}

}  // namespace
}  // namespace storage_test
