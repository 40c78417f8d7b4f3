#include "tests/life_law/campaigns.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "host_sim/statistics/random.hpp"

namespace host_sim::life_law::testing {
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
