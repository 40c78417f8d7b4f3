#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "bending_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "bending_N", .unit = "N", .minimum = 50, .maximum = 2000, .typical = 400},
};

constexpr Separation kSeparations[] = {
    {"mean_stress", "test two bend diameters at one tension"},
    {"second_mode", "test two bend diameters at one tension"},
};

std::string_view missing(const LifeCovariates& covariates) {
  return covariates.wire_to_bend_ratio.empty()
             ? "no wire-to-bend ratio of each specimen (wire_to_bend_ratio)"
             : "";
}

/// With Gerber T_eff grows by the factor 1 + c (d_w/D)/T_a.
Columns columns(const LifeCovariates& covariates, const LifeBaseline& baseline,
                std::span<const double> shape) {
  const double bending_N = shape[0];
  return {over_blocks(covariates, [&](const LifeCovariates::Block& block, std::size_t specimen) {
    const double amplitude_N = bending_N * covariates.wire_to_bend_ratio[specimen];
    return -baseline.ipl_exponent * std::log1p(amplitude_N / block.amplitude_N);
  })};
}

}  // namespace

std::unique_ptr<LifeEffect> make_bending_fatigue();

std::unique_ptr<LifeEffect> make_bending_fatigue() {
  return effect_of({.id = "bending_fatigue",
                    .term = "bending stress of the wire over a small radius",
                    .equation = "T_a + c d_w/D in place of T_a, d_w/D the ratio of wire to bend",
                    .life_consequence = "tight bends cost life that no tension shows: at a given "
                                        "tension it falls with the ratio of wire to bend",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .shapes = {{50}, {100}, {200}, {400}, {800}, {2000}},
                    .missing = missing,
                    .columns = columns});
}

}  // namespace host_sim::effects
