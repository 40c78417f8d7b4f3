#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/mid_tension.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "current_offset_A", .unit = "A", .minimum = -0.5, .maximum = 0.5, .typical = 0.05},
};

constexpr Separation kSeparations[] = {
    {"friction_preload",
     "move in both directions at low and at high tension: an offset of the sensor does not change "
     "sign with s"},
    {"friction_load", "vary the bend angle at one tension"},
    {"torque_gain", "take points near zero current and at high current"},
};

constexpr Need kNeeds[] = {kCurrentNeed};

/// With i = I - I_0: ln(i - b) is ln i - b/i for small b, so r = -1/i b.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double>) {
  return {column_of(covariates, [&](std::size_t i) {
    return -1 / (covariates.current_A[i] * to_mid_tension(covariates, baseline, i));
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
                    .columns = columns});
}

}  // namespace host_sim::effects
