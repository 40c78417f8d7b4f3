#include <algorithm>
#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr double kLeastGain = 0.05;

constexpr Parameter kParameters[] = {
    {.name = "droop_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1, .expected = 1},
    {.name = "droop_1_K",
     .unit = "1/K",
     .minimum = 0,
     .maximum = 0.005,
     .typical = 0.001,
     .scaled_by_share = true},
};

constexpr Separation kSeparations[] = {
    {"friction_temperature", "heat the motor alone, with the sheath cold"},
    {"friction_wear", "start with a cold winding at several cycle numbers"},
    {"current_offset", "take points near zero current and at high current"},
};

constexpr Need kNeeds[] = {kCurrentNeed, kWindingTemperatureNeed};

/// r = ln(1 - alpha (T - T_ref)). A constant error of the gain is refitted anyway and is no effect.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double droop_1_K = shape[0];
  return {column_of(covariates, [&](std::size_t i) {
    const double warmer_K = covariates.winding_temperature_C[i] - baseline.winding_reference_C;
    return std::log(std::max(kLeastGain, 1 - droop_1_K * warmer_K));
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_torque_gain();

std::unique_ptr<TensionEffect> make_torque_gain() {
  return effect_of(
      {.id = "torque_gain",
       .term = "torque constant that falls as the winding warms",
       .equation = "T_in = K_t (1 - alpha (T_winding - T_ref)) (I - I_0) N eta_g / r_spool",
       .life_consequence = "a warm motor pulls less than its current says, so that damage is "
                           "overstated by gamma alpha dT",
       .parameters = kParameters,
       .separations = kSeparations,
       .needs = kNeeds,
       .acts_on_current = true,
       .shifts_sessions = true,
       .shapes = {{1.5e-4}, {3e-4}, {6e-4}, {1.2e-3}, {2.5e-3}, {5e-3}},
       .columns = columns});
}

}  // namespace host_sim::effects
