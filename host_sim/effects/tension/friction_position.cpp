#include <cmath>
#include <numbers>
#include <utility>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr int kHarmonics = 3;

constexpr Parameter kParameters[] = {
    {.name = "position_sine_1", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_1", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_sine_2", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_2", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_sine_3", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "position_cosine_3", .unit = "1", .minimum = -1, .maximum = 1, .typical = 0.1},
    {.name = "wavelength_m", .unit = "m", .minimum = 0.02, .maximum = 0.32, .typical = 0.08},
};

constexpr Separation kSeparations[] = {
    {"torque_ripple", "repeat the stroke at several loads"},
    {"friction_velocity", "run over the same positions at several constant speeds"},
};

constexpr Need kNeeds[] = {kPositionNeed};

/// r = -mu phi s (sin(2 pi h x/L) a_h + cos(2 pi h x/L) b_h) of each harmonic h.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double> shape) {
  const double wavelength_m = shape[0];
  Columns columns;
  for (int harmonic = 1; harmonic <= kHarmonics; ++harmonic) {
    const double radians_1_m = 2 * std::numbers::pi * harmonic / wavelength_m;
    std::vector<double> sine(covariates.samples());
    std::vector<double> cosine(covariates.samples());
    for (std::size_t i = 0; i < covariates.samples(); ++i) {
      const double friction = -baseline.friction_coefficient * angle_and_direction(covariates, i);
      sine[i] = friction * std::sin(radians_1_m * covariates.position_m[i]);
      cosine[i] = friction * std::cos(radians_1_m * covariates.position_m[i]);
    }
    columns.push_back(std::move(sine));
    columns.push_back(std::move(cosine));
  }
  return columns;
}

}  // namespace

std::unique_ptr<TensionEffect> make_friction_position();

std::unique_ptr<TensionEffect> make_friction_position() {
  return effect_of({.id = "friction_position",
                    .term = "position-dependent friction of features along the route",
                    .equation = "mu (1 + g(x)), g a Fourier sum of three harmonics of 2 pi x/L",
                    .life_consequence = "wire that dwells on the tight part of the route sees a "
                                        "larger amplitude than the mean mu gives",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .needs = kNeeds,
                    .shapes = {{0.02}, {0.04}, {0.08}, {0.16}, {0.32}},
                    .columns = columns});
}

}  // namespace host_sim::effects
