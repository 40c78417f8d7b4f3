#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/mid_tension.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "offset_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1, .expected = 1},
    {.name = "current_offset_A",
     .unit = "A",
     .minimum = -0.5,
     .maximum = 0.5,
     .typical = 0.05,
     .scaled_by_share = true,
     .model_error = 0.005},
};

constexpr Separation kSeparations[] = {
    {"friction_preload",
     "move in both directions at low and at high tension: an offset of the sensor does not change "
     "sign with s"},
    {"friction_load", "vary the bend angle at one tension"},
    {"torque_gain", "take points near zero current and at high current"},
};

constexpr Need kNeeds[] = {kCurrentNeed};

/// The true current is i - b; over the geometric mean m of it and i that is -2 sinh(r/2) = b/m.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double offset_A = shape[0];
  return {column_of(covariates, [&](std::size_t i) {
    const double mid_A = covariates.current_A[i] * to_mid_tension(covariates, baseline, i);
    return -2 * std::asinh(offset_A / mid_A / 2);
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_current_offset();

std::unique_ptr<TensionEffect> make_current_offset() {
  return effect_of({.id = "current_offset",
                    .term = "zero error of the current sensor",
                    .equation = "T_in = K_t (I - I_0 - b) N eta_g / r_spool",
                    .life_consequence = "all input tensions are wrong by the same number of "
                                        "newtons: the mean (12) moves and the amplitude (13) stays",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .acts_on_current = true,
                    .shapes = {{-0.32},
                               {-0.16},
                               {-0.08},
                               {-0.04},
                               {-0.02},
                               {-0.01},
                               {-0.005},
                               {0.005},
                               {0.01},
                               {0.02},
                               {0.04},
                               {0.08},
                               {0.16},
                               {0.32}},
                    .columns = columns});
}

}  // namespace host_sim::effects
