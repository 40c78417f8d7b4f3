#include "host_sim/diagnose/lives/likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "host_sim/diagnose/lives/life_sample.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// A specimen under one fully reversed load, where T_eff is the amplitude.
LifeSample::Specimen reversed(double tension_N, double cycles, bool failed = true) {
  LifeSample::Specimen specimen;
  specimen.blocks = {{.mean_N = 0,
                      .amplitude_N = tension_N,
                      .effective_N = tension_N,
                      .cycles = cycles,
                      .level = 0,
                      .wire_to_bend_ratio = 0}};
  specimen.failed = failed;
  return specimen;
}

/// A sample of these specimens; `centre_N` is where ln_life_at_centre is.
LifeSample sample_with(std::vector<LifeSample::Specimen> specimens, double centre_N) {
  LifeSample sample;
  sample.specimens = std::move(specimens);
  sample.levels = sample.loads = sample.lots = sample.groups = 1;
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    sample.lots = std::max(sample.lots, specimen.lot_number + 1);
  }
  sample.lowest_N = sample.highest_N = centre_N;
  sample.ultimate_tension_N = 177.4;
  sample.reference =
      std::make_shared<const std::vector<LifeSample::Specimen>>(std::vector{reversed(centre_N, 1)});
  return sample;
}

/// alpha = 1000 cycles at 50 N, gamma 2, beta 3.
LifeSettings law() {
  LifeSettings settings;
  settings.ln_life_at_centre = std::log(1000);
  settings.exponent = 2;
  settings.shape = 3;
  return settings;
}

double of_one(const LifeSample::Specimen& specimen, const LifeSettings& settings) {
  return log_likelihood(sample_with({specimen}, 50), settings);
}

/// Mean of a function of a standard normal variable by even steps.
double normal_mean(const std::function<double(double)>& function) {
  constexpr double kStep = 0.001;
  double sum = 0;
  for (double z = -8; z <= 8; z += kStep) {
    sum += kStep * std::exp(-z * z / 2) * function(z);
  }
  return sum / std::sqrt(2 * std::numbers::pi);
}

double weibull_density(double n, double alpha, double shape) {
  const double d = n / alpha;
  return shape / alpha * std::pow(d, shape - 1) * std::exp(-std::pow(d, shape));
}

TEST(LifeLikelihood, OfTheNominalLaw) {
  // At 100 N alpha is 1000/4; a failure there has density beta/alpha exp(-1).
  EXPECT_NEAR(of_one(reversed(100, 250), law()), std::log(3.0 / 250) - 1, 1e-12);
  // Half of alpha is survived with exp(-1/8).
  EXPECT_NEAR(of_one(reversed(100, 125, false), law()), -0.125, 1e-12);
}

TEST(LifeLikelihood, SumsOverSpecimens) {
  const LifeSample sample = sample_with({reversed(100, 250), reversed(100, 125, false)}, 50);
  EXPECT_NEAR(log_likelihood(sample, law()), std::log(3.0 / 250) - 1.125, 1e-12);
}

TEST(LifeLikelihood, OfACompetingModeAddsItsHazard) {
  LifeSettings settings = law();
  settings.second_mode = LifeSettings::SecondMode{.log_life_shift = std::log(2),
                                                  .shape = 1,
                                                  .steepness = 0,
                                                  .first_level = 0,
                                                  .last_level = 0,
                                                  .end_N = 50};
  // Hazards 3/1000 and 1/2000, survivals exp(-1) and exp(-1/2).
  EXPECT_NEAR(of_one(reversed(50, 1000), settings), std::log(0.0035) - 1.5, 1e-12);
  EXPECT_NEAR(of_one(reversed(50, 1000, false), settings), -1.5, 1e-12);
  settings.second_mode->first_level = settings.second_mode->last_level = 1;
  EXPECT_NEAR(of_one(reversed(50, 1000), settings), std::log(0.003) - 1, 1e-12);
}

TEST(LifeLikelihood, OfAModeThatFadesAway) {
  LifeSettings settings = law();
  settings.second_mode = LifeSettings::SecondMode{.log_life_shift = 0,
                                                  .shape = 1,
                                                  .steepness = 1,
                                                  .first_level = 0,
                                                  .last_level = 0,
                                                  .end_N = 100};
  // Half the tension of its end: alpha_2 = 2 alpha.
  EXPECT_NEAR(of_one(reversed(50, 1000, false), settings), -1.5, 1e-12);
}

TEST(LifeLikelihood, OfOneLimitForAll) {
  LifeSettings settings = law();
  settings.limit_N = 30;
  // (50 - 30)/(70 - 30) squared: alpha is 1000/4 at 70 N.
  EXPECT_NEAR(of_one(reversed(70, 250), settings), std::log(3.0 / 250) - 1, 1e-12);
  EXPECT_EQ(of_one(reversed(30, 1e9, false), settings), 0);
}

TEST(LifeLikelihood, OfALimitOfEachSpecimen) {
  LifeSettings settings = law();
  settings.limit_N = 30;
  settings.limit_log_sd = 0.2;
  const auto alpha = [](double z) {
    const double limit_N = 30 * std::exp(0.2 * z);
    return limit_N < 70 ? 1000 * std::pow(20 / (70 - limit_N), 2) : 1e300;
  };
  EXPECT_NEAR(of_one(reversed(70, 300), settings),
              std::log(normal_mean([&](double z) { return weibull_density(300, alpha(z), 3); })),
              2e-3);
  EXPECT_NEAR(
      of_one(reversed(70, 300, false), settings),
      std::log(normal_mean([&](double z) { return std::exp(-std::pow(300 / alpha(z), 3)); })),
      2e-3);
}

