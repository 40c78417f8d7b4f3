#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/mid_tension.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

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

}  // namespace

std::unique_ptr<TensionEffect> make_torque_ripple();

std::unique_ptr<TensionEffect> make_torque_ripple() {
  return effect_of(
      {.id = "torque_ripple",
       .term = "cogging and torque ripple",
       .equation = "T_in = K_t (I - I_0 + a sin(k theta) + b cos(k theta)) N eta_g / r_spool",
       .life_consequence = "adds many small cycles of input tension, each of little damage",
       .parameters = kParameters,
       .separations = kSeparations,
       .needs = kNeeds,
       .acts_on_current = true,
       .shapes = {{1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}, {10}, {12}, {14}, {16}, {18}, {21}, {24}},
       .whole_shapes = true,
       .columns = columns});
}

}  // namespace host_sim::effects
