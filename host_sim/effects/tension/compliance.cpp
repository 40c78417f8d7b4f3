#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "compliance_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "stiffness_N_m", .unit = "N/m", .minimum = 1e3, .maximum = 1e5, .typical = 1e4},
};

constexpr Separation kSeparations[] = {
    {"filter_lag", "change the frequency at the same speed"},
    {"presliding", "change the rate of tension at the same travel"},
    {"slack", "step the pretension"},
};

constexpr Need kNeeds[] = {kVelocityNeed, kTensionRateNeed};

/// Where the sign is the other one r = -mu phi (-s - s) = 2 mu phi s, else 0.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double stiffness_N_m = shape[0];
  const std::vector<double>& tension_N = covariates.tension_in_N();
  return {column_of(covariates, [&](std::size_t i) {
    const double stretch_m_s = tension_N[i] * covariates.log_tension_rate_1_s[i] / stiffness_N_m;
    const bool other = (covariates.velocity_m_s[i] - stretch_m_s) * covariates.direction[i] < 0;
    return other ? 2 * baseline.friction_coefficient * angle_and_direction(covariates, i) : 0.0;
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_compliance();

std::unique_ptr<TensionEffect> make_compliance() {
  return effect_of({.id = "compliance",
                    .term = "elasticity of sheath and tendon",
                    .equation = "s = sgn(v - (dT_in/dt)/k)",
                    .life_consequence = "friction turns over earlier than the motor does, which "
                                        "moves the peaks of input tension at each reversal",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .shapes = {{1e3}, {2e3}, {5e3}, {1e4}, {2e4}, {5e4}, {1e5}},
                    .columns = columns});
}

}  // namespace host_sim::effects
