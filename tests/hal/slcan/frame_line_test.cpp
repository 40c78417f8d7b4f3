#include <gtest/gtest.h>

#include <string>

#include "hal/slcan/line.hpp"

namespace hal::slcan {
namespace {

constexpr CanFrame kShort{0x123, false, 3, {std::byte{0x01}, std::byte{0xAB}, std::byte{0xFF}}};
constexpr CanFrame kLong{0x18DAF101,
                         true,
                         8,
                         {std::byte{0x02}, std::byte{0x3E}, std::byte{0}, std::byte{0xAA},
                          std::byte{0xAA}, std::byte{0xAA}, std::byte{0xAA}, std::byte{0xAA}}};

TEST(FrameLine, IsWhatTheManualPrints) {
  EXPECT_EQ(format({kShort, false}).view(), "t123301ABFF\r");
  EXPECT_EQ(format({kLong, false}).view(), "T18DAF1018023E00AAAAAAAAAA\r");
  EXPECT_EQ(format({{0x001, false, 0, {}}, false}).view(), "t0010\r");
  EXPECT_EQ(format({{0x7ff, false, 8, {}}, true}).view(), "r7FF8\r");
  EXPECT_EQ(format({{0x1fffffff, true, 2, {}}, true}).view(), "R1FFFFFFF2\r");
}

TEST(FrameLine, IsReadInBothCasesOfDigits) {
  EXPECT_EQ(parse_frame("t123301ABFF"), (FrameLine{kShort, false}));
  EXPECT_EQ(parse_frame("t123301abff"), (FrameLine{kShort, false}));
  EXPECT_EQ(parse_frame("T18daf1018023e00aaaaaaaaaa"), (FrameLine{kLong, false}));
  EXPECT_EQ(parse_frame("r7FF8"), (FrameLine{{0x7ff, false, 8, {}}, true}));
  EXPECT_EQ(parse_frame("R000000010"), (FrameLine{{1, true, 0, {}}, true}));
}

class Malformed : public testing::TestWithParam<const char*> {};

TEST_P(Malformed, IsRefused) {
  EXPECT_FALSE(parse_frame(GetParam()).has_value());
}

INSTANTIATE_TEST_SUITE_P(Lines, Malformed,
                         testing::Values("", "t", "t1", "t123", "x1230", "t8000", "tFFF0",
                                         "T200000000", "TFFFFFFFF0", "t1239000000000000000000",
                                         "t123A", "t1231", "t12310", "t1231000", "t12g0", "t 1230",
                                         "t-010", "t123-", "t1231 0", "t12310g", "T123456781",
                                         "T12345678", "r12310", "r1239", "R0000000", "t12300",
                                         "t1230\n", "t12\r0", "T00x000000"));

TEST(FrameLine, EveryIdOfElevenBitsComesBack) {
  for (std::uint32_t id = 0; id <= kHighestStandardId; ++id) {
    const FrameLine line{{id, false, 1, {std::byte{0x5a}}}, false};
    const std::string text(format(line).view());
    EXPECT_EQ(parse_frame(text.substr(0, text.size() - 1)), line);
  }
}

}  // namespace
}  // namespace hal::slcan
