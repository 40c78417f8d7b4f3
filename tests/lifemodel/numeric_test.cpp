#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "lifemodel/numeric/logarithm.hpp"
#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/numeric/sine.hpp"

namespace lifemodel::numeric {
namespace {

TEST(Log2, EveryMantissaIsWithinTheStatedErrorAndNeverFalls) {
  double worst = 0;
  std::uint32_t previous = 0;
  for (std::uint32_t mantissa = 1u << 26; mantissa < 1u << 27; ++mantissa) {
    const std::uint32_t result = log2_mantissa(mantissa);
    ASSERT_GE(result, previous) << mantissa;
    previous = result;
    worst =
        std::max(worst, std::fabs(std::ldexp(result, -26) - std::log2(std::ldexp(mantissa, -26))));
  }
  EXPECT_LE(worst, kLog2MaxError);
  EXPECT_GE(worst, kLog2MaxError / 2) << "the stated error is not the error";
}

TEST(Exp2, EveryFractionIsWithinTheStatedErrorAndGrows) {
  double worst = 0;
  std::uint32_t previous = 0;
  for (std::uint32_t fraction = 0; fraction < 1u << 21; ++fraction) {
    const std::uint32_t result = exp2_fraction(fraction);
    ASSERT_GT(result, previous) << fraction;
    previous = result;
    worst = std::max(worst,
                     std::fabs(std::ldexp(result, -31) / std::exp2(std::ldexp(fraction, -21)) - 1));
  }
  EXPECT_LE(worst, kExp2MaxRelativeError);
  EXPECT_GE(worst, kExp2MaxRelativeError / 4) << "the stated error is not the error";
}

TEST(Log2, ExactAtPowersOfTwo) {
  EXPECT_EQ(log2({1u << 26, 0}), 0);
  EXPECT_EQ(log2({1u << 26, -31}), -31 * (1 << 26));
  EXPECT_EQ(log2({1u << 26, 20}), 20 * (1 << 26));
}

__extension__ using Wide = unsigned __int128;

/// floor(numerator / denominator) to 27 significant bits by long division of 128-bit numbers.
Normal exact_quotient(std::uint32_t numerator, std::uint64_t denominator) {
  int exponent = -66;
  Wide n = Wide{numerator} << 92;
  while ((n / denominator) >> 27 != 0) {
    n >>= 1;
    ++exponent;
  }
  return {static_cast<std::uint32_t>(n / denominator), exponent};
}

void expect_exact(std::uint32_t numerator, std::uint64_t denominator) {
  const Normal exact = exact_quotient(numerator, denominator);
  const Normal ours = quotient(numerator, denominator);
  ASSERT_EQ(ours.mantissa, exact.mantissa) << numerator << " / " << denominator;
  ASSERT_EQ(ours.exponent, exact.exponent) << numerator << " / " << denominator;
}

TEST(Quotient, IsExactForRandomOperandsOfEveryLength) {
  std::mt19937_64 random(20250101);
  for (int i = 0; i < 2'000'000; ++i) {
    const auto numerator = static_cast<std::uint32_t>(random() >> (32 + random() % 32)) | 1u;
    const std::uint64_t denominator = (random() >> (random() % 60)) | 1u;
    expect_exact(numerator, denominator);
  }
}

TEST(Quotient, IsExactAtTheEdges) {
  const std::uint64_t top = ~std::uint64_t{0};
  for (const std::uint32_t n :
       {1u, 2u, 3u, 0x7fffffffu, 0x80000000u, 0x80000001u, 0xfffffffeu, 0xffffffffu}) {
    for (const std::uint64_t d :
         {std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{3}, std::uint64_t{0xffffffff},
          std::uint64_t{1} << 32, (std::uint64_t{1} << 32) + 1, std::uint64_t{1} << 63,
          (std::uint64_t{1} << 63) + 1, top - 1, top, top << 32, (top << 32) + 1, std::uint64_t{n},
          std::uint64_t{n} * n}) {
      expect_exact(n, d);
    }
  }
}

TEST(Sine, IsWithinTheStatedErrorAllTheWayRound) {
  double worst = 0;
  constexpr std::uint32_t kStep = 4099;  // a prime
  for (std::uint64_t phase = 0; phase < std::uint64_t{1} << 32; phase += kStep) {
    const auto narrow = static_cast<Phase>(phase);
    const double angle_rad = 2 * std::numbers::pi * std::ldexp(static_cast<double>(phase), -32);
    worst = std::max(worst, std::fabs(std::ldexp(sine(narrow), -30) - std::sin(angle_rad)));
    worst = std::max(worst, std::fabs(std::ldexp(cosine(narrow), -30) - std::cos(angle_rad)));
  }
  EXPECT_LE(worst, kSineMaxError);
  EXPECT_GE(worst, kSineMaxError / 4) << "the stated error is not the error";
}

TEST(Sine, IsExactAtQuarterTurns) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(sine(2 * kQuarterTurn), 0);
  EXPECT_NEAR(sine(kQuarterTurn), 1 << 30, 64);
  EXPECT_NEAR(sine(3 * kQuarterTurn), -(1 << 30), 64);
}

}  // namespace
}  // namespace lifemodel::numeric
