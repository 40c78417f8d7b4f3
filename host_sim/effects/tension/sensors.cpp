#include <algorithm>
#include <cmath>

#include "host_sim/effects/tension/columns.hpp"
#include "host_sim/effects/tension/definition.hpp"

namespace host_sim::effects {
namespace {

namespace current_offset {

constexpr Parameter kParameters[] = {
    {.name = "offset_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1},
    {.name = "current_offset_A",
     .unit = "A",
     .minimum = -0.5,
     .maximum = 0.5,
     .typical = 0.05,
     .scaled_by_share = true},
};

constexpr Separation kSeparations[] = {
    {"friction_preload",
     "move in both directions at low and at high tension: an offset of the sensor does not change "
     "sign with s"},
    {"friction_load", "vary the bend angle at one tension"},
    {"torque_gain", "take points near zero current and at high current"},
};

constexpr Need kNeeds[] = {kCurrentNeed};

/// The true current is i - b; the difference b over the current between both.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double offset_A = shape[0];
  return {column_of(covariates, [&](std::size_t i) {
    const double mid_A = covariates.current_A[i] * to_mid_tension(covariates, baseline, i);
    return log_of_difference(offset_A / mid_A, input_noise_share(covariates, i));
  })};
}

TensionDefinition definition() {
  return {.id = "current_offset",
          .term = "zero error of the current sensor",
          .equation = "T_in = K_t (I - I_0 - b) N eta_g / r_spool",
          .life_consequence =
              "all input tensions are wrong by the same number of "
              "newtons: the mean (12) moves and the amplitude (13) stays",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .acts_on_current = true,
          .shapes = {{-0.32},
                     {-0.16},
                     {-0.08},
                     {-0.04},
                     {-0.02},
                     {-0.01},
                     {-0.005},
                     {0.005},
                     {0.01},
                     {0.02},
                     {0.04},
                     {0.08},
                     {0.16},
                     {0.32}},
          .columns = columns};
}

}  // namespace current_offset

namespace filter_lag {

constexpr Parameter kParameters[] = {
    {.name = "lag_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1},
    {.name = "lag_s",
     .unit = "s",
     .minimum = -0.05,
     .maximum = 0.05,
     .typical = 0.005,
     .scaled_by_share = true},
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

/// 1 + tau d ln T_out/dt, of which a reading lags that follows T_out.
double ahead(const recording::Covariates& covariates, std::size_t i, double lag_s) {
  constexpr double kLeast = 0.1;
  return std::max(kLeast, 1 + lag_s * covariates.log_output_rate_1_s[i]);
}

/// Of the output, whose tension is T + tau dT/dt of its reading T.
double behind_output(const recording::Covariates& covariates, std::size_t i, double lag_s) {
  return -std::log(ahead(covariates, i, lag_s));
}

/// Of the input, which also jumps by friction at each reversal: what a reading of it lacks, over
/// T_out, of exp(mu phi s) in the logarithm. As T_out goes on, that ratio w obeys
/// tau dw/dt = exp(mu phi s) - w (1 + tau d ln T_out/dt).
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
    const double faster = ahead(covariates, i, lag_s);
    if (steps.starts(i)) {
      reading = level / faster;
    } else {
      const double share = turns_at(covariates, i) ? turned_at(covariates, i) : 0;
      const double step_s = steps.before_s(i);
      reading = follow(reading, level_at(i - 1) / faster, lag_s / faster, share * step_s);
      reading = follow(reading, level / faster, lag_s / faster, (1 - share) * step_s);
    }
    return std::log(reading / level);
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

TensionDefinition definition() {
  return {.id = "filter_lag",
          .term = "first-order lag of a sensor or filter",
          .equation =
              "T measured = T - tau dT measured/dt, of the output where tau is "
              "positive, of the input where it is negative",
          .life_consequence =
              "the measured loop is wider or narrower than the true one, "
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
          .columns = columns};
}

}  // namespace filter_lag

namespace gear_asymmetry {

constexpr Parameter kParameters[] = {
    {.name = "gear_asymmetry", .unit = "1", .minimum = -0.3, .maximum = 0.3, .typical = 0.02},
};

constexpr Separation kSeparations[] = {
    {"bend_angle", "measure at four or more bend angles: an asymmetry is the same at each"},
    {"friction_preload", "measure at low and at high tension"},
};

constexpr Need kNeeds[] = {kCurrentNeed};

/// ln(1 + c s) is c s for small c, so r = s c.
Columns columns(const recording::Covariates& covariates, const Baseline&, std::span<const double>) {
  return {column_of(covariates, [&](std::size_t i) { return covariates.direction[i]; })};
}

TensionDefinition definition() {
  return {.id = "gear_asymmetry",
          .term = "direction-dependent gear efficiency",
          .equation = "T_in = K_t (I - I_0) N eta_g (1 + c s) / r_spool",
          .life_consequence =
              "the amplitude of input tension is wrong by c times its mean, at every bend angle",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .acts_on_current = true,
          .shifts_sessions = true,
          .columns = columns};
}

}  // namespace gear_asymmetry

namespace torque_gain {

constexpr double kLeastGain = 0.05;

constexpr Parameter kParameters[] = {
    {.name = "droop_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1},
    {.name = "droop_1_K",
     .unit = "1/K",
     .minimum = 0,
     .maximum = 0.005,
     .typical = 0.001,
     .scaled_by_share = true},
};

constexpr Separation kSeparations[] = {
    {"friction_temperature", "heat the motor alone, with the sheath cold"},
    {"friction_wear", "start with a cold winding at several cycle numbers"},
    {"current_offset", "take points near zero current and at high current"},
};

constexpr Need kNeeds[] = {kCurrentNeed, kWindingTemperatureNeed};

/// r = ln(1 - alpha (T - T_ref)). A constant error of the gain is refitted anyway and is no effect.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double droop_1_K = shape[0];
  return {column_of(covariates, [&](std::size_t i) {
    const double warmer_K = covariates.winding_temperature_C[i] - baseline.winding_reference_C;
    return std::log(std::max(kLeastGain, 1 - droop_1_K * warmer_K));
  })};
}

TensionDefinition definition() {
  return {.id = "torque_gain",
          .term = "torque constant that falls as the winding warms",
          .equation = "T_in = K_t (1 - alpha (T_winding - T_ref)) (I - I_0) N eta_g / r_spool",
          .life_consequence =
              "a warm motor pulls less than its current says, so that damage is "
              "overstated by gamma alpha dT",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .acts_on_current = true,
          .shifts_sessions = true,
          .shapes = {{1.5e-4}, {3e-4}, {6e-4}, {1.2e-3}, {2.5e-3}, {5e-3}},
          .columns = columns};
}

}  // namespace torque_gain

namespace torque_ripple {

constexpr Parameter kParameters[] = {
    {.name = "ripple_sine_A", .unit = "A", .minimum = -0.5, .maximum = 0.5, .typical = 0.05},
    {.name = "ripple_cosine_A", .unit = "A", .minimum = -0.5, .maximum = 0.5, .typical = 0.05},
    {.name = "ripple_harmonic", .unit = "1", .minimum = 1, .maximum = 24, .typical = 6},
};

constexpr Separation kSeparations[] = {
    {"friction_position", "repeat the stroke at several loads"},
};

constexpr Need kNeeds[] = {kCurrentNeed, kMotorAngleNeed};

/// ln(i + q) is ln i + q/i for a small q, so r = sin(k theta)/i a + cos(k theta)/i b.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double harmonic = shape[0];
  Columns columns(2, std::vector<double>(covariates.samples()));
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    const double mid_A = covariates.current_A[i] * to_mid_tension(covariates, baseline, i);
    columns[0][i] = std::sin(harmonic * covariates.motor_angle_rad[i]) / mid_A;
    columns[1][i] = std::cos(harmonic * covariates.motor_angle_rad[i]) / mid_A;
  }
  return columns;
}

TensionDefinition definition() {
  return {
      .id = "torque_ripple",
      .term = "cogging and torque ripple",
      .equation = "T_in = K_t (I - I_0 + a sin(k theta) + b cos(k theta)) N eta_g / r_spool",
      .life_consequence = "adds many small cycles of input tension, each of little damage",
      .parameters = kParameters,
      .separations = kSeparations,
      .needs = kNeeds,
      .acts_on_current = true,
      .shapes = {{1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}, {10}, {12}, {14}, {16}, {18}, {21}, {24}},
      .whole_shapes = true,
      .columns = columns};
}

}  // namespace torque_ripple

}  // namespace

std::vector<TensionDefinition> sensor_effects() {
  return {current_offset::definition(), filter_lag::definition(), gear_asymmetry::definition(),
          torque_gain::definition(), torque_ripple::definition()};
}

}  // namespace host_sim::effects
