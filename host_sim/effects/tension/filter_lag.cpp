#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "lag_s", .unit = "s", .minimum = -0.05, .maximum = 0.05, .typical = 0.005},
};

constexpr Separation kSeparations[] = {
    {"compliance", "sweep the frequency at the same speed"},
    {"friction_velocity", "run at constant speed, several speeds at the same tension"},
    {"undersampling", "decimate the data"},
};

constexpr Need kNeeds[] = {kTensionRateNeed};

/// r = -(d ln T/dt) tau. Positive where the output lags the input, negative for the other way
/// round.
Columns columns(const recording::Covariates& covariates, const Baseline&, std::span<const double>) {
  return {
      column_of(covariates, [&](std::size_t i) { return -covariates.log_tension_rate_1_s[i]; })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_filter_lag();

std::unique_ptr<TensionEffect> make_filter_lag() {
  return effect_of({.id = "filter_lag",
                    .term = "first-order lag of a sensor or filter",
                    .equation = "T_out measured = T_out - tau dT_out/dt",
                    .life_consequence = "the measured loop is wider or narrower than the true one, "
                                        "and peaks of fast cycles are cut",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .columns = columns});
}

}  // namespace host_sim::effects
