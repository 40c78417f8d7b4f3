#include "host_sim/statistics/replicates.hpp"

#include <cmath>
#include <limits>

namespace host_sim::statistics {

double bootstrap_p(std::span<const double> replicates, double observed) {
  double computed = 0;
  double exceeding = 0;
  for (const double replicate : replicates) {
    computed += std::isnan(replicate) ? 0 : 1;
    exceeding += replicate >= observed ? 1 : 0;
  }
  if (computed == 0 || std::isnan(observed)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return (1 + exceeding) / (1 + computed);
}

}  // namespace host_sim::statistics
