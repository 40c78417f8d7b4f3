#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/report/compare/comparison.hpp"

/// Comparisons made by hand for the tests of their page.
namespace host_sim::samples {

struct ComparisonSample {
  std::string name;
  compare::Comparison comparison;
  std::size_t charts;  ///< plots of its page
};

/// Two models, two profiles of which one is long, and two that do no damage.
[[nodiscard]] std::vector<ComparisonSample> all_comparisons();

}  // namespace host_sim::samples
