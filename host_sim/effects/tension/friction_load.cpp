#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr double kReference_N = 50;

constexpr Parameter kParameters[] = {
    {.name = "load_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1, .expected = 1},
    {.name = "load_exponent",
     .unit = "1",
     .minimum = -1,
     .maximum = 1,
     .typical = 0.2,
     .scaled_by_share = true,
     .model_error = 0.005},
};

constexpr Separation kSeparations[] = {
    {"current_offset", "vary the bend angle at one tension"},
    {"friction_preload", "measure at low and at high tension"},
};

/// Along the sheath d ln T = -mu (T/T_0)^-k s d phi, so that T_in^k - T_out^k = k mu phi s T_0^k.
/// Over the geometric mean M of both ends that is
/// (2/k) sinh(k ln(T_in/T_out)/2) = mu phi s (T_0/M)^k, and r = mu phi s - ln(T_in/T_out).
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double exponent = shape[0];
  return {column_of(covariates, [&](std::size_t i) {
    const double grip = baseline.friction_coefficient * angle_and_direction(covariates, i);
    const double mean_N = std::sqrt(covariates.tension_in_N()[i] * covariates.output_tension_N[i]);
    const double there = grip * std::pow(kReference_N / mean_N, exponent);
    return grip - 2 / exponent * std::asinh(exponent * there / 2);
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_friction_load();

std::unique_ptr<TensionEffect> make_friction_load() {
  return effect_of({.id = "friction_load",
                    .term = "load-dependent friction",
                    .equation = "mu (T/50 N)^-k with the tension T at each place of the sheath",
                    .life_consequence = "friction relative to load falls as load rises, so that mu "
                                        "from light tests overstates the damage of heavy use",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .shapes = {{-0.8},
                               {-0.4},
                               {-0.2},
                               {-0.1},
                               {-0.05},
                               {-0.025},
                               {0.025},
                               {0.05},
                               {0.1},
                               {0.2},
                               {0.4},
                               {0.8}},
                    .columns = columns});
}

}  // namespace host_sim::effects
