#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

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
  return {column_of(covariates, [&](std::size_t i) {
    return -baseline.friction_coefficient * angle_and_direction(covariates, i) *
           growth(covariates.cycle[i], shape);
  })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_friction_wear();

std::unique_ptr<TensionEffect> make_friction_wear() {
  return effect_of(
      {.id = "friction_wear",
       .term = "wear or run-in of the sheath",
       .equation = "mu(n) = mu (1 + a (n/1000)^p), or mu (1 + a exp(-n/n0)) where p = 0",
       .life_consequence = "the amplitude (13) grows with mu phi as the sheath wears, so that "
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
       .columns = columns});
}

}  // namespace host_sim::effects
