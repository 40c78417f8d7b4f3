#include "host_sim/monitor/http/recent_frames.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

namespace host_sim::monitor {
namespace {

/// A frame without data of node 5 or 6 at so many microseconds, and its line.
SeenFrame frame_at(int time_us) {
  SeenFrame seen;
  seen.time_ns = 1'000'000'000'000'000'000 + std::int64_t{1000} * time_us;
  seen.frame.id = time_us % 2 == 0 ? 0x185 : 0x186;
  return seen;
}

std::string line_at(int time_us) {
  return fmt::format("(1000000000.{:06}) can0 {}#\n", time_us, time_us % 2 == 0 ? "185" : "186");
}

std::string lines_between(int first, int end) {
  std::string lines;
  for (int i = first; i < end; ++i) {
    lines += line_at(i);
  }
  return lines;
}

std::string read(const RecentFrames& frames, std::optional<protocol::Node> node = {}) {
  std::string all;
  frames.read(node, [&](std::string_view piece) {
    all += piece;
    return true;
  });
  return all;
}

void see(RecentFrames& frames, int first, int end) {
  for (int i = first; i < end; ++i) {
    frames.see(frame_at(i));
  }
}

TEST(RecentFrames, AreThoseThatWereSeen) {
  RecentFrames frames("can0");
  EXPECT_EQ(read(frames), "");
  see(frames, 0, 5);
  EXPECT_EQ(read(frames), lines_between(0, 5));
  EXPECT_EQ(read(frames, 6), line_at(1) + line_at(3));
  EXPECT_EQ(read(frames, 7), "");
}

TEST(RecentFrames, TheOldestGo) {
  constexpr std::size_t kMost = 8192;
  RecentFrames frames("can0", kMost);
  for (int count = 100; count <= 5000; count += 100) {
    see(frames, count - 100, count);
    const std::string all = read(frames);
    const std::string seen = lines_between(0, count);
    EXPECT_TRUE(seen.ends_with(all)) << count;
    EXPECT_TRUE(all.starts_with('(')) << count;
    EXPECT_LE(all.size(), kMost);
    EXPECT_GE(all.size(), std::min(seen.size(), kMost - kMost / 32 - kMost / 8));
  }
}

TEST(RecentFrames, ReadingStopsWhereNobodyTakes) {
  RecentFrames frames("can0", 8192);
  see(frames, 0, 200);
  int pieces = 0;
  frames.read({}, [&](std::string_view) { return ++pieces < 3; });
  EXPECT_EQ(pieces, 3);
}

TEST(RecentFrames, AreWholeWhileMoreAreSeen) {
  RecentFrames frames("can0", std::size_t{1} << 16);
  constexpr int kCount = 20'000;
  std::atomic<bool> ended{false};
  std::thread writer([&] {
    see(frames, 0, kCount);
    ended = true;
  });
  const std::string seen = lines_between(0, kCount);
  while (!ended) {
    const std::string all = read(frames);
    EXPECT_NE(seen.find(all), std::string::npos);
    EXPECT_TRUE(all.empty() || (all.front() == '(' && all.back() == '\n'));
  }
  writer.join();
  EXPECT_TRUE(seen.ends_with(read(frames)));
}

}  // namespace
}  // namespace host_sim::monitor
