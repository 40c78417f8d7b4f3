#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "host_sim/effects/tension/columns.hpp"
#include "host_sim/effects/tension/definition.hpp"

namespace host_sim::effects {
namespace {

namespace friction_load {

constexpr double kReference_N = 50;
constexpr int kRounds = 3;

constexpr Parameter kParameters[] = {
    {.name = "load_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1},
    {.name = "load_exponent",
     .unit = "1",
     .minimum = -1,
     .maximum = 1,
     .typical = 0.2,
     .scaled_by_share = true},
};

constexpr Separation kSeparations[] = {
    {"current_offset", "vary the bend angle at one tension"},
    {"friction_preload", "measure at low and at high tension"},
};

/// Along the sheath d ln T = -mu (T/T_0)^-k s d phi, so that T_in^k - T_out^k = k mu phi s T_0^k.
/// Over the geometric mean M of both ends that is
/// (2/k) sinh(k ln(T_in/T_out)/2) = mu phi s (T_0/M)^k, and r = mu phi s - ln(T_in/T_out). With P,
/// the input between both ends by their noise, ln M = ln P - mu phi s/2 + (1/2 - w) r.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double exponent = shape[0];
  const double log_reference = std::log(kReference_N);
  return {column_of(covariates, [&](std::size_t i) {
    const double grip = baseline.friction_coefficient * angle_and_direction(covariates, i);
    const double log_mid =
        std::log(covariates.tension_in_N()[i]) + log_to_mid_tension(covariates, baseline, i);
    const double off_middle = 0.5 - input_noise_share(covariates, i);
    double r = 0;
    for (int round = 0; round < kRounds; ++round) {
      const double log_mean = log_mid - grip / 2 + off_middle * r;
      const double there = grip * std::exp(exponent * (log_reference - log_mean));
      r = grip - 2 / exponent * std::asinh(exponent * there / 2);
    }
    return r;
  })};
}

TensionDefinition definition() {
  return {.id = "friction_load",
          .term = "load-dependent friction",
          .equation = "mu (T/50 N)^-k with the tension T at each place of the sheath",
          .life_consequence =
              "friction relative to load falls as load rises, so that mu "
              "from light tests overstates the damage of heavy use",
          .parameters = kParameters,
          .separations = kSeparations,
          .shapes = {{-0.8},
                     {-0.4},
                     {-0.2},
                     {-0.1},
                     {-0.05},
                     {-0.025},
                     {0.025},
                     {0.05},
                     {0.1},
                     {0.2},
                     {0.4},
                     {0.8}},
          .columns = columns};
}

}  // namespace friction_load

namespace friction_position {

constexpr int kHarmonics = 6;
constexpr int kDirectionHarmonics = 2;

constexpr Parameter kParameters[] = {
    {.name = "position_sine_1", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_1", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_sine_2", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_2", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_sine_3", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_3", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_sine_4", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_4", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_sine_5", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_5", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_sine_6", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_6", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "direction_sine_1",
     .unit = "1",
     .minimum = -1,
     .maximum = 1,
     .typical = 0.1,
     .off_line = true},
    {.name = "direction_cosine_1",
     .unit = "1",
     .minimum = -1,
     .maximum = 1,
     .typical = 0.1,
     .off_line = true},
    {.name = "direction_sine_2",
     .unit = "1",
     .minimum = -1,
     .maximum = 1,
     .typical = 0.1,
     .off_line = true},
    {.name = "direction_cosine_2",
     .unit = "1",
     .minimum = -1,
     .maximum = 1,
     .typical = 0.1,
     .off_line = true},
    {.name = "wavelength_m", .unit = "m", .minimum = 0.01, .maximum = 0.32, .typical = 0.08},
};

constexpr Separation kSeparations[] = {
    {"torque_ripple", "repeat the stroke at several loads"},
    {"friction_velocity", "run over the same positions at several constant speeds"},
};

constexpr Need kNeeds[] = {kPositionNeed};

/// Sine and cosine of each harmonic of 2 pi x/L, each times what `factor(i)` says of the sample.
template <class Factor>
void add_harmonics(const std::vector<std::complex<double>>& turns, int harmonics, Factor&& factor,
                   Columns& columns) {
  std::vector<std::complex<double>> powers(turns.size(), 1);
  for (int harmonic = 1; harmonic <= harmonics; ++harmonic) {
    std::vector<double> sine(turns.size());
    std::vector<double> cosine(turns.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
      powers[i] *= turns[i];
      sine[i] = factor(i) * powers[i].imag();
      cosine[i] = factor(i) * powers[i].real();
    }
    columns.push_back(std::move(sine));
    columns.push_back(std::move(cosine));
  }
}

/// mu (1 + g + h s) is the friction coefficient of each direction, and r = -mu phi (s g + h).
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double radians_1_m = 2 * std::numbers::pi / shape[0];
  std::vector<std::complex<double>> turns;
  turns.reserve(covariates.samples());
  for (const double position_m : covariates.position_m) {
    turns.push_back(std::polar(1.0, radians_1_m * position_m));
  }
  const double mu = baseline.friction_coefficient;
  Columns columns;
  const auto both = [&](std::size_t i) { return -mu * angle_and_direction(covariates, i); };
  const auto one = [&](std::size_t i) { return -mu * covariates.bend_angle_rad[i]; };
  add_harmonics(turns, kHarmonics, both, columns);
  add_harmonics(turns, kDirectionHarmonics, one, columns);
  return columns;
}

TensionDefinition definition() {
  return {.id = "friction_position",
          .term = "position-dependent friction of features along the route",
          .equation =
              "mu (1 + g(x) + h(x) s), Fourier sums of 2 pi x/L: g of six "
              "harmonics, h of two",
          .life_consequence =
              "wire that dwells on the tight part of the route sees a "
              "larger amplitude than the mean mu gives",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .shapes = {{0.01}, {0.02}, {0.04}, {0.08}, {0.16}, {0.32}},
          .columns = columns};
}

}  // namespace friction_position

namespace friction_preload {

constexpr Parameter kParameters[] = {
    {.name = "preload_share", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1},
    {.name = "preload_N",
     .unit = "N",
     .minimum = 0,
     .maximum = 50,
     .typical = 2,
     .scaled_by_share = true},
};

constexpr Separation kSeparations[] = {
    {"current_offset",
     "move in both directions at low and at high tension: an offset of the sensor does not change "
     "sign with s"},
    {"friction_load", "measure at low and at high tension"},
};

/// T_in - T_out exp(mu phi s) = F s, over the tension between both terms.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double preload_N = shape[0];
  return {column_of(covariates, [&](std::size_t i) {
    const double mid_N = covariates.tension_in_N()[i] * to_mid_tension(covariates, baseline, i);
    return log_of_difference(preload_N * covariates.direction[i] / mid_N,
                             input_noise_share(covariates, i));
  })};
}

TensionDefinition definition() {
  return {.id = "friction_preload",
          .term = "load-independent (Coulomb) friction of seals and sheath preload",
          .equation = "T_out = (T_in - F s) exp(-mu phi s)",
          .life_consequence =
              "adds F to the amplitude of input tension at each reversal, most of all "
              "in relative terms at low tension, where lives are long",
          .parameters = kParameters,
          .separations = kSeparations,
          .shapes = {{0.15}, {0.3}, {0.6}, {1.2}, {2.5}, {5}, {10}, {20}, {40}},
          .columns = columns};
}

}  // namespace friction_preload

