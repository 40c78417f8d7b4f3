// Kills a process at random moments while it saves, and looks at what it left.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <variant>

#include "firmware/storage/file_store.hpp"
#include "hal/fake/random.hpp"
#include "tests/storage/folder.hpp"
#include "tests/storage/lives.hpp"

namespace storage_test {
namespace {

using hal::Error;
using Store = storage::FileStore<2>;

/// Saves without end; reports each step that was committed.
[[noreturn]] void child(const Folder& folder, std::uint32_t step, int committed) {
  auto opened = Store::open(folder.path());
  Store* store = std::get_if<Store>(&opened);
  while (store != nullptr) {
    ++step;
    if (store->save(records_of<2>(step)) != Error::none ||
        store->append(entry_of(step)) != Error::none ||
        ::write(committed, &step, sizeof step) != sizeof step) {
      break;
    }
  }
  ::_exit(1);
}

/// The last step that a child reported before it was killed, `wait_us` after it had reported
/// `count`.
std::uint32_t last_committed(const Folder& folder, std::uint32_t step, std::uint32_t count,
                             std::uint32_t wait_us) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::close(ends[0]);
    child(folder, step, ends[1]);
  }
  ::close(ends[1]);
  for (std::uint32_t i = 0; i < count; ++i) {
    EXPECT_EQ(::read(ends[0], &step, sizeof step), static_cast<ssize_t>(sizeof step));
  }
  ::usleep(wait_us);
  ::kill(pid, SIGKILL);
  int status = 0;
  ::waitpid(pid, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the child ended by itself";
  std::uint32_t reported = 0;
  while (::read(ends[0], &reported, sizeof reported) == sizeof reported) {
    step = reported;
  }
  ::close(ends[0]);
  return step;
}

TEST(FileKill, WhatWasCommittedIsThere) {
  const Folder folder;
  hal::fake::Random random(1);
  std::uint32_t step = 0;
  std::uint32_t entries = 0;
  {
    Store first = std::get<Store>(Store::open(folder.path()));
    ASSERT_EQ(first.save(records_of<2>(step)), Error::none);
  }
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t committed =
        last_committed(folder, step, random.below(4), random.below(2'000));
    entries += committed - step;
    auto opened = Store::open(folder.path());
    ASSERT_TRUE(std::holds_alternative<Store>(opened));
    Store& store = std::get<Store>(opened);
    const auto found = store.load(0);
    ASSERT_TRUE(found) << round;
    // What was reported, or the one that was under way.
    const bool under_way = same_life(*found, record_of(0, committed + 1));
    ASSERT_TRUE(under_way || same_life(*found, record_of(0, committed))) << round;
    ASSERT_TRUE(same_life(*store.load(1), record_of(1, under_way ? committed + 1 : committed)));
    ASSERT_FALSE(store.past_lost());
    ASSERT_TRUE(entries == 0 || store.log(entries - 1)) << round;
    entries += store.log(entries) ? 1u : 0u;
    ASSERT_FALSE(store.log(entries)) << round;
    step = under_way ? committed + 1 : committed;
  }
  EXPECT_GT(step, 200u);
}

}  // namespace
}  // namespace storage_test
