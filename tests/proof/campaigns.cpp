#include "tests/proof/campaigns.hpp"

#include <fmt/core.h>

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

void tell(const std::string& what, const Share& share) {
  fmt::print("proof: {}: {:.2f} % of {} campaigns\n", what, 100 * share.value(), share.campaigns);
}

}  // namespace host_sim::proof
