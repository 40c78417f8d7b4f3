#include "tests/statistics/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::statistics {

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

std::size_t fewer_if_sanitized(std::size_t count) {
#ifdef __SANITIZE_ADDRESS__
  return count / 3;
#else
  return count;
#endif
}

}  // namespace host_sim::statistics
