#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "ageing_1_day", .unit = "1/day", .minimum = 0, .maximum = 0.02, .typical = 0.001},
};

constexpr Separation kSeparations[] = {
    {"endurance_limit", "test at two frequencies"},
    {"second_mode", "test at two frequencies"},
};

std::string_view missing(const LifeCovariates& covariates) {
  return covariates.days.empty() ? "no days under test of each specimen (days)" : "";
}

/// ln N changes by -days lambda.
Columns columns(const LifeCovariates& covariates, const LifeBaseline&, std::span<const double>) {
  std::vector<double> column = covariates.days;
  for (double& value : column) {
    value = -value;
  }
  return {column};
}

}  // namespace

std::unique_ptr<LifeEffect> make_ageing();

std::unique_ptr<LifeEffect> make_ageing() {
  return effect_of({.id = "ageing",
                    .term = "corrosion, calendar time",
                    .equation = "alpha exp(-lambda days)",
                    .life_consequence =
                        "a tendon that is used seldom fails after fewer cycles than the test says",
                    .parameters = kParameters,
                    .separations = kSeparations,
                    .missing = missing,
                    .columns = columns});
}

}  // namespace host_sim::effects
