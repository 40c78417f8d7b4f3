#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"
#include "host_sim/effects/tension/time_steps.hpp"
#include "host_sim/effects/tension/turn.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "lag_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1, .expected = 1},
    {.name = "lag_s",
     .unit = "s",
     .minimum = -0.05,
     .maximum = 0.05,
     .typical = 0.005,
     .scaled_by_share = true,
     .model_error = 0.02},
};

constexpr Separation kSeparations[] = {
    {"compliance", "sweep the frequency at the same speed"},
    {"friction_velocity", "run at constant speed, several speeds at the same tension"},
    {"undersampling", "decimate the data"},
};

constexpr Need kNeeds[] = {kVelocityNeed, kOutputRateNeed};

/// A reading that follows a level that stays, for a time.
double follow(double reading, double level, double lag_s, double time_s) {
  return level + (reading - level) * std::exp(-time_s / lag_s);
}

/// Of the output, whose tension is smooth: r = -tau d ln T_out/dt.
double behind_output(const recording::Covariates& covariates, std::size_t i, double lag_s) {
  return -covariates.log_output_rate_1_s[i] * lag_s;
}

/// Of the input, which also jumps by friction at each reversal: what a reading of exp(mu phi s)
/// lacks of it in the logarithm, and the lag of the smooth part.
std::vector<double> behind_input(const recording::Covariates& covariates, const Baseline& baseline,
                                 double lag_s) {
  const TimeSteps steps(covariates);
  const double mu = friction_at_reversals(covariates, baseline);
  const auto level_at = [&](std::size_t i) {
    return std::exp(mu * angle_and_direction(covariates, i));
  };
  double reading = 0;
  return column_of(covariates, [&](std::size_t i) {
    const double level = level_at(i);
    if (steps.starts(i)) {
      reading = level;
    } else {
      const double share = turns_at(covariates, i) ? turned_at(covariates, i) : 0;
      const double step_s = steps.before_s(i);
      reading = follow(reading, level_at(i - 1), lag_s, share * step_s);
      reading = follow(reading, level, lag_s, (1 - share) * step_s);
    }
    return std::log(reading / level) + behind_output(covariates, i, lag_s);
  });
}

/// A positive lag is of the output, a negative one of the input. The rate of T_out by central
/// differences has no noise in common with r.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double lag_s = shape[0];
  if (lag_s > 0) {
    return {
        column_of(covariates, [&](std::size_t i) { return behind_output(covariates, i, lag_s); })};
  }
  std::vector<double> column = behind_input(covariates, baseline, -lag_s);
  for (double& value : column) {
    value = -value;
  }
  return {column};
}

}  // namespace

std::unique_ptr<TensionEffect> make_filter_lag();

std::unique_ptr<TensionEffect> make_filter_lag() {
  return effect_of({.id = "filter_lag",
                    .term = "first-order lag of a sensor or filter",
                    .equation = "T measured = T - tau dT measured/dt, of the output where tau is "
                                "positive, of the input where it is negative",
                    .life_consequence = "the measured loop is wider or narrower than the true one, "
                                        "and peaks of fast cycles are cut",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .at_reversals = true,
                    .shapes = {{-0.04},
                               {-0.02},
                               {-0.01},
                               {-0.005},
                               {-0.0025},
                               {-0.00125},
                               {0.00125},
                               {0.0025},
                               {0.005},
                               {0.01},
                               {0.02},
                               {0.04}},
                    .columns = columns});
}

}  // namespace host_sim::effects
