#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

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

}  // namespace

std::unique_ptr<TensionEffect> make_friction_position();

std::unique_ptr<TensionEffect> make_friction_position() {
  return effect_of({.id = "friction_position",
                    .term = "position-dependent friction of features along the route",
                    .equation = "mu (1 + g(x) + h(x) s), Fourier sums of 2 pi x/L: g of six "
                                "harmonics, h of two",
                    .life_consequence = "wire that dwells on the tight part of the route sees a "
                                        "larger amplitude than the mean mu gives",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .shapes = {{0.01}, {0.02}, {0.04}, {0.08}, {0.16}, {0.32}},
                    .columns = columns});
}

}  // namespace host_sim::effects
