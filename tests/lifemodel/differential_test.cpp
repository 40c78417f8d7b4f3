#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>

#include "host_sim/reference/reference.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

using host_sim::reference::Reference;
using lifemodel_test::newtons;
using pack::to_double;

using SignalN = std::vector<double>;

SignalN block_load(std::mt19937& random) {
  SignalN signal;
  for (int block = 0; block < 12; ++block) {
    const double low = 5 + static_cast<double>(random() % 40);
    const double high = low + 5 + static_cast<double>(random() % 90);
    for (int i = 0; i < 60; ++i) {
      signal.push_back(i % 2 == 0 ? low : high);
    }
  }
  return signal;
}

SignalN sine_with_noise(std::mt19937& random) {
  std::normal_distribution<double> noise(0, 0.3);
  SignalN signal;
  for (int i = 0; i < 5000; ++i) {
    signal.push_back(60 + 30 * std::sin(i * 0.02) + 10 * std::sin(i * 0.37) + noise(random));
  }
  return signal;
}

SignalN white(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-20, 150);
  SignalN signal(4000);
  for (double& value : signal) {
    value = uniform(random);
  }
  return signal;
}

SignalN quantised(std::mt19937& random) {
  SignalN signal;
  for (int i = 0; i < 4000; ++i) {
    signal.push_back(0.1 * static_cast<double>(random() % 40));
  }
  return signal;
}

SignalN spirals(std::mt19937& random) {
  SignalN signal;
  for (const double step : {0.9, -0.9, 0.31, -0.31}) {
    for (int i = 0; i < 110; ++i) {
      const double radius = step > 0 ? 100 - 0.9 * i : 0.9 * i + 0.5;
      signal.push_back(40 + (i % 2 == 0 ? radius : -radius) * std::fabs(step) * 0.9 +
                       1e-3 * static_cast<double>(random() % 10));
    }
  }
  return signal;
}

/// Many nearly equal ranges, plateaus, one-step ripples and jumps over the whole range.
SignalN adversarial(std::mt19937& random) {
  SignalN signal;
  double level = 50;
  for (int i = 0; i < 4000; ++i) {
    switch (random() % 6) {
      case 0:
        level = static_cast<double>(random() % 176);
        break;
      case 1:
        level += 1e-6;
        break;
      case 2:
        level -= 1e-6;
        break;
      case 3:
        level = i % 2 == 0 ? 20 : 120;
        break;
      case 4:
        level = i % 2 == 0 ? 20 + 1e-5 : 120 - 1e-5;
        break;
      default:
        break;
    }
    signal.push_back(level);
  }
  return signal;
}

/// Damage against the double-precision reference at several prefixes.
double worst_error(const pack::Constants& constants, const SignalN& signal) {
  Reference reference({constants.ultimate_tension_N, constants.hysteresis_N, constants.ipl_scale,
                       constants.ipl_exponent, constants.weibull_shape});
  Estimator<1> estimator({lifemodel_test::parameters_of(constants)});
  double worst = 0;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    reference.push(signal[i]);
    estimator.push(0, newtons(signal[i]));
    while (estimator.settle()) {
    }
    if (i % 97 == 0 || i + 1 == signal.size()) {
      const auto exact = reference.reading();
      const Reading ours = estimator.reading(0);
      EXPECT_FALSE(ours.flags.has(Flag::residue_overflow));
      if (exact.damage.total == 0) {
        EXPECT_EQ(ours.total, Damage{});
      } else {
        worst = std::max(worst, std::fabs(to_double(ours.total) / exact.damage.total - 1));
      }
    }
  }
  return worst;
}

using Make = SignalN (*)(std::mt19937&);

class Differential : public testing::TestWithParam<std::pair<const char*, Make>> {};

TEST_P(Differential, AgreesWithTheReference) {
  std::mt19937 random(4711);
  double worst = 0;
  for (const double exponent : {1.0, 1.38, 3.0, 6.0, 12.0}) {
    for (const double hysteresis_N : {0.0, 0.2}) {
      for (int round = 0; round < 3; ++round) {
        auto constants = lifemodel_test::paper_constants();
        constants.ipl_exponent = exponent;
        constants.ipl_scale = 1e4 * std::pow(constants.ultimate_tension_N / 2, exponent);
        constants.hysteresis_N = hysteresis_N;
        worst = std::max(worst, worst_error(constants, GetParam().second(random)));
      }
    }
  }
  EXPECT_LE(worst, 1e-4);
  std::printf("worst relative error %.2e\n", worst);
}

INSTANTIATE_TEST_SUITE_P(
    Signals, Differential,
    testing::Values(std::pair{"white", &white}, std::pair{"sine_with_noise", &sine_with_noise},
                    std::pair{"block_load", &block_load}, std::pair{"quantised", &quantised},
                    std::pair{"spirals", &spirals}, std::pair{"adversarial", &adversarial}),
    [](const auto& signal) { return std::string(signal.param.first); });

TEST(DifferentialStress, ConstantAmplitudeOverTheWholeRangeOfStress) {
  double worst = 0;
  for (const double exponent : {1.0, 1.38, 5.0, 12.0}) {
    auto constants = lifemodel_test::paper_constants();
    constants.ipl_exponent = exponent;
    constants.ipl_scale = 1e3 * std::pow(constants.ultimate_tension_N, exponent);
    for (double effective = 0.02; effective <= 0.95; effective += 0.01) {
      // Zero mean: the effective tension is the amplitude.
      const double amplitude_N = effective * constants.ultimate_tension_N;
      SignalN signal;
      for (int i = 0; i < 400; ++i) {
        signal.push_back(i % 2 == 0 ? -amplitude_N : amplitude_N);
      }
      worst = std::max(worst, worst_error(constants, signal));
    }
  }
  EXPECT_LE(worst, 1e-4);
  std::printf("worst relative error %.2e\n", worst);
}

}  // namespace
}  // namespace lifemodel
