#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr double kReference_N = 50;

constexpr Parameter kParameters[] = {
    {.name = "load_exponent", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.2},
};

constexpr Separation kSeparations[] = {
    {"current_offset", "vary the bend angle at one tension"},
    {"friction_preload", "measure at low and at high tension"},
};

/// Along the sheath d ln T = -mu (T/T_0)^-k s d phi. For small k the power is 1 - k ln(T/T_0), and
/// as ln T falls evenly, its mean over the sheath is that of both ends: r = mu phi s m k with
/// m = (ln T_in + ln T_out)/2 - ln T_0.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double>) {
  return {column_of(covariates, [&](std::size_t i) {
    const double product_N2 = covariates.tension_in_N()[i] * covariates.output_tension_N[i];
    return baseline.friction_coefficient * angle_and_direction(covariates, i) *
           std::log(product_N2 / (kReference_N * kReference_N)) / 2;
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
                    .columns = columns});
}

}  // namespace host_sim::effects
