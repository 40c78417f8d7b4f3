#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

/// Columns in proportion to phi, as friction is; slack has one of each kind.
bool grows_with_angle(std::string_view id, std::size_t column) {
  const std::set<std::string_view> frictions{"friction_wear", "friction_temperature",
                                             "friction_velocity", "friction_position",
                                             "presliding"};
  return frictions.contains(id) || (id == "slack" && column == 1);
}

/// Columns of a load are not: they hold T_out, which falls with phi. What remembers the jump at a
/// reversal does not grow evenly with it.
bool left_out(std::string_view id, const std::vector<double>& shape) {
  return id == "friction_load" || id == "compliance" || (id == "filter_lag" && shape[0] < 0);
}

/// A shape in newtons, amperes or newtons a metre goes with the scale of tension.
std::vector<double> scaled_with_tension(std::string_view id, std::vector<double> shape,
                                        double factor) {
  const std::set<std::string_view> scaled{"friction_preload", "current_offset", "compliance"};
  if (scaled.contains(id)) {
    shape.front() *= factor;
  }
  return shape;
}

double drawn_factor() {
  return 0.25 + 0.01 * *rc::gen::inRange(0, 300);
}

RC_GTEST_PROP(Proportion, FrictionGrowsWithTheBendAngleAndNothingElseDoes, ()) {
  const double factor = drawn_factor();
  recording::Covariates bent = trace();
  for (std::size_t i = 0; i < bent.samples(); ++i) {
    bent.bend_angle_rad[i] *= factor;
    bent.output_tension_N[i] =
        bent.current_tension_N[i] * std::exp(-kMu * bent.bend_angle_rad[i] * bent.direction[i]);
  }
  for (const auto& effect : tension_effects()) {
    for (const std::vector<double>& shape : effect->shapes()) {
      const auto before = columns(effect->id(), trace(), shape);
      const auto after = columns(effect->id(), bent, shape);
      for (std::size_t j = 0; j < before.size() && !left_out(effect->id(), shape); ++j) {
        const double expected = grows_with_angle(effect->id(), j) ? factor : 1;
        for (std::size_t i = 0; i < before[j].size(); ++i) {
          RC_ASSERT(std::abs(after[j][i] - expected * before[j][i]) <=
                    1e-12 * std::abs(before[j][i]));
        }
      }
    }
  }
}

RC_GTEST_PROP(Proportion, TheScaleOfTensionChangesOnlyWhatIsInNewtonsOrAmperes, ()) {
  const double factor = drawn_factor();
  recording::Covariates loaded = trace();
  for (std::size_t i = 0; i < loaded.samples(); ++i) {
    loaded.current_A[i] *= factor;
    loaded.current_tension_N[i] *= factor;
    loaded.output_tension_N[i] *= factor;
  }
  for (const auto& effect : tension_effects()) {
    const std::string_view id = effect->id();
    if (id == "friction_load") {
      continue;
    }
    const double expected = id == "torque_ripple" ? 1 / factor : 1;
    const std::vector<double> shape = effect->shapes().back();
    const auto before = columns(id, trace(), shape);
    const auto after = columns(id, loaded, scaled_with_tension(id, shape, factor));
    for (std::size_t j = 0; j < before.size(); ++j) {
      for (std::size_t i = 0; i < before[j].size(); ++i) {
        RC_ASSERT(std::abs(after[j][i] - expected * before[j][i]) <=
                  1e-12 * std::abs(before[j][i]) + 1e-13);
      }
    }
  }
}

}  // namespace
}  // namespace host_sim::effects::testing
