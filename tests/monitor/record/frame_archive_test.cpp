#include "host_sim/monitor/record/frame_archive.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace host_sim::monitor {
namespace {

TEST(NodeOfLine, FollowsTheFramePlan) {
  EXPECT_EQ(node_of_line("(1.000000) can0 185#00\n"), 5);
  EXPECT_EQ(node_of_line("(1.000000) can0 77F#05\n"), 127);
  EXPECT_EQ(node_of_line("(1.000000) can0 085#00 R\n"), 5);
  EXPECT_EQ(node_of_line("(1.000000) can0 18DA05F1#00\n"), 5);
  EXPECT_EQ(node_of_line("(1.000000) can0 18DAF105#00\n"), 5);
  EXPECT_EQ(node_of_line("(1.000000) can0 180#00\n"), std::nullopt);
  EXPECT_EQ(node_of_line("(1.000000) can0 605#00\n"), std::nullopt);
  EXPECT_EQ(node_of_line("(1.000000) can0 00000185#00\n"), std::nullopt);
  EXPECT_EQ(node_of_line("# can0\n"), std::nullopt);
  EXPECT_EQ(node_of_line("185"), std::nullopt);
  EXPECT_EQ(node_of_line(""), std::nullopt);
}

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

std::string read_all(const RecentFrames& frames, std::optional<protocol::Node> node = {}) {
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
  EXPECT_EQ(read_all(frames), "");
  see(frames, 0, 5);
  EXPECT_EQ(read_all(frames), lines_between(0, 5));
  EXPECT_EQ(read_all(frames, 6), line_at(1) + line_at(3));
  EXPECT_EQ(read_all(frames, 7), "");
}

TEST(RecentFrames, TheOldestGo) {
  constexpr std::size_t kMost = 8192;
  RecentFrames frames("can0", kMost);
  for (int count = 100; count <= 5000; count += 100) {
    see(frames, count - 100, count);
    const std::string all = read_all(frames);
    const std::string seen = lines_between(0, count);
    EXPECT_TRUE(seen.ends_with(all)) << count;
    EXPECT_TRUE(all.starts_with('(')) << count;
    EXPECT_LE(all.size(), kMost);
    EXPECT_GE(all.size(), std::min(seen.size(), kMost - kMost / 32 - kMost / 8));
    EXPECT_EQ(frames.why_gone().empty(), all.size() == seen.size()) << count;
  }
}

TEST(RecentFrames, AreGoneWithoutARecord) {
  RecentFrames frames("can0", std::size_t{1} << 20);
  EXPECT_EQ(frames.why_gone(), "");
  see(frames, 0, 50'000);
  EXPECT_EQ(frames.why_gone(), "without --record the newest 1 MiB are kept");
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
    const std::string all = read_all(frames);
    EXPECT_NE(seen.find(all), std::string::npos);
    EXPECT_TRUE(all.empty() || (all.front() == '(' && all.back() == '\n'));
  }
  writer.join();
  EXPECT_TRUE(seen.ends_with(read_all(frames)));
}

/// The first line that is read from a time on.
std::string first_from(const FrameArchive& archive, std::int64_t from_us) {
  std::string first;
  archive.read_from(from_us, [&](std::string_view lines) {
    first = lines.substr(0, lines.find('\n') + 1);
    return false;
  });
  return first;
}

constexpr std::int64_t kBegin_us = 1'000'000'000'000'000;

TEST(RecentFrames, AreLookedUpByTime) {
  RecentFrames frames("can0", 8192);
  EXPECT_TRUE(frames.times_us().empty());
  EXPECT_EQ(first_from(frames, kBegin_us), "");
  see(frames, 0, 100);
  const std::vector<std::int64_t> times_us = frames.times_us();
  EXPECT_EQ(times_us.front(), kBegin_us);
  EXPECT_GT(times_us.back(), kBegin_us + 90);
  EXPECT_TRUE(std::is_sorted(times_us.begin(), times_us.end()));
  // A piece of 256 bytes has 8 lines of 31 bytes.
  EXPECT_EQ(first_from(frames, kBegin_us + 50), line_at(48));
  EXPECT_EQ(first_from(frames, kBegin_us + 48), line_at(48));
  EXPECT_EQ(first_from(frames, kBegin_us + 47), line_at(40));
  EXPECT_EQ(first_from(frames, 0), line_at(0));
  see(frames, 100, 5000);
  EXPECT_LE(frames.times_us().size(), FrameArchive::kMostTimes);
  EXPECT_GT(frames.times_us().front(), kBegin_us + 4000);
}

class RecordedFolderTest : public testing::Test {
 protected:
  RecordedFolderTest() {
    std::string name = testing::TempDir() + "recordedXXXXXX";
    folder = mkdtemp(name.data());
  }
  ~RecordedFolderTest() override { std::filesystem::remove_all(folder); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
  }
  [[nodiscard]] std::string read(std::optional<protocol::Node> node) const {
    std::string all;
    RecordedFolder(folder, [] {}).read(node, [&](std::string_view piece) {
      all += piece;
      return true;
    });
    return all;
  }

