#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "firmware/protocol/uds/table.hpp"
#include "tests/virtual_g431/image.hpp"
#include "tests/virtual_g431/tester.hpp"

namespace virtual_g431 {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class Boot : public Image {
 protected:
  testing::Matcher<std::vector<protocol::Emergency>> reports_settings =
      ElementsAre(Field(&protocol::Emergency::code, protocol::EmergencyCode::settings));
};

TEST_F(Boot, SpeaksByTheRules) {
  Board board(contents);
  board.power_on();
  board.run(3 * kSecond);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
  EXPECT_THAT(board.resets, IsEmpty());
  EXPECT_EQ(board.core->faults(), 0u);
  EXPECT_EQ(board.converters.collisions(), 0u);
  EXPECT_TRUE(board.watchdog.on());
  EXPECT_EQ(board.clocks.hclk(), 8u);  // 170 MHz
  EXPECT_FALSE(board.terminated());

  const auto beats = sent<protocol::Heartbeat>(board);
  ASSERT_THAT(beats, SizeIs(4));  // at the start, and each second from then on
  EXPECT_EQ(beats[0].state, protocol::NmtState::boot_up);
  EXPECT_EQ(beats[1].state, protocol::NmtState::operational);
  const auto statuses = sent<protocol::LifeStatus>(board);
  EXPECT_GE(statuses.size(), 29u);
  EXPECT_TRUE(statuses.back().storage_ok);
  EXPECT_TRUE(statuses.back().sensor_ok);
  EXPECT_FALSE(statuses.back().gap);
  EXPECT_FALSE(statuses.back().locked);
  EXPECT_EQ(statuses.back().state, protocol::LifeState::normal);
  EXPECT_THAT(sent<protocol::Emergency>(board), IsEmpty());
}

TEST_F(Boot, ControlLoopComesEvery100us) {
  Board board(contents);
  board.power_on();
  board.run(200 * kMillisecond);
  ASSERT_GT(board.periods.size(), 1000u);
  for (std::size_t i = 1; i < board.periods.size(); ++i) {
    const Ticks between = board.periods[i].at - board.periods[i - 1].at;
    ASSERT_NEAR(static_cast<double>(between), 100.0 * kMicrosecond, kMicrosecond) << i;
  }
}

/// Brake first, then drive, and neither before 100 periods came in time.
TEST_F(Boot, LetsTheDriveGoAfterTheControlLoopCameInTime) {
  Board board(contents);
  board.power_on();
  ASSERT_TRUE(board.run_until([&] { return board.drive_enabled(); }, kSecond));
  board.run(kSecond);
  ASSERT_THAT(board.edges, SizeIs(2));
  EXPECT_FALSE(board.edges[0].drive);
  EXPECT_TRUE(board.edges[1].drive);
  ASSERT_GT(board.periods.size(), 101u);
  EXPECT_GT(board.edges[0].at, board.periods[100].at);
  EXPECT_LT(board.edges[1].at, board.periods[101].at);
  EXPECT_EQ(board.resets.size(), 0u);
}

/// What memory has when the power comes says nothing.
TEST_F(Boot, WhateverIsInMemory) {
  for (std::uint32_t seed = 2; seed < 7; ++seed) {
    Board board(contents, seed);
    board.power_on();
    EXPECT_TRUE(board.run_until([&] { return board.drive_enabled(); }, 200 * kMillisecond)) << seed;
    EXPECT_THAT(board.broken_rules(), IsEmpty()) << seed;
    EXPECT_THAT(board.resets, IsEmpty()) << seed;
  }
}

TEST_F(Boot, WithoutACrystalOnTheInternalOscillator) {
  Board board(contents);
  board.clocks.fit_crystal(false);
  board.power_on();
  board.run(kSecond);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
  EXPECT_EQ(board.clocks.hclk(), 8u);
  EXPECT_THAT(board.resets, IsEmpty());
  EXPECT_GE(sent<protocol::LifeStatus>(board).size(), 9u);
  EXPECT_TRUE(board.drive_enabled());
}

TEST_F(Boot, WithoutANodePageIsNode127) {
  std::fill_n(contents.bytes.begin() + kNodePageOffset, kPageBytes, std::uint8_t{0xFF});
  Board board(contents);
  board.power_on();
  board.run(kSecond);
  EXPECT_GE(sent<protocol::LifeStatus>(board, 127).size(), 9u);
  EXPECT_THAT(sent<protocol::LifeStatus>(board), IsEmpty());
  EXPECT_TRUE(board.terminated());
  EXPECT_THAT(sent<protocol::Emergency>(board, 127), reports_settings);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(Boot, WithATornNodePageIsNode127) {
  contents.bytes[kNodePageOffset + 13] ^= 4;
  Board board(contents);
  board.power_on();
  board.run(kSecond);
  EXPECT_GE(sent<protocol::LifeStatus>(board, 127).size(), 9u);
  EXPECT_THAT(sent<protocol::LifeStatus>(board), IsEmpty());
  EXPECT_THAT(sent<protocol::Emergency>(board, 127), reports_settings);
  // Nobody has authority over it, whatever the proof.
  Bytes epoch = bytes({0x31, 0x01, 0x02, 0x01, 0x00});
  epoch.resize(epoch.size() + protocol::uds::kProofBytes);
  EXPECT_EQ(Tester(board, 127).ask(epoch), bytes({0x7F, 0x31, 0x33}));
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

}  // namespace
}  // namespace virtual_g431
