#include <algorithm>
#include <cmath>

#include "host_sim/effects/tension/columns.hpp"
#include "host_sim/effects/tension/definition.hpp"

namespace host_sim::effects {
namespace {

namespace bend_angle {

constexpr Parameter kParameters[] = {
    {.name = "bend_angle_error_rad",
     .unit = "rad",
     .minimum = -0.6,
     .maximum = 0.6,
     .typical = 0.26},
};

constexpr Separation kSeparations[] = {
    {"gear_asymmetry", "measure at four or more bend angles: an asymmetry is the same at each"},
};

std::size_t nearest(const std::vector<double>& poses_rad, double bend_angle_rad) {
  const auto closer = [&](double a, double b) {
    return std::abs(a - bend_angle_rad) < std::abs(b - bend_angle_rad);
  };
  return static_cast<std::size_t>(std::ranges::min_element(poses_rad, closer) - poses_rad.begin());
}

/// r = -mu s delta in the samples of the pose, 0 in the others.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double>) {
  const bool one_pose = baseline.poses_rad.empty();
  Columns columns(one_pose ? 1 : baseline.poses_rad.size(),
                  std::vector<double>(covariates.samples()));
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    const std::size_t pose =
        one_pose ? 0 : nearest(baseline.poses_rad, covariates.bend_angle_rad[i]);
    columns[pose][i] = -baseline.friction_coefficient * covariates.direction[i];
  }
  return columns;
}

TensionDefinition definition() {
  return {
      .id = "bend_angle",
      .term = "bend-angle (pose) error",
      .equation = "mu (phi + delta), delta of each pose",
      .life_consequence =
          "a pose that bends more than it was said to has input tensions larger by exp(mu delta)",
      .parameters = kParameters,
      .separations = kSeparations,
      .per_pose = true,
      .shifts_sessions = true,
      .columns = columns};
}

}  // namespace bend_angle

namespace compliance {

constexpr Parameter kParameters[] = {
    {.name = "compliance_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "stiffness_N_m", .unit = "N/m", .minimum = 1e3, .maximum = 1e6, .typical = 1e4},
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

TensionDefinition definition() {
  return {.id = "compliance",
          .term = "elasticity of sheath and tendon",
          .equation = "s = sgn(v - (dT_in/dt)/k), stuck where that is 0",
          .life_consequence =
              "friction turns over earlier than the motor does, which "
              "moves the peaks of input tension at each reversal",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .at_reversals = true,
          .shapes = {{1e3}, {2e3}, {5e3}, {1e4}, {2e4}, {5e4}, {1e5}, {2e5}, {5e5}},
          .columns = columns};
}

}  // namespace compliance

namespace presliding {

constexpr Parameter kParameters[] = {
    {.name = "presliding_share", .unit = "1", .minimum = 0, .maximum = 1, .typical = 1},
    {.name = "presliding_length_m",
     .unit = "m",
     .minimum = 5e-5,
     .maximum = 1e-2,
     .typical = 3.5e-4},
};

constexpr Separation kSeparations[] = {
    {"slack", "step the pretension: slack closes, presliding stays"},
    {"compliance", "reverse at two loads and two poses"},
};

constexpr Need kNeeds[] = {kTravelNeed};

/// w = z s obeys dw/dx = (1 - w)/d along the travel x since a reversal, and changes its sign there:
/// 1 - w = (1 + w_before) exp(-x/d). r = -mu phi (z - s) = mu phi s (1 - w). Before the first
/// reversal that was seen z is s.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double length_m = shape[0];
  const double mu = friction_at_reversals(covariates, baseline);
  double left_at_reversal = 0;
  double left = 0;
  return {column_of(covariates, [&](std::size_t i) {
    if (turns_at(covariates, i)) {
      left_at_reversal = 2 - left;
    }
    left = left_at_reversal * std::exp(-covariates.travel_m[i] / length_m);
    return mu * angle_and_direction(covariates, i) * left;
  })};
}

TensionDefinition definition() {
  return {.id = "presliding",
          .term = "Dahl or LuGre hysteresis",
          .equation = "T_out = T_in exp(-mu phi z), dz/dt = (v/d) (1 - z s)",
          .life_consequence =
              "strokes shorter than d never build up the full friction, so that small "
              "cycles of input tension are smaller than the Capstan law makes them",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .at_reversals = true,
          .shapes = {{5e-5}, {1e-4}, {2e-4}, {3.5e-4}, {6e-4}, {1e-3}, {2e-3}, {4e-3}, {8e-3}},
          .columns = columns};
}

}  // namespace presliding

namespace slack {

constexpr Parameter kParameters[] = {
    {.name = "slack_log_drop", .unit = "1", .minimum = -3, .maximum = 3, .typical = 0.3},
    {.name = "slack_friction_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1},
    {.name = "slack_m", .unit = "m", .minimum = 1e-4, .maximum = 2e-3, .typical = 4e-4},
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

TensionDefinition definition() {
  return {
      .id = "slack",
      .term = "backlash or dead zone",
      .equation =
          "ln T_out = ln T_in + a - (1 - h) mu phi s until the travel since a reversal reaches b",
      .life_consequence =
          "short swings of input tension do not reach the output, "
          "and the take-up adds a swing at each reversal",
      .parameters = kParameters,
      .separations = kSeparations,
      .needs = kNeeds,
      .at_reversals = true,
      .shapes = {{1e-4}, {2e-4}, {4e-4}, {7e-4}, {1.2e-3}, {2e-3}},
      .columns = columns};
}

}  // namespace slack

}  // namespace

std::vector<TensionDefinition> transmission_effects() {
  return {bend_angle::definition(), compliance::definition(), presliding::definition(),
          slack::definition()};
}

}  // namespace host_sim::effects
