#include "host_sim/monitor/http/recorded_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace host_sim::monitor {
namespace {

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
