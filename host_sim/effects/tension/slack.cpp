#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"
#include "host_sim/effects/tension/turn.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "slack_log_drop",
     .unit = "1",
     .minimum = -3,
     .maximum = 3,
     .typical = 0.3,
     .model_error = 0.002},
    {.name = "slack_friction_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1},
    {.name = "slack_m",
     .unit = "m",
     .minimum = 1e-4,
     .maximum = 2e-3,
     .typical = 4e-4,
     .model_error = 0.008},
};

constexpr Separation kSeparations[] = {
    {"presliding", "step the pretension: slack closes, presliding stays"},
    {"compliance", "step the pretension"},
};

constexpr Need kNeeds[] = {kTravelNeed};

/// Where nothing slides, r = a + h mu phi s: a is what the drive does not hold, h is 1 where
/// friction is gone and 2 where that of the way before is frozen. Nothing before the first
/// reversal.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double slack_m = shape[0];
  const double mu = friction_at_reversals(covariates, baseline);
  Columns columns(2, std::vector<double>(covariates.samples()));
  bool turned = false;
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    turned = turned || turns_at(covariates, i);
    if (turned && covariates.travel_m[i] < slack_m) {
      columns[0][i] = 1;
      columns[1][i] = mu * angle_and_direction(covariates, i);
    }
  }
  return columns;
}

}  // namespace

std::unique_ptr<TensionEffect> make_slack();

std::unique_ptr<TensionEffect> make_slack() {
  return effect_of(
      {.id = "slack",
       .term = "backlash or dead zone",
       .equation =
           "ln T_out = ln T_in + a - (1 - h) mu phi s until the travel since a reversal reaches b",
       .life_consequence = "short swings of input tension do not reach the output, "
                           "and the take-up adds a swing at each reversal",
       .parameters = kParameters,
       .separations = kSeparations,
       .needs = kNeeds,
       .at_reversals = true,
       .shapes = {{1e-4}, {2e-4}, {4e-4}, {7e-4}, {1.2e-3}, {2e-3}},
       .columns = columns});
}

}  // namespace host_sim::effects
