#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "stribeck_friction", .unit = "1", .minimum = -0.5, .maximum = 0.5, .typical = 0.05},
    {.name = "viscous_friction_s_m",
     .unit = "s/m",
     .minimum = -10,
     .maximum = 10,
     .typical = 0.5,
     .model_error = 0.02},
    {.name = "stribeck_velocity_m_s",
     .unit = "m/s",
     .minimum = 0.002,
     .maximum = 0.1,
     .typical = 0.02},
};

constexpr Separation kSeparations[] = {
    {"filter_lag", "run at constant speed, several speeds at the same tension"},
    {"friction_position", "run over the same positions at several constant speeds"},
};

constexpr Need kNeeds[] = {kVelocityNeed};

/// r = -phi s exp(-|v|/v_s) (mu_s - mu) - phi s |v| kappa.
Columns columns(const recording::Covariates& covariates, const Baseline&,
                std::span<const double> shape) {
  const double stribeck_velocity_m_s = shape[0];
  return {
      column_of(covariates,
                [&](std::size_t i) {
                  return -angle_and_direction(covariates, i) *
                         std::exp(-std::abs(covariates.velocity_m_s[i]) / stribeck_velocity_m_s);
                }),
      column_of(covariates, [&](std::size_t i) {
        return -angle_and_direction(covariates, i) * std::abs(covariates.velocity_m_s[i]);
      })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_friction_velocity();

std::unique_ptr<TensionEffect> make_friction_velocity() {
  return effect_of({.id = "friction_velocity",
                    .term = "viscous and Stribeck friction",
                    .equation = "mu + (mu_s - mu) exp(-|v|/v_s) + kappa |v|",
                    .life_consequence =
                        "the same grip does more damage at the speed where friction is larger: "
                        "input tension goes with exp(mu(v) phi)",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .shapes = {{0.002}, {0.005}, {0.01}, {0.02}, {0.05}, {0.1}},
                    .columns = columns});
}

}  // namespace host_sim::effects
