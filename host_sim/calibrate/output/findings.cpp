#include <algorithm>
#include <cmath>

#include "host_sim/calibrate/output/output.hpp"

namespace host_sim::calibrate {
namespace {

bool level_left_out(const CalibrateResult& result) {
  return std::any_of(result.levels.begin(), result.levels.end(), [](const LevelResult& level) {
    return level.role == Campaign::Role::fit && !level.left_out.empty();
  });
}

bool one_shape_rejected(const CalibrateResult& result) {
  return result.common_shape && rejected(result.common_shape->homogeneity);
}

bool law_rejected(const CalibrateResult& result) {
  if (!result.stress_life) {
    return true;
  }
  const StressLife& life = *result.stress_life;
  for (const auto* test :
       {&life.against_free_levels, &life.against_curvature, &life.against_growing_scatter}) {
    if (*test && rejected(**test)) {
      return true;
    }
  }
  return false;
}

bool validation_differs(const CalibrateResult& result) {
  return std::any_of(result.validation.begin(), result.validation.end(),
                     [](const ValidationResult& level) { return level.p < kSignificance; });
}

}  // namespace

std::vector<std::string> all_findings() {
  return {"left-out", "shape", "fit", "validation"};
}

std::vector<std::string> found_in(const CalibrateResult& result) {
  const std::vector<bool> found{level_left_out(result), one_shape_rejected(result),
                                law_rejected(result), validation_differs(result)};
  const std::vector<std::string> names = all_findings();
  std::vector<std::string> findings;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (found[i]) {
      findings.push_back(names[i]);
    }
  }
  return findings;
}

}  // namespace host_sim::calibrate
