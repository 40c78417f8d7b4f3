#include "tests/statistics/samples.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::statistics {

Sample failed(std::initializer_list<double> lives) {
  return with_suspended(lives, {});
}

Sample with_suspended(std::initializer_list<double> failed_lives,
                      std::initializer_list<double> suspended_lives) {
  Sample sample;
  for (const double life : failed_lives) {
    sample.push_back({.value = life, .failed = true});
  }
  for (const double life : suspended_lives) {
    sample.push_back({.value = life, .failed = false});
  }
  return sample;
}

Sample ideal_weibull(double scale, double shape, std::size_t count) {
  Sample sample;
  for (std::size_t i = 0; i < count; ++i) {
    const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    sample.push_back({.value = scale * std::pow(-std::log(1 - p), 1 / shape), .failed = true});
  }
  return sample;
}

Sample drawn_from(const Distribution& distribution, std::size_t count, Random& random) {
  Sample sample;
  for (std::size_t i = 0; i < count; ++i) {
    sample.push_back({.value = distribution.quantile(random.uniform()), .failed = true});
  }
  return sample;
}

Sample drawn_from(const Distribution& distribution, std::size_t count, std::uint64_t seed) {
  Random random(seed, 0, 0);
  return drawn_from(distribution, count, random);
}

Sample ended_at(double limit, Sample sample) {
  for (Observation& seen : sample) {
    seen.failed = seen.value <= limit;
    seen.value = std::min(seen.value, limit);
  }
  return sample;
}

std::vector<double> simulated(std::size_t count, const std::function<double(Random&)>& draw) {
  constexpr std::uint64_t kSeed = 20'260'101;
  constexpr std::uint64_t kStream = 99;
  std::vector<double> results(count);
  parallel_for(count, [&](std::size_t i) {
    Random random(kSeed, kStream, i);
    results[i] = draw(random);
  });
  return results;
}

double quantile_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double distance_from_uniform(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto below = static_cast<double>(i);
    largest = std::max({largest, values[i] - below / count, (below + 1) / count - values[i]});
  }
  return largest * std::sqrt(count);
}

}  // namespace host_sim::statistics

namespace host_sim::statistics::published {

Sample ball_bearings() {
  return failed({17.88, 28.92, 33.00,  41.52,  42.12,  45.60,  48.40, 51.84,
                 51.96, 54.12, 55.56,  67.80,  68.64,  68.64,  68.88, 84.12,
                 93.12, 98.64, 105.12, 105.84, 127.92, 128.04, 173.40});
}

Sample generator_fans() {
  return with_suspended(
      {0.45, 1.15, 1.15, 1.6, 2.07, 2.07, 2.08, 3.1, 3.45, 4.6, 6.1, 8.75},
      {0.46, 1.56, 1.66, 1.85, 1.85, 1.85, 1.85, 1.85, 2.03, 2.03, 2.03, 2.2,  3.0,  3.0,  3.0,
       3.0,  3.2,  3.75, 3.75, 4.15, 4.15, 4.15, 4.15, 4.3,  4.3,  4.3,  4.3,  4.85, 4.85, 4.85,
       4.85, 5.0,  5.0,  5.0,  6.1,  6.1,  6.1,  6.3,  6.45, 6.45, 6.7,  7.45, 7.8,  7.8,  8.1,
       8.1,  8.2,  8.5,  8.5,  8.5,  8.75, 8.75, 9.4,  9.9,  10.1, 10.1, 10.1, 11.5});
}

Sample nist_units() {
  return with_suspended({54, 187, 216, 240, 244, 335, 361, 373, 375, 386},
                        {500, 500, 500, 500, 500, 500, 500, 500, 500, 500});
}

Sample shock_absorbers() {
  return with_suspended({6700, 9120, 12200, 13150, 14300, 17520, 20100, 20900, 22700, 26510, 27490},
                        {6950,  7820,  8790,  9660,  9820,  11310, 11690, 11850, 11880,
                         12140, 12870, 13330, 13470, 14040, 17540, 17890, 18450, 18960,
                         18980, 19410, 20100, 20150, 20320, 23490, 27410, 27890, 28100});
}

Sample alloy_t7987() {
  return with_suspended(
      {94,  96,  99,  99,  104, 108, 112, 114, 117, 117, 118, 121, 121, 123, 129, 131, 133,
       135, 136, 139, 139, 140, 141, 141, 143, 144, 149, 149, 152, 152, 159, 159, 159, 159,
       162, 168, 168, 169, 170, 170, 171, 172, 173, 176, 177, 180, 180, 184, 187, 188, 189,
       190, 196, 197, 203, 205, 211, 213, 224, 226, 227, 256, 257, 269, 271, 274, 291},
      {300, 300, 300, 300, 300});
}

}  // namespace host_sim::statistics::published
