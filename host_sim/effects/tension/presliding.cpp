#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"
#include "host_sim/effects/tension/turn.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "presliding_share",
     .unit = "1",
     .minimum = 0,
     .maximum = 1,
     .typical = 1,
     .expected = 1},
    {.name = "presliding_length_m",
     .unit = "m",
     .minimum = 5e-5,
     .maximum = 1e-3,
     .typical = 3.5e-4,
     .model_error = 0.005},
};

constexpr Separation kSeparations[] = {
    {"slack", "step the pretension: slack closes, presliding stays"},
    {"compliance", "reverse at two loads and two poses"},
};

constexpr Need kNeeds[] = {kTravelNeed};

/// w = z s obeys dw/dx = (1 - w)/d along the travel x since a reversal, and changes its sign there:
/// 1 - w = (1 + w_before) exp(-x/d). r = -mu phi (z - s) = mu phi s (1 - w). Before the first
/// reversal that was seen z is s.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double length_m = shape[0];
  const double mu = friction_at_reversals(covariates, baseline);
  double left_at_reversal = 0;
  double left = 0;
  return {column_of(covariates, [&](std::size_t i) {
    if (turns_at(covariates, i)) {
      left_at_reversal = 2 - left;
    }
    left = left_at_reversal * std::exp(-covariates.travel_m[i] / length_m);
    return mu * angle_and_direction(covariates, i) * left;
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_presliding();

std::unique_ptr<TensionEffect> make_presliding() {
  return effect_of({.id = "presliding",
                    .term = "Dahl or LuGre hysteresis",
                    .equation = "T_out = T_in exp(-mu phi z), dz/dt = (v/d) (1 - z s)",
                    .life_consequence =
                        "strokes shorter than d never build up the full friction, so that small "
                        "cycles of input tension are smaller than the Capstan law makes them",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .at_reversals = true,
                    .shapes = {{5e-5}, {1e-4}, {2e-4}, {3.5e-4}, {6e-4}, {1e-3}},
                    .columns = columns});
}

}  // namespace host_sim::effects
