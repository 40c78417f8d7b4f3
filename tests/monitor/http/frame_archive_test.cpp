#include "host_sim/monitor/http/frame_archive.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

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
    const std::string all = read_all(frames);
    EXPECT_NE(seen.find(all), std::string::npos);
    EXPECT_TRUE(all.empty() || (all.front() == '(' && all.back() == '\n'));
  }
  writer.join();
  EXPECT_TRUE(seen.ends_with(read_all(frames)));
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

TEST(RecordedFolder, IsEmptyWithoutAFolder) {
  RecordedFolder("/nonexistent", [] {}).read({}, [](std::string_view) {
    ADD_FAILURE();
    return true;
  });
}

}  // namespace
}  // namespace host_sim::monitor
