#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/mid_tension.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "preload_N", .unit = "N", .minimum = 0, .maximum = 50, .typical = 2},
};

constexpr Separation kSeparations[] = {
    {"current_offset",
     "move in both directions at low and at high tension: an offset of the sensor does not change "
     "sign with s"},
    {"friction_load", "measure at low and at high tension"},
};

/// ln(T_in - F s) is ln T_in - F s/T_in for small F, so r = -s/T_in F.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double>) {
  return {column_of(covariates, [&](std::size_t i) {
    return -covariates.direction[i] /
           (covariates.tension_in_N()[i] * to_mid_tension(covariates, baseline, i));
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
                    .columns = columns});
}

}  // namespace host_sim::effects
