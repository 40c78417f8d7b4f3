#include <algorithm>
#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"
#include "host_sim/effects/tension/time_steps.hpp"
#include "host_sim/effects/tension/turn.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "compliance_share",
     .unit = "1",
     .minimum = 0,
     .maximum = 1,
     .typical = 1,
     .expected = 1},
    {.name = "stiffness_N_m",
     .unit = "N/m",
     .minimum = 1e3,
     .maximum = 1e6,
     .typical = 1e4,
     .model_error = 0.006},
};

constexpr Separation kSeparations[] = {
    {"filter_lag", "change the frequency at the same speed"},
    {"presliding", "change the rate of tension at the same travel"},
    {"slack", "step the pretension"},
};

constexpr Need kNeeds[] = {kPositionNeed, kOutputRateNeed};

/// The part of a step before the motion turned and the part after it: where the velocity, taken as
/// linear, is zero.
struct Way {
  double before_m = 0, after_m = 0, before_share = 1;
};

Way way_to(const recording::Covariates& covariates, std::size_t i) {
  const double pulled_m = covariates.position_m[i] - covariates.position_m[i - 1];
  if (!turns_at(covariates, i)) {
    return {.before_m = pulled_m};
  }
  const double share = turned_at(covariates, i);
  const double step_s = covariates.time_s[i] - covariates.time_s[i - 1];
  const double before_m = covariates.velocity_m_s[i - 1] * share * step_s / 2;
  return {.before_m = before_m, .after_m = pulled_m - before_m, .before_share = share};
}

/// Between slips T_in follows the spring, dT_in = k dx; it never leaves what friction holds,
/// T_out exp(+-mu phi). With w = T_in/T_out the motion in one step is
/// w exp(-g dt) + k dx/T_out, g = d ln T_out/dt, and r = mu phi s - ln w. Starts from sliding.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double stiffness_N_m = shape[0];
  const double mu = friction_at_reversals(covariates, baseline);
  const TimeSteps steps(covariates);
  double ratio = 0;
  return {column_of(covariates, [&](std::size_t i) {
    const double grip = mu * covariates.bend_angle_rad[i];
    const double sliding = grip * covariates.direction[i];
    if (steps.starts(i)) {
      ratio = std::exp(sliding);
      return 0.0;
    }
    const double output_N = covariates.output_tension_N[i];
    // Over a gap the tension itself says more than its rate, whose noise is hardly any of the
    // residual's.
    const double log_kept = steps.gap(i) ? std::log(covariates.output_tension_N[i - 1] / output_N)
                                         : -covariates.log_output_rate_1_s[i] * steps.before_s(i);
    const Way way = way_to(covariates, i);
    const auto follow = [&](double pulled_m, double share) {
      const double held = ratio * std::exp(share * log_kept) + stiffness_N_m * pulled_m / output_N;
      ratio = std::clamp(held, std::exp(-std::abs(grip)), std::exp(std::abs(grip)));
    };
    follow(way.before_m, way.before_share);
    follow(way.after_m, 1 - way.before_share);
    return sliding - std::log(ratio);
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_compliance();

std::unique_ptr<TensionEffect> make_compliance() {
  return effect_of({.id = "compliance",
                    .term = "elasticity of sheath and tendon",
                    .equation = "s = sgn(v - (dT_in/dt)/k), stuck where that is 0",
                    .life_consequence = "friction turns over earlier than the motor does, which "
                                        "moves the peaks of input tension at each reversal",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .at_reversals = true,
                    .shapes = {{1e3}, {2e3}, {5e3}, {1e4}, {2e4}, {5e4}, {1e5}, {2e5}, {5e5}},
                    .columns = columns});
}

}  // namespace host_sim::effects