// Lives at a limit 8 % below the load differ by a factor of 3 for 0.2 standard deviations of the
// limit, and hardly at all for one limit.
TEST(LifeLikelihood, OfALimitNearTheLoadWithHardlyAnyOtherScatter) {
  LifeSettings settings = law();
  settings.limit_N = 60;
  settings.limit_log_sd = 0.06;
  settings.shape = 40;
  settings.ln_life_at_centre = std::log(1000);
  const auto alpha = [](double z) {
    const double limit_N = 60 * std::exp(0.06 * z);
    return limit_N < 65 ? 1000 * std::pow(40 / (65 - limit_N), 2) : 1e300;
  };
  const auto of_sample = [&](double cycles, bool failed) {
    return log_likelihood(sample_with({reversed(65, cycles, failed)}, 100), settings);
  };
  for (const double cycles : {2e4, 6e4}) {
    EXPECT_NEAR(
        of_sample(cycles, true),
        std::log(normal_mean([&](double z) { return weibull_density(cycles, alpha(z), 40); })),
        0.03)
        << cycles;
    EXPECT_NEAR(
        of_sample(cycles, false),
        std::log(normal_mean([&](double z) { return std::exp(-std::pow(cycles / alpha(z), 40)); })),
        0.01)
        << cycles;
  }
}

TEST(LifeLikelihood, OfASecondModeOfAPartOfTheSpecimensIsAMixture) {
  LifeSettings settings = law();
  settings.second_mode =
      LifeSettings::SecondMode{.share = 0.3, .log_life_shift = std::log(0.1), .shape = 2};
  settings.second_mode->end_N = 50;
  EXPECT_NEAR(of_one(reversed(50, 90), settings),
              std::log(0.7 * weibull_density(90, 1000, 3) + 0.3 * weibull_density(90, 100, 2)),
              1e-12);
  EXPECT_NEAR(of_one(reversed(50, 200, false), settings),
              std::log(0.7 * std::exp(-0.008) + 0.3 * std::exp(-4)), 1e-12);
}

// ln N has the standard deviation pi/(sqrt(6) 3) = 0.427517 about ln of the median, 1000
// (ln 2)^(1/3) = 884.997.
TEST(LifeLikelihood, OfLognormalLives) {
  LifeSettings settings = law();
  settings.lognormal = true;
  EXPECT_NEAR(of_one(reversed(50, 884.997, false), settings), std::log(0.5), 1e-5);
  const double z = std::log(500 / 884.997) / 0.427517;
  EXPECT_NEAR(of_one(reversed(50, 500), settings),
              -z * z / 2 - std::log(0.427517 * 500 * std::sqrt(2 * std::numbers::pi)), 1e-5);
}

TEST(LifeLikelihood, OfLotsThatShareADraw) {
  LifeSettings settings = law();
  settings.lot_log_sd = 0.3;
  LifeSample::Specimen other = reversed(50, 2000);
  other.lot_number = 1;
  const LifeSample sample = sample_with({reversed(50, 900), reversed(50, 1200, false), other}, 50);
  const auto density = [](double n, double z) {
    return weibull_density(n, 1000 * std::exp(0.3 * z), 3);
  };
  const double first = normal_mean(
      [&](double z) { return density(900, z) * std::exp(-std::pow(1.2 * std::exp(-0.3 * z), 3)); });
  const double second = normal_mean([&](double z) { return density(2000, z); });
  EXPECT_NEAR(log_likelihood(sample, settings), std::log(first) + std::log(second), 1e-3);
}

TEST(LifeLikelihood, OfWeakSpecimensIsAMixture) {
  LifeSettings settings = law();
  settings.weak_share = 0.1;
  settings.weak_life_left = 0.5;
  EXPECT_NEAR(of_one(reversed(50, 400), settings),
              std::log(0.9 * weibull_density(400, 1000, 3) + 0.1 * weibull_density(400, 500, 3)),
              1e-12);
}

TEST(LifeLikelihood, OfWalkersAndGoodmansLaw) {
  LifeSettings settings = law();
  LifeSample::Specimen specimen = reversed(50, 1000, false);
  specimen.blocks.front().mean_N = 88.7;  // half of T_u
  settings.walker_exponent = 0;
  // Goodman: 50/(1 - 1/2) = 100 N, alpha = 1000/4, (1000/250)^3.
  EXPECT_NEAR(of_one(specimen, settings), -64, 1e-9);
  settings.walker_exponent = 0.5;
  // sqrt(138.7 50) = 83.28 N; (83.28/50)^2 = 2.774; cubed.
  EXPECT_NEAR(of_one(specimen, settings), -std::pow(2.774, 3), 1e-9);
}

TEST(LifeLikelihood, OfBendingAndOfDays) {
  LifeSettings settings = law();
  LifeSample::Specimen specimen = reversed(50, 1000, false);
  specimen.blocks.front().wire_to_bend_ratio = 0.05;
  specimen.days = 100;
  settings.bending_N = 1000;
  // 50 N of bending double the amplitude; the centre is of a tension without.
  EXPECT_NEAR(of_one(specimen, settings), -64, 1e-9);
  settings.bending_N = 0;
  settings.ageing_1_day = 0.01;
  EXPECT_NEAR(of_one(specimen, settings), -std::exp(3.0), 1e-9);
}

TEST(LifeResiduals, AreStandardExponentialOnes) {
  const LifeSample sample = sample_with({reversed(100, 250), reversed(100, 125, false)}, 50);
  const std::vector<Residual> residuals = residuals_of(sample, law());
  EXPECT_NEAR(residuals[0].cox_snell, 1, 1e-12);
  EXPECT_NEAR(residuals[1].cox_snell, 0.125, 1e-12);
}

}  // namespace
}  // namespace host_sim::diagnose::lives
