#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string_view>

#include "firmware/protocol/isotp/link.hpp"
#include "tests/protocol/services/bytes.hpp"
#include "tests/protocol/services/frames.hpp"

namespace protocol::isotp {

using protocol::testing::Bytes;
using protocol::testing::counting;
using protocol::testing::frame;
using protocol::testing::hex;
using protocol::testing::to_bytes;

inline constexpr std::uint32_t kIn = 0x18DA05F1;
inline constexpr std::uint32_t kOut = 0x18DAF105;

/// The link of node 5; the tester is played by hand.
class LinkTest : public ::testing::Test {
 protected:
  void hear(std::string_view data) { link_.on_frame(frame(kIn, data), now_); }
  std::optional<hal::CanFrame> next() { return link_.next_frame(now_); }
  void expect_next(std::string_view data) { EXPECT_EQ(next(), frame(kOut, data)); }
  void expect_silence() { EXPECT_EQ(next(), std::nullopt); }
  void wait(hal::Time time) { now_ = now_ + time; }
  Bytes received() const { return to_bytes(link_.received()); }
  /// That the link still does its work.
  void expect_usable() {
    link_.clear();
    hear("10 0a 00 01 02 03 04 05");
    expect_next("30 00 05");
    hear("21 06 07 08 09");
    EXPECT_EQ(received(), counting(10));
  }

  hal::Time now_ = hal::seconds(7);
  Link<20> link_{Address::to_tester(5)};
};

}  // namespace protocol::isotp
