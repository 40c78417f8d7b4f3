// A recorder that is killed at a random moment of its work: what was synced is there, every log is
// of whole lines but the last one of the last, and the next recorder continues.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "hal/files/candump.hpp"
#include "host_sim/monitor/record/recorder.hpp"

namespace host_sim::monitor {

using hal::files::CandumpReader;

namespace {

constexpr Rotation kRotation{.bytes = 20'000, .keep = 1'000};

SeenFrame frame_number(std::uint32_t number) {
  SeenFrame seen;
  seen.time_ns = std::int64_t{number} * 1'000;
  seen.frame = {.id = 0x185, .length = 8};
  return seen;
}

/// Records frames from `first` on, without end; says how many are synced.
[[noreturn]] void record_for_ever(const std::filesystem::path& folder, std::uint32_t first,
                                  int synced) {
  Recorder recorder(folder, kRotation, "can0");
  for (std::uint32_t number = first;; ++number) {
    recorder.see(frame_number(number));
    if (number % 97 == 0) {
      recorder.sync();
      if (::write(synced, &number, sizeof number) != sizeof number) {
        std::_Exit(1);
      }
    }
  }
}

/// The last number that was synced when the child was killed after `syncs` of them.
std::uint32_t kill_a_recorder(const std::filesystem::path& folder, std::uint32_t first, int syncs) {
  int pipe[2];
  EXPECT_EQ(::pipe(pipe), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(pipe[0]);
    record_for_ever(folder, first, pipe[1]);
  }
  ::close(pipe[1]);
  std::uint32_t synced = 0;
  for (int i = 0; i < syncs; ++i) {
    EXPECT_EQ(::read(pipe[0], &synced, sizeof synced), static_cast<ssize_t>(sizeof synced));
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  std::uint32_t more = 0;
  while (::read(pipe[0], &more, sizeof more) == static_cast<ssize_t>(sizeof more)) {
    synced = more;
  }
  ::close(pipe[0]);
  return synced;
}

std::vector<std::uint64_t> recorded(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> logs;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    logs.push_back(entry.path());
  }
  std::sort(logs.begin(), logs.end());
  std::vector<std::uint64_t> numbers;
  for (const auto& log : logs) {
    CandumpReader reader(log);
    while (const auto frame = reader.next()) {
      numbers.push_back(frame->time_us);
    }
  }
  return numbers;
}

TEST(RecorderKilled, LosesNothingThatWasSynced) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("kill_test." + std::to_string(::getpid()));
  std::filesystem::remove_all(folder);
  std::uint32_t first = 0;
  for (const int syncs : {1, 7, 30, 3, 61}) {
    const std::uint32_t synced = kill_a_recorder(folder, first, syncs);
    ASSERT_GE(synced, first);
    // As kill -9 leaves it where it hits a write: half a line.
    std::filesystem::path last;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      last = std::max(last, entry.path());
    }
    std::ofstream(last, std::ios::app) << "(0000000000.00";
    {
      const Recorder repaired(folder, kRotation, "can0");
      EXPECT_NE(repaired.repaired(), "");
    }
    const auto numbers = recorded(folder);
    ASSERT_GT(numbers.size(), synced);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      ASSERT_EQ(numbers[i], i);
    }
    first = static_cast<std::uint32_t>(numbers.size());
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace host_sim::monitor