  std::filesystem::path folder;
};

const std::string kOfFive = "(1.000000) can0 185#00\n";
const std::string kOfSix = "(2.000000) can0 186#00\n";

TEST_F(RecordedFolderTest, ReadsAllLogsInOrder) {
  write("frames-00000002.log", kOfSix);
  write("frames-00000001.log", kOfFive);
  write("other.log", kOfSix);
  EXPECT_EQ(read({}), kOfFive + kOfSix);
  EXPECT_EQ(read(5), kOfFive);
  EXPECT_EQ(read(7), "");
}

TEST_F(RecordedFolderTest, HasLostWhatIsBeforeItsFirstLog) {
  const RecordedFolder archive(folder, [] {});
  EXPECT_EQ(archive.why_gone(), "");
  write("frames-00000002.log", kOfSix);
  EXPECT_EQ(archive.why_gone(),
            "of the record the newest logs are kept, as many as --record-keep says");
  write("frames-00000001.log", kOfFive);
  EXPECT_EQ(archive.why_gone(), "");
}

TEST_F(RecordedFolderTest, HasWhatWasSeenWrittenFirst) {
  std::string all;
  RecordedFolder(folder, [this] {
    write("frames-00000001.log", kOfFive);
  }).read({}, [&](std::string_view piece) {
    all += piece;
    return true;
  });
  EXPECT_EQ(all, kOfFive);
}

TEST_F(RecordedFolderTest, LeavesOutALineThatIsBeingWritten) {
  write("frames-00000001.log", kOfFive + "(2.000000) can0 185#0");
  EXPECT_EQ(read({}), kOfFive);
  EXPECT_EQ(read(5), kOfFive);
}

TEST_F(RecordedFolderTest, ReadsMoreThanAPiece) {
  std::string lines;
  while (lines.size() < (std::size_t{1} << 20)) {
    lines += kOfFive + kOfSix;
  }
  write("frames-00000001.log", lines);
  EXPECT_EQ(read({}), lines);
  EXPECT_EQ(read(6).size(), lines.size() / 2);
}

TEST_F(RecordedFolderTest, StopsWhereNobodyTakes) {
  write("frames-00000001.log", kOfFive);
  write("frames-00000002.log", kOfSix);
  int pieces = 0;
  RecordedFolder(folder, [] {}).read({}, [&](std::string_view) { return ++pieces > 1; });
  EXPECT_EQ(pieces, 1);
}

/// Of each second from `begin` on: 24 bytes each.
std::string lines_of_seconds(int begin, int end) {
  std::string lines;
  for (int i = begin; i < end; ++i) {
    lines += fmt::format("({:05}.000000) can0 185#\n", i);
  }
  return lines;
}

TEST_F(RecordedFolderTest, IsLookedUpByTime) {
  write("frames-00000001.log", lines_of_seconds(10'000, 20'000));
  write("frames-00000002.log", "# a comment\n" + lines_of_seconds(20'000, 20'010));
  write("frames-00000003.log", lines_of_seconds(30'000, 50'000));
  const RecordedFolder recorded(folder, [] {});
  const auto second_of = [&](std::int64_t from_s) {
    return std::stoi(first_from(recorded, from_s * 1'000'000).substr(1));
  };
  EXPECT_EQ(second_of(0), 10'000);
  EXPECT_EQ(second_of(10'000), 10'000);
  // No more than 16 KiB, which are 682 lines, too early.
  for (const int at_s : {12'345, 19'999, 30'000, 31'000, 49'999, 60'000}) {
    EXPECT_LE(second_of(at_s), at_s);
    EXPECT_GE(second_of(at_s), std::min(at_s, 49'999) - 684) << at_s;
  }
  EXPECT_TRUE(first_from(recorded, 20'005'000'000).starts_with("# a comment\n"));
  EXPECT_TRUE(first_from(recorded, 29'000'000'000).starts_with("# a comment\n"));

  const std::vector<std::int64_t> times_us = recorded.times_us();
  EXPECT_GT(times_us.size(), 300u);
  EXPECT_LE(times_us.size(), FrameArchive::kMostTimes);
  EXPECT_EQ(times_us.front(), 10'000'000'000);
  EXPECT_GT(times_us.back(), 49'800'000'000);
  EXPECT_EQ(std::adjacent_find(times_us.begin(), times_us.end(), std::greater_equal<>()),
            times_us.end());
}

TEST_F(RecordedFolderTest, AClockThatWasSetBackHasItsLaterTimes) {
  write("frames-00000001.log", lines_of_seconds(10'000, 20'000));
  write("frames-00000002.log", lines_of_seconds(15'000, 16'000));
  const RecordedFolder recorded(folder, [] {});
  const std::vector<std::int64_t> times_us = recorded.times_us();
  EXPECT_LT(*std::max_element(times_us.begin(), times_us.end()), 16'000'000'000);
  EXPECT_EQ(first_from(recorded, 15'000'000'000), "(15000.000000) can0 185#\n");
}

TEST_F(RecordedFolderTest, ManyLogsHaveAFewTimesEach) {
  for (int i = 1; i <= 600; ++i) {
    write(fmt::format("frames-{:08}.log", i), lines_of_seconds(10'000 + i, 10'001 + i));
  }
  const std::vector<std::int64_t> times_us = RecordedFolder(folder, [] {}).times_us();
  EXPECT_EQ(times_us.size(), 300u);
  EXPECT_EQ(times_us.front(), 10'001'000'000);
}

TEST(RecordedFolder, IsEmptyWithoutAFolder) {
  RecordedFolder("/nonexistent", [] {}).read({}, [](std::string_view) {
    ADD_FAILURE();
    return true;
  });
  EXPECT_TRUE(RecordedFolder("/nonexistent", [] {}).times_us().empty());
}

}  // namespace
}  // namespace host_sim::monitor
