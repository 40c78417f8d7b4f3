#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/mid_tension.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "preload_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1, .expected = 1},
    {.name = "preload_N",
     .unit = "N",
     .minimum = 0,
     .maximum = 50,
     .typical = 2,
     .scaled_by_share = true},
};

constexpr Separation kSeparations[] = {
    {"current_offset",
     "move in both directions at low and at high tension: an offset of the sensor does not change "
     "sign with s"},
    {"friction_load", "measure at low and at high tension"},
};

/// T_in - T_out exp(mu phi s) = F s; over the geometric mean G of both terms that is
/// -2 sinh(r/2) = F s/G.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double preload_N = shape[0];
  return {column_of(covariates, [&](std::size_t i) {
    const double mid_N = covariates.tension_in_N()[i] * to_mid_tension(covariates, baseline, i);
    return -2 * std::asinh(preload_N * covariates.direction[i] / mid_N / 2);
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_friction_preload();

std::unique_ptr<TensionEffect> make_friction_preload() {
  return effect_of({.id = "friction_preload",
                    .term = "load-independent (Coulomb) friction of seals and sheath preload",
                    .equation = "T_out = (T_in - F s) exp(-mu phi s)",
                    .life_consequence =
                        "adds F to the amplitude of input tension at each reversal, most of all "
                        "in relative terms at low tension, where lives are long",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .shapes = {{0.15}, {0.3}, {0.6}, {1.2}, {2.5}, {5}, {10}, {20}, {40}},
                    .columns = columns});
}

}  // namespace host_sim::effects
