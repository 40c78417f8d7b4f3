#include <gmock/gmock.h>

#include "firmware/protocol/e2e.hpp"
#include "tests/virtual_g431/reference.hpp"
#include "tests/virtual_g431/tester.hpp"

namespace virtual_g431 {
namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

class OnTheBus : public Image {
 protected:
  void SetUp() override {
    Image::SetUp();
    board.power_on();
    board.run(500 * kMillisecond);
  }
  void expect_control_in_time(std::size_t from = 1) const {
    for (std::size_t i = std::max<std::size_t>(from, 1); i < board.periods.size(); ++i) {
      const Ticks between = board.periods[i].at - board.periods[i - 1].at;
      ASSERT_NEAR(static_cast<double>(between), 100.0 * kMicrosecond, 2.0 * kMicrosecond) << i;
    }
  }

  Board board{contents};
};

/// More than the mailbox and the idle loop can take, of frames that pass the filter.
TEST_F(OnTheBus, AFloodForTheNodeDisturbsNothing) {
  const hal::CanFrame frame{.id = protocol::id_of<protocol::Command>(kNode)};
  const auto before = sent<protocol::LifeStatus>(board).size();
  for (int i = 0; i < 1'000; ++i) {
    // Each takes 58 us at most, so that the node finds room for its own.
    while (board.can.waiting() < 15) {
      board.can.send(frame);
    }
    board.run(kMillisecond);
  }
  EXPECT_GE(sent<protocol::LifeStatus>(board).size(), before + 9);
  expect_control_in_time();
  EXPECT_THAT(board.resets, IsEmpty());
  EXPECT_TRUE(board.drive_enabled());
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// Frames of more weight leave no room for the node, which then speaks again.
TEST_F(OnTheBus, AFloodOfOthersOnlySilencesIt) {
  hal::CanFrame frame{.id = 0x001, .length = 8};
  board.can.send(frame);
  const auto before = board.can.heard.size();
  for (int i = 0; i < 10; ++i) {
    while (board.can.waiting() < 2200) {
      board.can.send(frame);
    }
    board.run(100 * kMillisecond);
  }
  EXPECT_EQ(board.can.heard.size(), before);
  ASSERT_TRUE(board.run_until([&] { return board.can.waiting() == 0; }, kSecond));
  const auto after = sent<protocol::LifeStatus>(board).size();
  board.run(kSecond);
  EXPECT_GE(sent<protocol::LifeStatus>(board).size(), after + 9);
  expect_control_in_time();
  EXPECT_THAT(board.resets, IsEmpty());
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(OnTheBus, ComesBackFromBusOff) {
  board.can.set_bus(CanController::Bus::shorted);
  const auto before = board.can.heard.size();
  board.run(kSecond);
  EXPECT_EQ(board.can.heard.size(), before);
  EXPECT_NE(board.can.read(0x44) & bit(7), 0u) << "bus-off";
  EXPECT_TRUE(board.drive_enabled()) << "the life is counted without a bus";
  board.can.set_bus(CanController::Bus::sound);
  const auto statuses = sent<protocol::LifeStatus>(board).size();
  // The firmware waits longer from one attempt to the next.
  board.run(3 * kSecond);
  EXPECT_GE(sent<protocol::LifeStatus>(board).size(), statuses + 10);
  EXPECT_TRUE(reported(board, protocol::EmergencyCode::bus));
  expect_control_in_time();
  EXPECT_THAT(board.resets, IsEmpty());
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// Without anybody who acknowledges a controller becomes passive, and never goes off.
TEST_F(OnTheBus, IsAloneForAWhile) {
  board.can.set_bus(CanController::Bus::nobody_else);
  board.run(kSecond);
  EXPECT_EQ(board.can.read(0x44) & 0xE0, 0x60u) << "passive";
  board.can.set_bus(CanController::Bus::sound);
  const auto before = sent<protocol::LifeStatus>(board).size();
  board.run(kSecond);
  EXPECT_GE(sent<protocol::LifeStatus>(board).size(), before + 9);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// Pages of a burst come each 10 ms, in place of one each 100 ms.
TEST_F(OnTheBus, ACommandNeedsItsProtection) {
  constexpr std::uint8_t kAsked = 9;  // which the share of the bus has room for at once
  const auto pages_in_150_ms = [this] {
    const std::size_t from = board.can.heard.size();
    board.run(150 * kMillisecond);
    std::size_t pages = 0;
    for (std::size_t i = from; i < board.can.heard.size(); ++i) {
      pages += board.can.heard[i].frame.id == 0x280u + kNode ? 1u : 0u;
    }
    return pages;
  };
  protocol::e2e::Protector commands(protocol::e2e::stream_of<protocol::Command>(kNode));
  hal::CanFrame burst =
      protocol::encode(kNode, protocol::Command{protocol::CommandCode::burst, kAsked});
  commands.protect(burst);
  hal::CanFrame damaged = burst;
  damaged.data[3] ^= std::byte{1};
  board.can.send(damaged);
  EXPECT_LE(pages_in_150_ms(), 2u);
  hal::CanFrame other = burst;
  other.id += 1;
  board.can.send(other);
  EXPECT_LE(pages_in_150_ms(), 2u);
  board.can.send(burst);
  EXPECT_GE(pages_in_150_ms(), kAsked);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// A new wire is put in: with the right code once, and it outlives the power.
TEST_F(OnTheBus, AnEpochNeedsItsCode) {
  Tester tester(board);
  EXPECT_THAT(tester.start(0x0201, bytes({0}), kKey, 1),
              ElementsAreArray(bytes({0x7F, 0x31, 0x35})));
  EXPECT_THAT(tester.start(0x0201, bytes({0}), app::Key{}),
              ElementsAreArray(bytes({0x7F, 0x31, 0x35})));
  EXPECT_THAT(tester.start(0x0201, bytes({0}), kKey),
              ElementsAreArray(bytes({0x71, 0x01, 0x02, 0x01})));
  EXPECT_THAT(tester.repeat(), ElementsAreArray(bytes({0x7F, 0x31, 0x24})))
      << "a nonce is good for once";
  board.power_off();
  board.power_on();
  board.run(200 * kMillisecond);
  const Bytes life = tester.read(0x0200);
  ASSERT_EQ(life.size(), 3u + 61u);
  EXPECT_EQ(life[3 + 6], std::byte{1}) << "epoch";
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(OnTheBus, ParametersNeedTheirCode) {
  Tester tester(board);
  Bytes arguments = bytes({0});
  for (const auto byte : tendonlife_parameter_block) {
    arguments.push_back(static_cast<std::byte>(byte));
  }
  EXPECT_THAT(tester.start(0x0202, arguments, kKey, 0x80),
              ElementsAreArray(bytes({0x7F, 0x31, 0x35})));
  Bytes damaged = arguments;
  damaged[40] ^= std::byte{1};
  EXPECT_THAT(tester.start(0x0202, damaged, kKey), ElementsAreArray(bytes({0x7F, 0x31, 0x31})));
  EXPECT_THAT(tester.start(0x0202, arguments, kKey),
              ElementsAreArray(bytes({0x71, 0x01, 0x02, 0x02})));
  expect_control_in_time();
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// Where the noise is broken there is no nonce, and so no authority.
TEST_F(OnTheBus, WithoutNoiseThereIsNoAuthority) {
  board.noise.broken = true;
  Tester tester(board);
  EXPECT_EQ(tester.read(0x0241).front(), std::byte{0x7F});
  EXPECT_THAT(board.resets, IsEmpty());
}

}  // namespace
}  // namespace virtual_g431
