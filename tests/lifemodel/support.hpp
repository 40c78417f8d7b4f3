#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "lifemodel/estimator.hpp"
#include "lifemodel/pack/pack.hpp"

namespace lifemodel_test {

/// As on the target, but for a queue that suits a host.
struct HostLayout {
  static constexpr std::size_t kResidue = 128;
  static constexpr std::size_t kQueue = 2048;
};

/// The paper's constants; every range is counted.
inline lifemodel::pack::Constants paper_constants() {
  return {.ultimate_tension_N = 177.4,
          .hysteresis_N = 0,
          .ipl_scale = 1.53e5,
          .ipl_exponent = 1.38,
          .weibull_shape = 5.94,
          .friction_coefficient = 0.128,
          .bend_angle_rad = 1.5 * M_PI,
          .tension_per_current_N_A = 0.0325 * 9 * 0.88 / 0.0125,
          .current_offset_A = 0,
          .sample_period_s = 1e-3,
          .model_digest = 0x12345678};
}

inline lifemodel::Parameters parameters_of(const lifemodel::pack::Constants& constants) {
  return *lifemodel::pack::parameters(constants);
}

/// A damage to 32 significant bits.
inline lifemodel::Damage damage_of(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  lifemodel::Damage damage;
  lifemodel::Flags flags;
  damage.add({static_cast<std::uint32_t>(std::ldexp(mantissa, 32)),
              exponent - 32 + lifemodel::Damage::kFractionBits},
             flags);
  return damage;
}

/// Tensions of the paper's wire.
inline constexpr double kUltimate_N = 177.4;

inline lifemodel::Tension newtons(double value_N) {
  return lifemodel::pack::tension(value_N, kUltimate_N);
}

/// To the nearest uN, so that decimals come back as they were.
inline double to_newtons(lifemodel::Tension tension) {
  return std::round(lifemodel::pack::to_double(tension) * kUltimate_N * 1e6) / 1e6;
}

inline std::vector<lifemodel::Tension> newtons(const std::vector<double>& values_N) {
  std::vector<lifemodel::Tension> result;
  for (const double value_N : values_N) {
    result.push_back(newtons(value_N));
  }
  return result;
}

/// Damage of one full cycle from the equations, in long double.
inline long double cycle_damage(const lifemodel::pack::Constants& c, double x_N, double y_N) {
  const auto exact = [](double value) { return static_cast<long double>(value); };
  const long double amplitude = std::fabs(exact(x_N) - exact(y_N)) / 2;
  const long double relative_mean = (exact(x_N) + exact(y_N)) / 2 / exact(c.ultimate_tension_N);
  const long double effective = amplitude / (1 - relative_mean * relative_mean);
  return std::pow(effective, exact(c.ipl_exponent)) / exact(c.ipl_scale);
}

using Signal = std::vector<lifemodel::Tension>;

inline Signal white_noise(std::uint32_t seed, std::size_t samples, double low_N, double high_N) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(low_N, high_N);
  Signal signal;
  for (std::size_t i = 0; i < samples; ++i) {
    signal.push_back(newtons(uniform(random)));
  }
  return signal;
}

/// A walk that is reflected at 0 and 100 N.
inline Signal walk(std::uint32_t seed, std::size_t samples) {
  std::mt19937 random(seed);
  std::normal_distribution<double> step(0, 1);
  Signal signal;
  double tension_N = 50;
  for (std::size_t i = 0; i < samples; ++i) {
    tension_N = std::fabs(tension_N + step(random));
    tension_N = tension_N > 100 ? 200 - tension_N : tension_N;
    signal.push_back(newtons(tension_N));
  }
  return signal;
}

/// Few levels, so that many ranges tie.
inline Signal quantised(std::uint32_t seed, std::size_t samples, int levels) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> level(0, levels - 1);
  Signal signal;
  for (std::size_t i = 0; i < samples; ++i) {
    signal.push_back(newtons(10.0 * level(random)));
  }
  return signal;
}

/// Ranges that shrink (or grow) by `step_N` from one half cycle to the next.
inline Signal spiral(std::size_t turns, double step_N, bool inwards) {
  std::vector<double> values_N;
  for (std::size_t i = 0; i < turns; ++i) {
    const double offset_N = step_N * static_cast<double>(inwards ? turns - i : i + 1);
    values_N.push_back(80 + (i % 2 == 0 ? offset_N : -offset_N));
  }
  return newtons(values_N);
}

}  // namespace lifemodel_test
