#include "tests/life_law/data_sets.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "host_sim/statistics/random.hpp"

namespace host_sim::life_law::testing {

LifeData life_data(const std::vector<StressLevel>& levels) {
  LifeData data;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const StressLevel& level = levels[i];
    for (const double life : level.failed) {
      data.push_back({.blocks = {{level.stress, life}}, .failed = true, .level = i});
    }
    for (const double life : level.suspended) {
      data.push_back({.blocks = {{level.stress, life}}, .failed = false, .level = i});
    }
  }
  return data;
}

LifeData insulating_fluid() {
  return life_data({
      {26, {5.79, 1579.52, 2323.7}, {}},
      {28, {68.85, 426.07, 110.29, 108.29, 1067.6}, {}},
      {30, {17.05, 22.66, 21.02, 175.88, 139.07, 144.12, 20.46, 43.40, 194.90, 47.30, 7.74}, {}},
      {32,
       {0.40, 82.85, 9.88, 89.29, 215.10, 2.75, 0.79, 15.93, 3.91, 0.27, 0.69, 100.58, 27.80, 13.95,
        53.24},
       {}},
      {34,
       {0.96, 4.15, 0.19, 0.78, 8.01, 31.75, 7.35, 6.50, 8.27, 33.91, 32.52, 3.16, 4.85, 2.78, 4.67,
        1.31, 12.06, 36.71, 72.89},
       {}},
      {36,
       {1.97, 0.59, 2.58, 1.69, 2.71, 25.50, 0.35, 0.99, 3.99, 3.67, 2.07, 0.96, 5.35, 2.90, 13.77},
       {}},
      {38, {0.47, 0.73, 1.40, 0.74, 0.39, 1.13, 0.09, 2.38}, {}},
  });
}

LifeData rolling_bearings() {
  return life_data({
      {0.87, {1.67, 2.2, 2.51, 3.00, 3.90, 4.70, 7.53, 14.7, 27.76, 37.4}, {}},
      {0.99, {0.80, 1.0, 1.37, 2.25, 2.95, 3.70, 6.07, 6.65, 7.05, 7.37}, {}},
      {1.09, {0.18, 0.2, 0.24, 0.26, 0.32, 0.32, 0.42, 0.44, 0.88}, {}},
      {1.18, {0.073, 0.098, 0.117, 0.135, 0.175, 0.262, 0.270, 0.350, 0.386, 0.456}, {}},
  });
}

LifeData motorettes() {
  const auto stress = [](double temperature_C) {
    return std::exp(-1000 / (temperature_C + 273.2));
  };
  return life_data({
      {stress(170), {1764, 2772, 3444, 3542, 3780, 4860, 5196}, {5448, 5448, 5448}},
      {stress(190), {408, 408, 1344, 1344, 1440}, {1680, 1680, 1680, 1680, 1680}},
      {stress(220), {408, 408, 504, 504, 504}, {528, 528, 528, 528, 528}},
  });
}

LifeData superalloy() {
  return life_data({
      {80.3, {211.629}, {}}, {80.6, {200.027}, {}}, {80.8, {}, {57.923}},  {84.3, {155.000}, {}},
      {85.2, {13.949}, {}},  {85.6, {}, {112.968}}, {85.8, {152.680}, {}}, {86.4, {156.725}, {}},
      {86.7, {}, {138.114}}, {87.2, {56.723}, {}},  {87.3, {121.075}, {}}, {89.7, {}, {122.372}},
      {91.3, {112.002}, {}}, {99.8, {43.331}, {}},  {100.1, {12.076}, {}}, {100.5, {13.181}, {}},
      {113.0, {18.067}, {}}, {114.8, {21.300}, {}}, {116.4, {15.616}, {}}, {118.0, {13.030}, {}},
      {118.4, {8.489}, {}},  {118.6, {12.434}, {}}, {120.4, {9.750}, {}},  {142.5, {11.865}, {}},
      {144.5, {6.705}, {}},  {145.9, {5.733}, {}},
  });
}

LifeData glass_capacitors() {
  return life_data({
      {200, {439, 904, 1092, 1105}, {1105, 1105, 1105, 1105}},
      {250, {572, 690, 904, 1090}, {1090, 1090, 1090, 1090}},
      {300, {315, 315, 439, 628}, {628, 628, 628, 628}},
      {350, {258, 258, 347, 588}, {588, 588, 588, 588}},
  });
}

LifeData scaled(LifeData data, double factor) {
  for (LifeDatum& datum : data) {
    for (LifeDatum::Block& block : datum.blocks) {
      block.cycles *= factor;
    }
  }
  return data;
}

double sum_of_ln_failures(std::span<const LifeDatum> data) {
  double sum = 0;
  for (const LifeDatum& datum : data) {
    sum += datum.failed ? std::log(datum.blocks.back().cycles) : 0;
  }
  return sum;
}

namespace {

/// Damage at failure has the survival exp(-D^shape).
double damage_at_failure(const LifeLaw& law, statistics::Random& random) {
  return std::pow(-std::log(random.uniform()), 1 / law.shape);
}

}  // namespace

LifeData paper_like(std::uint64_t seed, std::size_t each, const LifeLaw& law) {
  statistics::Random random(seed, 0, 0);
  constexpr std::array kTension_N{42.5, 50.7, 60.0, 70.8};
  LifeData data;
  for (std::size_t level = 0; level < kTension_N.size(); ++level) {
    const double alpha = law.characteristic_life(kTension_N[level]);
    for (std::size_t i = 0; i < each; ++i) {
      data.push_back({.blocks = {{kTension_N[level], alpha * damage_at_failure(law, random)}},
                      .failed = true,
                      .level = level});
    }
  }
  return data;
}

LifeData suspended_at(LifeData data, double limit_cycles) {
  for (LifeDatum& datum : data) {
    LifeDatum::Block& block = datum.blocks.front();
    if (block.cycles > limit_cycles) {
      block.cycles = limit_cycles;
      datum.failed = false;
    }
  }
  return data;
}

LifeData in_blocks(std::uint64_t seed, std::size_t count, double share, const LifeLaw& law) {
  constexpr std::size_t kLongest = 6;
  statistics::Random random(seed, 1, 0);
  LifeData data;
  for (std::size_t i = 0; i < count; ++i) {
    LifeDatum specimen{.blocks = {}, .failed = false};
    double left = damage_at_failure(law, random);
    while (!specimen.failed && (i % 3 != 0 || specimen.blocks.size() < kLongest)) {
      const double tension_N = 40 + 40 * random.uniform();
      const double alpha = law.characteristic_life(tension_N);
      const double damage = std::min(left, share);
      specimen.blocks.push_back({tension_N, damage * alpha});
      specimen.failed = left <= share;
      left -= damage;
    }
    data.push_back(std::move(specimen));
  }
  return data;
}

}  // namespace host_sim::life_law::testing
