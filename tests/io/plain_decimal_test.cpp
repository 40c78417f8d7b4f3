#include "hal/files/plain_decimal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <random>
#include <string>

namespace hal::files {
namespace {

struct Parsed {
  bool taken;
  double value;
  std::size_t length;
};

Parsed parsed(std::string text) {
  text += ",........";
  const char* at = text.data();
  double value = -7;
  const bool taken = parse_plain_decimal(at, value, ',');
  return {taken, value, static_cast<std::size_t>(at - text.data())};
}

double correctly_rounded(const std::string& text) {
  double value = 0;
  EXPECT_EQ(std::from_chars(text.data(), text.data() + text.size(), value).ec, std::errc()) << text;
  return value;
}

void expect_exact(const std::string& text) {
  const Parsed result = parsed(text);
  ASSERT_TRUE(result.taken) << text;
  ASSERT_EQ(result.length, text.size());
  ASSERT_EQ(std::bit_cast<std::uint64_t>(result.value),
            std::bit_cast<std::uint64_t>(correctly_rounded(text)))
      << text;
}

TEST(PlainDecimal, IsCorrectlyRounded) {
  for (const char* text : {"0",
                           "-0",
                           "0.0",
                           "-0.000",
                           "1",
                           "9",
                           "10",
                           "12345678",
                           "123456789",
                           "9999999.99999999",
                           "123456789012345",
                           "0.1",
                           "0.3",
                           "2.675",
                           "-1.005",
                           "0.00000000000001",
                           "00012.5000",
                           "900719925474099.2",
                           "9.007199254740992",
                           "4503599627.370497",
                           "38.123456789",
                           "1234567.12345678",
                           "12345678.1",
                           "0.12345678",
                           "0.123456789"}) {
    expect_exact(text);
  }
}

TEST(PlainDecimal, AnyOtherIsLeftAlone) {
  for (const char* text : {"",
                           "-",
                           "+1",
                           ".5",
                           "5.",
                           "-.5",
                           "1e3",
                           "1.5e-3",
                           "1.5E3",
                           "inf",
                           "nan",
                           "0x10",
                           " 1",
                           "1 ",
                           "--1",
                           "1.2.3",
                           "9007199254740992",
                           "1;",
                           "9007199254740993",
                           "12345678901234567890",
                           "1.2345678901234567",
                           "0.1234567890123456",
                           "1x"}) {
    const Parsed result = parsed(text);
    EXPECT_FALSE(result.taken) << text;
    EXPECT_EQ(result.length, 0U) << text;
    EXPECT_EQ(result.value, -7) << text;
  }
}

TEST(PlainDecimal, EndsWhereAFieldDoes) {
  for (const char end : {',', '\n', '\r', '"'}) {
    const std::string text = std::string("12.5") + end + "34567890";
    const char* at = text.data();
    double value = 0;
    EXPECT_TRUE(parse_plain_decimal(at, value, ','));
    EXPECT_EQ(at, text.data() + 4);
    EXPECT_EQ(value, 12.5);
  }
  const std::string other = "12.5;34567890";
  const char* at = other.data();
  double value = 0;
  EXPECT_FALSE(parse_plain_decimal(at, value, ','));
  EXPECT_TRUE(parse_plain_decimal(at, value, ';'));
  EXPECT_EQ(value, 12.5);
}

TEST(PlainDecimal, RandomOnesAreCorrectlyRounded) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300'000; ++i) {
    const auto whole_digits = 1 + random() % 9;
    const auto decimals = random() % std::min<std::uint64_t>(15, 16 - whole_digits);
    std::string text = random() % 2 == 0 ? "-" : "";
    for (std::uint64_t k = 0; k < whole_digits + decimals; ++k) {
      text += k == whole_digits ? "." : "";
      text += static_cast<char>('0' + random() % 10);
    }
    if (parsed(text).taken) {
      expect_exact(text);
    } else {
      // Beyond 2^53, where not each whole number is a double.
      std::erase_if(text, [](char c) { return c < '0' || c > '9'; });
      ASSERT_GT(std::stoull(text), std::uint64_t{1} << 53);
    }
  }
}

}  // namespace
}  // namespace hal::files
