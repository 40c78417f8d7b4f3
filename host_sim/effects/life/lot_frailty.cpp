#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "lot_log_sd", .unit = "1", .minimum = 0, .maximum = 0.6, .typical = 0.2},
};

constexpr Separation kSeparations[] = {
    {"second_mode", "test each lot at each level"},
    {"load_sequence", "load blocks from high to low AND from low to high, in each lot"},
};

std::string_view missing(const LifeCovariates& covariates) {
  return covariates.lots() < 2 ? "a second lot: one has no scatter between lots" : "";
}

Scatter scatter(const LifeCovariates& covariates, const LifeBaseline&, std::span<const double>) {
  return {.log_life_sd = std::vector<double>(covariates.specimens(), 1),
          .shared_by = covariates.lot};
}

}  // namespace

std::unique_ptr<LifeEffect> make_lot_frailty();

std::unique_ptr<LifeEffect> make_lot_frailty() {
  return effect_of({.id = "lot_frailty",
                    .kind = LifeEffect::Kind::scatter,
                    .term = "batch-to-batch scatter",
                    .equation = "ln N + sigma z, z standard normal, one for each lot",
                    .life_consequence =
                        "specimens of one lot do not count as independent: intervals from one "
                        "lot are too narrow, B10 over lots is lower",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .missing = missing,
                    .scatter = scatter});
}

}  // namespace host_sim::effects