namespace friction_temperature {

constexpr Parameter kParameters[] = {
    {.name = "temperature_coefficient_1_K",
     .unit = "1/K",
     .minimum = -0.05,
     .maximum = 0.05,
     .typical = 0.005},
};

constexpr Separation kSeparations[] = {
    {"friction_wear", "heat the sheath alone, at one cycle number"},
    {"torque_gain", "heat the sheath alone, with the winding cold"},
};

constexpr Need kNeeds[] = {kSheathTemperatureNeed};

/// r = -mu phi s (T - T_ref) k.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double>) {
  return {column_of(covariates, [&](std::size_t i) {
    return -baseline.friction_coefficient * angle_and_direction(covariates, i) *
           (covariates.sheath_temperature_C[i] - baseline.sheath_reference_C);
  })};
}

TensionDefinition definition() {
  return {.id = "friction_temperature",
          .term = "temperature-dependent friction",
          .equation = "mu (1 + k (T_sheath - T_ref))",
          .life_consequence =
              "a sheath that is hotter than the reference has another mu phi, and life "
              "goes with exp(-gamma k mu phi dT) for each kelvin that it stays so",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .shifts_sessions = true,
          .columns = columns};
}

}  // namespace friction_temperature

namespace friction_velocity {

constexpr Parameter kParameters[] = {
    {.name = "stribeck_friction", .unit = "1", .minimum = -0.5, .maximum = 0.5, .typical = 0.05},
    {.name = "viscous_friction_s_m", .unit = "s/m", .minimum = -10, .maximum = 10, .typical = 0.5},
    {.name = "stribeck_velocity_m_s",
     .unit = "m/s",
     .minimum = 0.002,
     .maximum = 0.1,
     .typical = 0.02},
};

constexpr Separation kSeparations[] = {
    {"filter_lag", "run at constant speed, several speeds at the same tension"},
    {"friction_position", "run over the same positions at several constant speeds"},
};

constexpr Need kNeeds[] = {kVelocityNeed};

/// r = -phi s exp(-|v|/v_s) (mu_s - mu) - phi s |v| kappa.
Columns columns(const recording::Covariates& covariates, const Baseline&,
                std::span<const double> shape) {
  const double stribeck_velocity_m_s = shape[0];
  return {
      column_of(covariates,
                [&](std::size_t i) {
                  return -angle_and_direction(covariates, i) *
                         std::exp(-std::abs(covariates.velocity_m_s[i]) / stribeck_velocity_m_s);
                }),
      column_of(covariates, [&](std::size_t i) {
        return -angle_and_direction(covariates, i) * std::abs(covariates.velocity_m_s[i]);
      })};
}

TensionDefinition definition() {
  return {.id = "friction_velocity",
          .term = "viscous and Stribeck friction",
          .equation = "mu + (mu_s - mu) exp(-|v|/v_s) + kappa |v|",
          .life_consequence =
              "the same grip does more damage at the speed where friction is larger: "
              "input tension goes with exp(mu(v) phi)",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .shapes = {{0.002}, {0.005}, {0.01}, {0.02}, {0.05}, {0.1}},
          .columns = columns};
}

}  // namespace friction_velocity

