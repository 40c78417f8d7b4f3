#pragma once

#include <span>
#include <vector>

#include "host_sim/statistics/censoring.hpp"
#include "host_sim/statistics/centred_sample.hpp"
#include "host_sim/statistics/common_shape.hpp"

namespace host_sim::statistics {

/// Samples with failures, and samples like them drawn from their common fit under the plan of
/// suspension of each.
class SameShapeSamples {
 public:
  struct Memory {
    Sample lives;
    std::vector<CentredSample> logs;
  };

  SameShapeSamples(std::span<const Sample> samples, const CommonShapeFit& common);

  /// Logarithms of the samples as measured.
  [[nodiscard]] std::span<const CentredSample> measured() const { return measured_; }
  /// Logarithms of samples as drawn, in `memory`.
  std::span<const CentredSample> draw(Random& random, Memory& memory) const;

 private:
  std::vector<CentredSample> measured_;
  std::vector<Distribution> truths_;
  std::vector<CensoringPlan> plans_;
};

}  // namespace host_sim::statistics
