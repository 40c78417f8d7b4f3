#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "hal/files/text.hpp"

namespace host_sim {

using hal::files::parse_number;

namespace {

std::optional<double> whole_number(std::string_view text) {
  const char* position = text.data();
  const char* const end = position + text.size();
  double value = 0.0;
  if (!parse_number(position, end, value) || position != end) {
    return std::nullopt;
  }
  return value;
}

TEST(ParseNumber, ReadsDecimals) {
  EXPECT_EQ(whole_number("38.5"), 38.5);
  EXPECT_EQ(whole_number("+38.5"), 38.5);
  EXPECT_EQ(whole_number("-.5e-3"), -0.0005);
  EXPECT_EQ(whole_number("1."), 1.0);
  EXPECT_EQ(whole_number("1.53E5"), 153000.0);
}

TEST(ParseNumber, RoundsCorrectly) {
  // Just above half way between two doubles, decided by the last of many digits.
  EXPECT_EQ(whole_number("9007199254740993.00000000000000000000000000000000000000001"),
            9007199254740994.0);
  EXPECT_EQ(whole_number("9007199254740993"), 9007199254740992.0);
}

TEST(ParseNumber, RefusesWhatADoubleCannotHold) {
  EXPECT_EQ(whole_number("1e999"), std::nullopt);
  EXPECT_EQ(whole_number("-1e999"), std::nullopt);
  EXPECT_EQ(whole_number("1e-999"), std::nullopt);
}

TEST(ParseNumber, RefusesWhatIsNotANumber) {
  for (const std::string_view text :
       {"+", "-", ".", "e5", "+-1", "-+1", "++1", " 1", "1 ", "0x10", "1,5", "1e", "x", "1_000"}) {
    EXPECT_EQ(whole_number(text), std::nullopt) << text;
  }
}

RC_GTEST_PROP(ParseNumber, ReadsBackEveryDouble, (std::uint64_t bits)) {
  const auto value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  const auto back = whole_number(fmt::format("{:.17g}", value));
  RC_ASSERT(back.has_value());
  RC_ASSERT(std::bit_cast<std::uint64_t>(*back) == bits);
}

RC_GTEST_PROP(ParseNumber, AgreesWithTheCLibrary,
              (std::uint32_t whole, std::uint32_t fraction, std::int8_t exponent)) {
  const std::string text = fmt::format("{}.{}e{}", whole, fraction, int{exponent});
  RC_ASSERT(whole_number(text) == std::strtod(text.c_str(), nullptr));
}

}  // namespace
}  // namespace host_sim