namespace friction_wear {

constexpr double kReference_cycles = 1000;

constexpr Parameter kParameters[] = {
    {.name = "wear_coefficient", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.3},
    {.name = "wear_exponent", .unit = "1", .minimum = 0, .maximum = 2, .typical = 1},
    {.name = "run_in_cycles", .unit = "cycles", .minimum = 0, .maximum = 10000, .typical = 0},
};

constexpr Separation kSeparations[] = {
    {"friction_temperature", "start from cold at several cycle numbers"},
    {"torque_gain", "start with a cold winding at several cycle numbers"},
};

constexpr Need kNeeds[] = {kCycleNeed};

/// Relative change of mu for a = 1.
double growth(double cycle, std::span<const double> shape) {
  const double exponent = shape[0];
  const double run_in_cycles = shape[1];
  return exponent > 0 ? std::pow(cycle / kReference_cycles, exponent)
                      : std::exp(-cycle / run_in_cycles);
}

/// Small signal: T_out = T_in exp(-mu (1 + a g) phi s) gives r = -mu phi s g a.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  double cycle = -1;
  double grown = 0;
  return {column_of(covariates, [&](std::size_t i) {
    if (covariates.cycle[i] != cycle) {  // few cycles, of many samples each
      cycle = covariates.cycle[i];
      grown = growth(cycle, shape);
    }
    return -baseline.friction_coefficient * angle_and_direction(covariates, i) * grown;
  })};
}

TensionDefinition definition() {
  return {.id = "friction_wear",
          .term = "wear or run-in of the sheath",
          .equation = "mu(n) = mu (1 + a (n/1000)^p), or mu (1 + a exp(-n/n0)) where p = 0",
          .life_consequence =
              "the amplitude (13) grows with mu phi as the sheath wears, so that "
              "later cycles do more damage than Miner books for new ones",
          .parameters = kParameters,
          .separations = kSeparations,
          .needs = kNeeds,
          .shifts_sessions = true,
          .shapes = {{0.25, 0},
                     {0.5, 0},
                     {0.75, 0},
                     {1, 0},
                     {1.5, 0},
                     {2, 0},
                     {0, 30},
                     {0, 100},
                     {0, 300},
                     {0, 1000},
                     {0, 3000},
                     {0, 10000}},
          .columns = columns};
}

}  // namespace friction_wear

}  // namespace

std::vector<TensionDefinition> friction_effects() {
  return {friction_load::definition(),     friction_position::definition(),
          friction_preload::definition(),  friction_temperature::definition(),
          friction_velocity::definition(), friction_wear::definition()};
}

}  // namespace host_sim::effects
