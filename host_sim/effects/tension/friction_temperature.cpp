#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "temperature_coefficient_1_K",
     .unit = "1/K",
     .minimum = -0.05,
     .maximum = 0.05,
     .typical = 0.005,
     .model_error = 0.015},
};

constexpr Separation kSeparations[] = {
    {"friction_wear", "heat the sheath alone, at one cycle number"},
    {"torque_gain", "heat the sheath alone, with the winding cold"},
};

constexpr Need kNeeds[] = {kSheathTemperatureNeed};

/// r = -mu phi s (T - T_ref) k.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double>) {
  return {column_of(covariates, [&](std::size_t i) {
    return -baseline.friction_coefficient * angle_and_direction(covariates, i) *
           (covariates.sheath_temperature_C[i] - baseline.sheath_reference_C);
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_friction_temperature();

std::unique_ptr<TensionEffect> make_friction_temperature() {
  return effect_of({.id = "friction_temperature",
                    .term = "temperature-dependent friction",
                    .equation = "mu (1 + k (T_sheath - T_ref))",
                    .life_consequence =
                        "a sheath that is hotter than the reference has another mu phi, and life "
                        "goes with exp(-gamma k mu phi dT) for each kelvin that it stays so",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .shifts_sessions = true,
                    .columns = columns});
}

}  // namespace host_sim::effects
