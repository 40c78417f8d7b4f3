// A parameter block that is transferred in parts, and the routine that loads it under authority.
#include <gtest/gtest.h>

#include "tests/protocol/services/served.hpp"

namespace protocol::testing {
namespace {

using lifemodel::extension::Effect;
using storage::Event;

/// A block with a droop of the torque constant and a correction of 16 knots.
Bytes extended_block() {
  lifemodel::ExtendedParameters model{
      lifemodel_test::parameters_of(lifemodel_test::paper_constants()), {}};
  model.extension.add(Effect::torque_gain);
  model.extension.torque_gain.droop = 1 << 20;
  model.extension.add(Effect::empirical);
  model.extension.empirical.knots = 16;
  for (std::int32_t i = 0; i < 16; ++i) {
    model.extension.empirical.knot[static_cast<std::size_t>(i)] = {i, 2 * i, -i};
  }
  return to_bytes(lifemodel::ExtendedBlock(model).bytes());
}

class TransferTest : public ServedTest {
 protected:
  static Bytes download(std::uint8_t tendon, std::size_t size) {
    return hex("34 00 21") + Bytes{std::byte{tendon}, static_cast<std::byte>(size >> 8),
                                   static_cast<std::byte>(size)};
  }
  static Bytes part(std::uint8_t number, const Bytes& bytes) {
    return Bytes{std::byte{0x36}, std::byte{number}} + bytes;
  }
  /// All of a block in parts of `most` bytes, to its end.
  void transfer(std::uint8_t tendon, const Bytes& block, std::size_t most = 126) {
    ASSERT_EQ(ask(download(tendon, block.size())), hex("74 20 00 91"));
    std::uint8_t number = 0;
    for (std::size_t at = 0; at < block.size(); at += most) {
      const Bytes some(
          block.begin() + static_cast<std::ptrdiff_t>(at),
          block.begin() + static_cast<std::ptrdiff_t>(std::min(at + most, block.size())));
      ++number;
      ASSERT_EQ(ask(part(number, some)), (Bytes{std::byte{0x76}, std::byte{number}}));
    }
    ASSERT_EQ(ask(hex("37")), hex("77"));
  }
  Order load_order(const Bytes& block, std::uint8_t tendon = 1) {
    Order order = fresh_order();
    order.routine = 0x0203;
    order.arguments = {std::byte{tendon}};
    order.transferred = block;
    return order;
  }
};

TEST_F(TransferTest, InPartsOfAnySizeIsLoadedWhole) {
  const Bytes block = extended_block();
  ASSERT_EQ(block.size(), 84u + 4 * (6 + 2 + 50));
  for (const std::size_t most : {1u, 2u, 84u, 126u}) {
    device_ = ModelDevice(2);
    restart();
    transfer(1, block, most);
    EXPECT_EQ(ask(start_request(load_order(block))), hex("71 01 02 03"));
    EXPECT_EQ(to_bytes(device_.life.blocks[1].bytes()), block);
    ASSERT_EQ(device_.lines.size(), 1u);
    EXPECT_EQ(device_.lines[0].event, Event::parameters_loaded);
    EXPECT_EQ(little_endian(device_.lines[0].detail), Bytes(block.end() - 4, block.end()));
  }
}

TEST_F(TransferTest, ChangesNothingByItself) {
  const ModelLife life = device_.life;
  transfer(0, extended_block());
  EXPECT_EQ(device_.life, life);
  EXPECT_TRUE(device_.lines.empty());
  EXPECT_EQ(server_->counts(), uds::AuthorityCounts{});
}

TEST_F(TransferTest, IsProvenOverEveryByte) {
  const Bytes block = extended_block();
  for (std::size_t at = 0; at < block.size(); ++at) {
    device_.lines.clear();
    restart();
    Bytes other = block;
    other[at] ^= std::byte{1};
    transfer(1, other);
    const ModelLife life = device_.life;
    EXPECT_EQ(ask(start_request(load_order(block))), hex("7f 31 35")) << at;
    EXPECT_EQ(device_.life, life);
    EXPECT_EQ(device_.lines.back().event, Event::wrong_mac);
  }
}

TEST_F(TransferTest, IsUsedOnceAndForItsTendon) {
  const Bytes block = extended_block();
  EXPECT_EQ(ask(start_request(load_order(block))), hex("7f 31 24"));
  transfer(1, block);
  EXPECT_EQ(ask(start_request(load_order(block, 0))), hex("7f 31 24"));
  EXPECT_EQ(ask(start_request(load_order(block))), hex("71 01 02 03"));
  EXPECT_EQ(ask(start_request(load_order(block))), hex("7f 31 24"));
  EXPECT_EQ(device_.lines.back().event, Event::rejected);
  EXPECT_EQ(device_.lines.back().detail, 0x0203u);
  EXPECT_EQ(server_->gate().failures(), 0u);
}

TEST_F(TransferTest, OfWhatTheNodeCannotEvaluateIsRefusedWithTheReason) {
  device_.refused_effects = 1u << 11;  // torque_gain
  const Bytes block = extended_block();
  const Bytes crc(block.end() - 4, block.end());
  transfer(1, block);
  const ModelLife life = device_.life;
  EXPECT_EQ(ask(start_request(load_order(block))), hex("7f 31 31"));
  EXPECT_EQ(device_.life, life);
  EXPECT_EQ(device_.lines.back().event, Event::parameters_refused);
  EXPECT_EQ(little_endian(device_.lines.back().detail), crc);
  // Effect 11 needs the temperature of the winding.
  EXPECT_EQ(ask(hex("22 02 61")), hex("62 02 61 01 05 0b 04") + crc);
  EXPECT_EQ(ask(hex("22 02 60")), hex("62 02 60 01 00 00 00 00 00 00 00"));
}

TEST_F(TransferTest, ThatIsRefusedHasALineEachTime) {
  device_.refused_effects = 1u << 11;
  const Bytes block = extended_block();
  for (std::size_t lines = 1; lines < 4; ++lines) {
    transfer(1, block);
    EXPECT_EQ(ask(start_request(load_order(block))), hex("7f 31 31"));
    EXPECT_EQ(device_.lines.size(), lines);
  }
  EXPECT_EQ(server_->gate().failures(), 0u);
}

TEST_F(TransferTest, OfAnExtensionThatDoesNotHoldIsRefused) {
  Bytes block = extended_block();
  block[100] ^= std::byte{1};
  transfer(1, block);
  EXPECT_EQ(ask(start_request(load_order(block))), hex("7f 31 31"));
  EXPECT_EQ(ask(hex("22 02 61")),
            hex("62 02 61 01 03 00 00") + Bytes(block.end() - 4, block.end()));
}

TEST_F(TransferTest, APartThatIsSentAgainIsAnsweredAgain) {
  const Bytes block = extended_block();
  const Bytes first(block.begin(), block.begin() + 100);
  const Bytes rest(block.begin() + 100, block.begin() + 200);
  ASSERT_EQ(ask(download(1, 200)), hex("74 20 00 91"));
  EXPECT_EQ(ask(part(1, first)), hex("76 01"));
  EXPECT_EQ(ask(part(1, first)), hex("76 01"));
  EXPECT_EQ(ask(part(2, rest)), hex("76 02"));
  EXPECT_EQ(ask(part(2, rest)), hex("76 02"));
  EXPECT_EQ(ask(hex("37")), hex("77"));
}

TEST_F(TransferTest, RefusesWhatIsOutOfOrder) {
  EXPECT_EQ(ask(part(1, hex("00"))), hex("7f 36 24"));
  EXPECT_EQ(ask(hex("37")), hex("7f 37 24"));
  ASSERT_EQ(ask(download(1, 84)), hex("74 20 00 91"));
  EXPECT_EQ(ask(part(0, hex("00"))), hex("7f 36 73"));
  EXPECT_EQ(ask(part(2, hex("00"))), hex("7f 36 73"));
  EXPECT_EQ(ask(part(1, counting(85))), hex("7f 36 71"));
  EXPECT_EQ(ask(part(1, counting(83))), hex("76 01"));
  EXPECT_EQ(ask(hex("37")), hex("7f 37 24"));
  EXPECT_EQ(ask(part(2, counting(2))), hex("7f 36 71"));
  EXPECT_EQ(ask(part(2, counting(1))), hex("76 02"));
  EXPECT_EQ(ask(hex("37 00")), hex("7f 37 13"));
  EXPECT_EQ(ask(hex("37")), hex("77"));
  EXPECT_EQ(ask(part(3, hex("00"))), hex("7f 36 24"));
  EXPECT_EQ(ask(hex("36 01")), hex("7f 36 13"));
}

TEST_F(TransferTest, RefusesWhatCannotBeABlock) {
  EXPECT_EQ(ask(download(1, 83)), hex("7f 34 31"));
  EXPECT_EQ(ask(download(1, 617)), hex("7f 34 31"));
  EXPECT_EQ(ask(download(2, 84)), hex("7f 34 31"));
  EXPECT_EQ(ask(hex("34 10 21 01 00 54")), hex("7f 34 31"));
  EXPECT_EQ(ask(hex("34 00 44 01 00 54")), hex("7f 34 31"));
  EXPECT_EQ(ask(hex("34 00 21 01 00")), hex("7f 34 13"));
  EXPECT_EQ(ask(download(1, 616)), hex("74 20 00 91"));
  restart(authority::Key{});
  EXPECT_EQ(ask(download(1, 84)), hex("7f 34 33"));
}

}  // namespace
}  // namespace protocol::testing
