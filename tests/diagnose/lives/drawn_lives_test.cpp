// Lives at the quantiles of a law, as even as a sample can be: what is found is no luck of a draw.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "tests/diagnose/lives/texts.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::HasSubstr;
using Quantile = std::function<double(double p)>;

Quantile weibull(double alpha, double shape) {
  return [=](double p) { return alpha * std::pow(-std::log1p(-p), 1 / shape); };
}

/// Where a survival that falls is 1 - p.
Quantile of_survival(const std::function<double(double)>& survival) {
  return [=](double p) {
    double low = 1;
    double high = 1e9;
    for (int i = 0; i < 100; ++i) {
      const double middle = std::sqrt(low * high);
      (survival(middle) > 1 - p ? low : high) = middle;
    }
    return low;
  };
}

std::vector<double> lives_of(std::size_t count, const Quantile& quantile) {
  std::vector<double> lives;
  for (std::size_t i = 0; i < count; ++i) {
    lives.push_back(quantile((static_cast<double>(i) + 0.5) / static_cast<double>(count)));
  }
  return lives;
}

class Specimens {
 public:
  void add(double tension_N, int lot, const std::vector<double>& lives) {
    for (const double cycles : lives) {
      text_ += fmt::format("s{},{},0,{},{:.0f},failed,fit\n", number_++, lot, tension_N, cycles);
    }
  }

  [[nodiscard]] LifeDiagnosis diagnosis() const {
    return diagnose_lives(lives::test::campaign_of(text_), {});
  }

 private:
  std::string text_ = lives::test::kHeader;
  int number_ = 100;
};

Findings of_one_level(const std::vector<std::vector<double>>& lives) {
  Specimens specimens;
  for (const std::vector<double>& some : lives) {
    specimens.add(50, 1, some);
  }
  return specimens.diagnosis().findings;
}

TEST(DiagnoseOneLevel, ASampleOfOneModeShowsNone) {
  for (const double shape : {2.0, 5.94, 9.0}) {
    Specimens specimens;
    specimens.add(50, 1, lives_of(40, weibull(1e5, shape)));
    const LifeDiagnosis diagnosis = specimens.diagnosis();
    EXPECT_EQ(diagnosis.findings.verdict, Verdict::none) << shape;
    EXPECT_EQ(diagnosis.findings.candidates.front().id, "none") << shape;
    EXPECT_NEAR(diagnosis.ipl_exponent, 1.38, 1e-9);
    EXPECT_THAT(diagnosis.findings.prose, HasSubstr("gamma is that of the model"));
  }
}

TEST(DiagnoseOneLevel, NamesAModeThatAPartOfTheSpecimensHas) {
  const Findings findings =
      of_one_level({lives_of(16, weibull(1e5, 5.94)), lives_of(14, weibull(1.5e4, 4))});
  ASSERT_EQ(findings.verdict, Verdict::named) << findings.prose;
  ASSERT_EQ(findings.effects.size(), 1U);
  EXPECT_EQ(findings.effects[0].id, "second_mode");
  const std::vector<Estimate>& parameters = findings.effects[0].parameters;
  EXPECT_LT(parameters.at(0).low, std::log(0.15));
  EXPECT_GT(parameters.at(0).high, std::log(0.15));
  EXPECT_EQ(parameters.at(2).name, "second_share");
  EXPECT_NEAR(parameters.at(2).value, 14.0 / 30, 0.05);
  ASSERT_EQ(findings.extensions.size(), 1U);
  EXPECT_EQ(findings.extensions[0].values.size(), 4U);
}

// R = exp(-(n/1e5)^9 - (n/1e5)^1.5) in each specimen; which of both is called the second is free.
TEST(DiagnoseOneLevel, NamesAModeThatCompetesInEachSpecimen) {
  Specimens specimens;
  specimens.add(50, 1, lives_of(96, of_survival([](double n) {
                                  return std::exp(-std::pow(n / 1e5, 9) - std::pow(n / 1e5, 1.5));
                                })));
  const LifeDiagnosis diagnosis = specimens.diagnosis();
  const Findings& findings = diagnosis.findings;
  ASSERT_EQ(findings.verdict, Verdict::named) << findings.prose;
  ASSERT_EQ(findings.effects.size(), 1U);
  EXPECT_EQ(findings.effects[0].id, "second_mode");
  const double second_shape = 1.28255 / findings.effects[0].parameters.at(1).value;
  EXPECT_NEAR(std::min(diagnosis.weibull_shape, second_shape), 1.5, 0.2);
  EXPECT_NEAR(std::max(diagnosis.weibull_shape, second_shape), 9, 1.5);
  EXPECT_NEAR(findings.effects[0].parameters.at(0).value, 0, 0.2);
}

TEST(DiagnoseOneLevel, FewEarlyDeathsAndOtherDistributionsAreNoMode) {
  const Findings early =
      of_one_level({lives_of(36, weibull(1e5, 5.94)), lives_of(4, weibull(1.5e4, 5.94))});
  EXPECT_EQ(early.candidates.front().id, "unknown");
  EXPECT_EQ(early.verdict, Verdict::unknown);
  const Findings lognormal =
      of_one_level({lives_of(60, of_survival([](double n) {
                               return std::erfc(std::log(n / 1e5) / 0.3 / std::numbers::sqrt2) / 2;
                             }))});
  EXPECT_EQ(lognormal.candidates.front().id, "unknown");
  EXPECT_NE(lognormal.verdict, Verdict::named);
}

TEST(DiagnoseLots, NamesLotsThatDifferTenfold) {
  for (const std::vector<double>& factors :
       {std::vector<double>{1, 10}, std::vector<double>{0.3, 1, 3, 10}}) {
    Specimens specimens;
    for (const double tension_N : {30.0, 40.0, 55.0, 75.0}) {
      for (std::size_t lot = 0; lot < factors.size(); ++lot) {
        const double alpha = 1.53e7 * std::pow(tension_N, -1.38) * factors[lot];
        specimens.add(tension_N, static_cast<int>(lot), lives_of(4, weibull(alpha, 5.94)));
      }
    }
    const Findings findings = specimens.diagnosis().findings;
    ASSERT_EQ(findings.verdict, Verdict::named) << findings.prose;
    ASSERT_EQ(findings.effects.size(), 1U) << findings.prose;
    EXPECT_EQ(findings.effects[0].id, "lot_frailty");
    // Of two lots ln 10 apart ln 10/2 = 1.15, of the four 1.29.
    EXPECT_LT(findings.effects[0].parameters.at(0).low, 1.15);
    EXPECT_GT(findings.effects[0].parameters.at(0).high, 1.29);
  }
}

}  // namespace
}  // namespace host_sim::diagnose
