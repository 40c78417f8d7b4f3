#include "host_sim/report/replay/verdict.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace host_sim {
namespace {

ReplayReport worn(double damage, double b10) {
  ReplayReport report;
  report.duration_s = 60;
  report.cycles = {20, 2};
  report.damage.total = damage;
  report.repeats_to.B10 = b10;
  return report;
}

TEST(Verdict, CountsWholeRepeats) {
  EXPECT_EQ(verdict(worn(0.021, 38.97)),
            "This profile, 60\u00a0s long, uses 2.1\u00a0% of the wire's life; it can be repeated "
            "38 times until 10\u00a0% of wires have broken (B10).");
  EXPECT_EQ(verdict(worn(0.5, 1.4)),
            "This profile, 60\u00a0s long, uses 50\u00a0% of the wire's life; it can be repeated "
            "once until 10\u00a0% of wires have broken (B10).");
}

TEST(Verdict, SpeaksInPowersOfTenWhereNobodyCounts) {
  EXPECT_EQ(verdict(worn(2.1e-9, 3.26e8)),
            "This profile, 60\u00a0s long, uses 2.1×10⁻⁹ of the wire's life; it can be repeated "
            "3.26×10⁸ times until 10\u00a0% of wires have broken (B10).");
}

TEST(Verdict, SaysWhenOnePassIsTooMuch) {
  ReplayReport report = worn(1.25, 0.5);
  report.survival_probability = 0.023;
  EXPECT_EQ(verdict(report),
            "This profile, 60\u00a0s long, uses 125\u00a0% of the wire's life; only 2.3\u00a0% of "
            "wires survive one pass.");
  report.damage.total = 1250;
  report.survival_probability = 0;
  EXPECT_EQ(verdict(report),
            "This profile, 60\u00a0s long, uses 1250 times the wire's life; only 0\u00a0% of wires "
            "survive one pass.");
}

TEST(Verdict, SaysWhenNothingIsUsed) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ReplayReport idle = worn(0, kInfinity);
  EXPECT_EQ(verdict(idle),
            "This profile, 60\u00a0s long, uses too little of the wire's life to measure.");
  idle.cycles = {};
  EXPECT_EQ(verdict(idle),
            "This profile, 60\u00a0s long, holds no load cycle and uses none of the wire's life.");
}

TEST(Verdict, SaysWhenTheDamageIsUnknown) {
  EXPECT_EQ(verdict(worn(std::numeric_limits<double>::quiet_NaN(), 0)),
            "This profile, 60\u00a0s long, uses an amount of the wire's life that could not be "
            "worked out.");
}

}  // namespace
}  // namespace host_sim
