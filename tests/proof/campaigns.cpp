#include "tests/proof/campaigns.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace host_sim::proof {

plan::Design whole_design() {
  return {{{42.5, 20}, {50.7, 20}, {60.0, 20}, {70.8, 20}}};
}

plan::Design suspended_design() {
  plan::Design design = whole_design();
  design.suspend_at_cycles = kTruth.quantile(0.5, design.levels.front().effective_tension_N);
  return design;
}

std::size_t campaigns(std::size_t wanted) {
#ifdef NDEBUG
  return wanted;
#else
  constexpr std::size_t kThinned = 20;
  return wanted / kThinned;
#endif
}

double Share::value() const {
  return static_cast<double>(holds) / static_cast<double>(campaigns);
}

double Share::tolerance(double expected, double sigmas) const {
  return sigmas * std::sqrt(expected * (1 - expected) / static_cast<double>(campaigns));
}

void report(const std::string& what, const Share& share) {
  fmt::print("proof: {}: {:.2f} % of {} campaigns\n", what, 100 * share.value(), share.campaigns);
}

namespace {

double distance_from_uniform(const std::vector<double>& sorted) {
  const auto count = static_cast<double>(sorted.size());
  double distance = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto below = static_cast<double>(i);
    distance = std::max({distance, sorted[i] - below / count, (below + 1) / count - sorted[i]});
  }
  return distance;
}

}  // namespace

void expect_uniform(const std::string& what, std::vector<double> p, std::size_t replicates) {
  constexpr double kSignificance = 0.05;
  constexpr double kRounding = 1e-12;
  constexpr double kOnceInAThousand = 1.95;
  std::sort(p.begin(), p.end());
  const double distance = distance_from_uniform(p);
  const double allowed = kOnceInAThousand / std::sqrt(static_cast<double>(p.size())) +
                         1 / static_cast<double>(replicates + 1);
  fmt::print("proof: {}: distance of p from uniform {:.4f}, allowed {:.4f}\n", what, distance,
             allowed);
  EXPECT_LT(distance, allowed) << what;
  const auto rejected = std::upper_bound(p.begin(), p.end(), kSignificance + kRounding) - p.begin();
  const Share share{static_cast<std::size_t>(rejected), p.size()};
  report(what + ", rejected at 5 % under the null", share);
  EXPECT_NEAR(share.value(), kSignificance, share.tolerance(kSignificance, 3)) << what;
}

}  // namespace host_sim::proof
