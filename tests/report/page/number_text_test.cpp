#include "host_sim/report/page/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace host_sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(NumberText, RoundsToSignificantDigitsWithoutTrailingZeros) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(38.24), "38.2");
  EXPECT_EQ(number_text(60), "60");
  EXPECT_EQ(number_text(0.02103), "0.021");
  EXPECT_EQ(number_text(99.96), "100");
  EXPECT_EQ(number_text(3.14159265, 6), "3.14159");
  EXPECT_EQ(number_text(-0.5), "\u22120.5");
}

TEST(NumberText, GroupsThousands) {
  EXPECT_EQ(number_text(1234.6), "1235");
  EXPECT_EQ(number_text(12345.6), "12\u202f346");
  EXPECT_EQ(number_text(12345.678, 7), "12\u202f345.68");
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(1'234'567), "1\u202f234\u202f567");
  EXPECT_EQ(count_text(std::numeric_limits<std::uint64_t>::max()),
            "18\u202f446\u202f744\u202f073\u202f709\u202f551\u202f615");
}

TEST(NumberText, CountsWithTheirNoun) {
  EXPECT_EQ(counted_text(0, "sample"), "0\u00a0samples");
  EXPECT_EQ(counted_text(1, "sample"), "1\u00a0sample");
  EXPECT_EQ(counted_text(999'999'999, "sample"), "999\u202f999\u202f999\u00a0samples");
  EXPECT_EQ(counted_text(4'120'000'000'000, "sample"), "4.12×10¹²\u00a0samples");
}

TEST(NumberText, UsesPowersOfTenOutsideThePlainRange) {
  EXPECT_EQ(number_text(2.1e-7), "2.1×10⁻⁷");
  EXPECT_EQ(number_text(0.0009996), "0.001");
  EXPECT_EQ(number_text(0.000999), "9.99×10⁻⁴");
  EXPECT_EQ(number_text(999'999.6), "1×10⁶");
  EXPECT_EQ(number_text(-1.5e300), "\u22121.5×10³⁰⁰");
}

TEST(NumberText, SaysWhatIsNotANumber) {
  EXPECT_EQ(number_text(kInfinity), "unlimited");
  EXPECT_EQ(number_text(-kInfinity), "unlimited below zero");
  EXPECT_EQ(quantity_text(std::numeric_limits<double>::quiet_NaN(), "N"), "not defined");
}

TEST(NumberText, PutsUnitsBehindANoBreakSpace) {
  EXPECT_EQ(quantity_text(39.9, "N"), "39.9\u00a0N");
  EXPECT_EQ(quantity_text(0.128, ""), "0.128");
}

TEST(NumberText, PercentagesDoNotRoundUpToCertainty) {
  EXPECT_EQ(percent_text(0.021), "2.1\u00a0%");
  EXPECT_EQ(percent_text(0), "0\u00a0%");
  EXPECT_EQ(percent_text(1), "100\u00a0%");
  EXPECT_EQ(percent_text(0.9996), ">\u00a099.9\u00a0%");
  EXPECT_EQ(percent_text(1 - 1e-12), ">\u00a099.9\u00a0%");
  EXPECT_EQ(percent_text(1e-9), "1×10⁻⁷\u00a0%");
}

TEST(NumberText, DurationsUseTheLargestFittingUnit) {
  EXPECT_EQ(duration_text(0), "0\u00a0s");
  EXPECT_EQ(duration_text(119), "119\u00a0s");
  EXPECT_EQ(duration_text(120), "2\u00a0min");
  EXPECT_EQ(duration_text(9000), "2.5\u00a0h");
  EXPECT_EQ(duration_text(172'800), "2\u00a0days");
  EXPECT_EQ(duration_text(63'115'200), "2\u00a0years");
}

TEST(NumberText, PValuesSayWhatANumberCannot) {
  EXPECT_EQ(p_text(0.0004), "below 0.001");
  EXPECT_EQ(p_text(0.0409), "0.041");
  EXPECT_EQ(p_text(std::numeric_limits<double>::quiet_NaN()), "not computed");
}

}  // namespace
}  // namespace host_sim
