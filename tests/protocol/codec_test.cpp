#include "firmware/protocol/codec.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/protocol/frames.hpp"

// Expected bytes are laid out by hand after the frame plan.
namespace protocol {
namespace {

using test::flipped;
using test::frame;

template <class Message>
void expect_both_ways(const Message& message, Node node, const hal::CanFrame& expected) {
  EXPECT_EQ(encode(node, message), expected);
  const Decoded<Message> decoded = decode<Message>(expected);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(*decoded, message);
}

template <class Message>
void expect_error(const hal::CanFrame& received, DecodeError error) {
  const Decoded<Message> decoded = decode<Message>(received);
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error(), error);
}

TEST(Codec, Heartbeat) {
  expect_both_ways(Heartbeat{.state = NmtState::boot_up}, 1, frame(0x701, {0x00}));
  expect_both_ways(Heartbeat{.state = NmtState::stopped}, 1, frame(0x701, {0x04}));
  expect_both_ways(Heartbeat{.state = NmtState::operational}, 127, frame(0x77f, {0x05}));
}

TEST(Codec, LifeStatus) {
  expect_both_ways(LifeStatus{.state = LifeState::replace,
                              .damage_ppb = 0x12345678,
                              .worst_tendon = 17,
                              .quality = Quality::saturated,
                              .storage_ok = true,
                              .gap = true,
                              .locked = true},
                   7, frame(0x187, {0x00, 0x30, 0x78, 0x56, 0x34, 0x12, 0x71, 0x25}));
  expect_both_ways(LifeStatus{.state = LifeState::worn,
                              .damage_ppb = 0xffff'ffff,
                              .worst_tendon = 31,
                              .quality = Quality::untrusted,
                              .sensor_ok = true,
                              .saturated = true,
                              .overrun = true},
                   1, frame(0x181, {0x00, 0x40, 0xff, 0xff, 0xff, 0xff, 0x9f, 0x1a}));
  expect_both_ways(LifeStatus{.state = LifeState::normal, .broken = true}, 1,
                   frame(0x181, {0x00, 0x10, 0, 0, 0, 0, 0, 0x40}));
  expect_both_ways(LifeStatus{.state = LifeState::normal, .slack = true}, 1,
                   frame(0x181, {0x00, 0x10, 0, 0, 0, 0, 0, 0x80}));
  expect_both_ways(LifeStatus{}, 1, frame(0x181, {0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(Codec, Emergency) {
  expect_both_ways(
      Emergency{.code = EmergencyCode::life_worn, .error_register = 0x81, .damage_ppm = 0x0f4240},
      3, frame(0x083, {0x13, 0xff, 0x81, 0x00, 0x00, 0x40, 0x42, 0x0f}));
  expect_both_ways(Emergency{.code = EmergencyCode::tendon_broken, .error_register = 0x21}, 3,
                   frame(0x083, {0x21, 0xff, 0x21, 0, 0, 0, 0, 0}));
  expect_both_ways(Emergency{.code = EmergencyCode::tendon_slack, .error_register = 0x21}, 3,
                   frame(0x083, {0x22, 0xff, 0x21, 0, 0, 0, 0, 0}));
}

TEST(Codec, Command) {
  expect_both_ways(Command{.code = CommandCode::select_page, .argument = 8}, 2,
                   frame(0x202, {0x00, 0x20, 0x08, 0, 0, 0, 0, 0}));
}

TEST(Codec, PagesOfLifeDetail) {
  expect_both_ways(detail::Identity{.schema = 1, .firmware = 0x12, .configuration = 0xcafebabe}, 5,
                   frame(0x285, {0x00, 0x00, 0x01, 0x12, 0xbe, 0xba, 0xfe, 0xca}));
  expect_both_ways(detail::Cycles{.cycles = 0x01020304, .cycles_per_min = 0x0506}, 5,
                   frame(0x285, {0x00, 0x10, 0x04, 0x03, 0x02, 0x01, 0x06, 0x05}));
  expect_both_ways(detail::DamageRate{.ppb_per_h = 0x01020304, .unsaved_ppb = 0x0506}, 5,
                   frame(0x285, {0x00, 0x20, 0x04, 0x03, 0x02, 0x01, 0x06, 0x05}));
  expect_both_ways(detail::Cycles{.cycles = 1}, 5,
                   frame(0x285, {0x00, 0x10, 0x01, 0x00, 0x00, 0x00, 0xff, 0xff}));
  expect_both_ways(detail::DamageRate{.unsaved_ppb = 1}, 5,
                   frame(0x285, {0x00, 0x20, 0xff, 0xff, 0xff, 0xff, 0x01, 0x00}));
  expect_both_ways(
      detail::TendonDamage{.tendon = 3, .damage_ppb = 0x01020304, .state = LifeState::inspect}, 5,
      frame(0x285, {0x00, 0x30, 0x03, 0x04, 0x03, 0x02, 0x01, 0x02}));
  expect_both_ways(
      detail::RainflowBin{
          .tendon = 9, .range_class = 5, .mean_class = 6, .half_cycles = 21, .cycles = 0x01020304},
      5, frame(0x285, {0x00, 0x40, 0xa9, 0xae, 0x04, 0x03, 0x02, 0x01}));
  expect_both_ways(detail::RemainingLife{.b10_dh = 0x0102, .b50_dh = 0x0304}, 5,
                   frame(0x285, {0x00, 0x50, 0x02, 0x01, 0x04, 0x03, 0xff, 0xff}));
  expect_both_ways(detail::Storage{.sequence = 0x010203, .worst_unsaved_ppb = 0x040506}, 5,
                   frame(0x285, {0x00, 0x60, 0x03, 0x02, 0x01, 0x06, 0x05, 0x04}));
  expect_both_ways(
      detail::Timing{
          .worst_jitter_us = 0x0102, .p99_jitter_us = 0x0304, .missed_deadlines = 0x0506},
      5, frame(0x285, {0x00, 0x70, 0x02, 0x01, 0x04, 0x03, 0x06, 0x05}));
  // Tendon 3, broken; 83 %; 300 above 90 %: 2 + 4 * 300 = 0x04b2; 0x0102 minutes.
  expect_both_ways(detail::WireHistory{.tendon = 3,
                                       .broken = true,
                                       .peak_percent = 83,
                                       .event = WireEvent::above_90,
                                       .count = 300,
                                       .below_minimum_min = 0x0102},
                   5, frame(0x285, {0x00, 0xb0, 0x23, 0x53, 0xb2, 0x04, 0x02, 0x01}));
  expect_both_ways(detail::WireHistory{.slack = true, .event = WireEvent::slack, .count = 0x3fff},
                   5, frame(0x285, {0x00, 0xb0, 0x40, 0x00, 0xff, 0xff, 0x00, 0x00}));
  // Tendon 3, limited: 3 + 32 * 3; 0x3ed of the ultimate tension, 0xa1f of the pace.
  expect_both_ways(
      detail::Advice{
          .tendon = 3, .state = AdviceState::limited, .highest_tension = 0x3ed, .pace = 0xa1f},
      5, frame(0x285, {0x00, 0xc0, 0x63, 0xed, 0xf3, 0xa1, 0x00, 0x00}));
  expect_both_ways(detail::Advice{}, 5,
                   frame(0x285, {0x00, 0xc0, 0x00, 0xff, 0xff, 0xff, 0x00, 0x00}));
  expect_both_ways(detail::Bus{.transmit_errors = 1,
                               .receive_errors = 2,
                               .bus_offs = 3,
                               .dropped = 4,
                               .refused = 0x0506},
                   5, frame(0x285, {0x00, 0x80, 0x01, 0x02, 0x03, 0x04, 0x06, 0x05}));
  expect_both_ways(detail::ConditionalLife{.to_10_dh = 0x0102, .to_50_dh = 0x0304}, 5,
                   frame(0x285, {0x00, 0x90, 0x02, 0x01, 0x04, 0x03, 0xff, 0xff}));
  // 8 | 0x1a5 << 8 | 0x2345 << 20 | 0x1f0e << 34
  expect_both_ways(detail::BreakRisk{.horizon_h = 8,
                                     .within_horizon = 0x1a5,
                                     .to_10_low_30min = 0x2345,
                                     .to_10_high_30min = 0x1f0e},
                   5, frame(0x285, {0x00, 0xa0, 0x08, 0xa5, 0x51, 0x34, 0x3a, 0x7c}));
}

TEST(Codec, ValuesThatAreTooWideStop) {
  EXPECT_EQ(encode(1, LifeStatus{.worst_tendon = 32}).data[6], std::byte{0x1f});
  EXPECT_EQ(decode<LifeStatus>(encode(1, LifeStatus{.worst_tendon = 255}))->worst_tendon, 31);
  EXPECT_EQ(decode<Emergency>(encode(1, Emergency{.damage_ppm = 0x1000000}))->damage_ppm,
            0xffffffu);
  const auto storage = decode<detail::Storage>(
      encode(1, detail::Storage{.sequence = 0xffffffff, .worst_unsaved_ppb = 0x1000000}));
  EXPECT_EQ(*storage, (detail::Storage{.sequence = 0xffffff, .worst_unsaved_ppb = 0xffffff}));
  const auto bin = decode<detail::RainflowBin>(encode(
      1,
      detail::RainflowBin{.tendon = 99, .range_class = 8, .mean_class = 200, .half_cycles = 32}));
  EXPECT_EQ(*bin, (detail::RainflowBin{
                      .tendon = 31, .range_class = 7, .mean_class = 7, .half_cycles = 31}));
}

TEST(Codec, OtherFramesAreTold) {
  expect_error<Heartbeat>(frame(0x700, {0x05}), DecodeError::other_frame);
  expect_error<Emergency>(frame(0x080, {0, 0, 0, 0, 0, 0, 0, 0}), DecodeError::other_frame);
  expect_error<LifeStatus>(frame(0x201, {0, 0, 0, 0, 0, 0, 0, 0}), DecodeError::other_frame);
  expect_error<LifeStatus>(frame(0x581, {0, 0, 0, 0, 0, 0, 0, 0}), DecodeError::other_frame);
  hal::CanFrame extended = frame(0x181, {0, 0, 0, 0, 0, 0, 0, 0});
  extended.extended = true;
  expect_error<LifeStatus>(extended, DecodeError::other_frame);
  extended.id = 0x18da'0181;
  expect_error<LifeStatus>(extended, DecodeError::other_frame);
}

TEST(Codec, WrongLengthsAreTold) {
  expect_error<Heartbeat>(frame(0x701, {}), DecodeError::wrong_length);
  expect_error<Heartbeat>(frame(0x701, {0x05, 0x00}), DecodeError::wrong_length);
  expect_error<LifeStatus>(frame(0x181, {0, 0, 0, 0, 0, 0, 0}), DecodeError::wrong_length);
}

TEST(Codec, OtherPagesAreTold) {
  expect_error<detail::Cycles>(frame(0x281, {0, 0x20, 0, 0, 0, 0, 0, 0}), DecodeError::other_page);
  expect_error<detail::Bus>(frame(0x281, {0, 0x90, 0, 0, 0, 0, 0, 0}), DecodeError::other_page);
}

TEST(Codec, BitsAndValuesWithoutMeaningAreTold) {
  const hal::CanFrame tendon = encode(1, detail::TendonDamage{});
  for (const std::size_t bit : {21u, 23u, 60u, 63u}) {
    expect_error<detail::TendonDamage>(flipped(tendon, bit), DecodeError::reserved_bit);
  }
  const hal::CanFrame command = encode(1, Command{});
  for (std::size_t bit = 24; bit < 64; ++bit) {
    expect_error<Command>(flipped(command, bit), DecodeError::reserved_bit);
  }
  expect_error<Emergency>(flipped(encode(1, Emergency{}), 36), DecodeError::reserved_bit);
  expect_error<LifeStatus>(frame(0x181, {0, 0x50, 0, 0, 0, 0, 0, 0}), DecodeError::reserved_value);
  expect_error<LifeStatus>(frame(0x181, {0, 0, 0, 0, 0, 0, 0xa0, 0}), DecodeError::reserved_value);
  expect_error<Command>(frame(0x201, {0, 0x00, 0, 0, 0, 0, 0, 0}), DecodeError::reserved_value);
  expect_error<Command>(frame(0x201, {0, 0x40, 0, 0, 0, 0, 0, 0}), DecodeError::reserved_value);
  expect_error<Emergency>(frame(0x081, {0x01, 0, 0, 0, 0, 0, 0, 0}), DecodeError::reserved_value);
  expect_error<Heartbeat>(frame(0x701, {0x7f}), DecodeError::reserved_value);
}

TEST(Codec, HeaderDoesNotMatterToTheContent) {
  EXPECT_EQ(*decode<LifeStatus>(frame(0x181, {0xa5, 0x1f, 1, 0, 0, 0, 0, 0})),
            (LifeStatus{.state = LifeState::normal, .damage_ppb = 1}));
  EXPECT_EQ(*decode<Emergency>(frame(0x081, {0, 0, 0, 0xa5, 0x0f, 1, 0, 0})),
            (Emergency{.damage_ppm = 1}));
}

TEST(Codec, NodesAreFoundInIdentifiers) {
  EXPECT_EQ(node_of<LifeStatus>(frame(0x1ff, {})), Node{127});
  EXPECT_EQ(node_of<LifeStatus>(frame(0x180, {})), std::nullopt);
  EXPECT_EQ(node_of<LifeStatus>(frame(0x981, {})), std::nullopt);
}

}  // namespace
}  // namespace protocol
