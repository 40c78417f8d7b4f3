#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "log_life_shift", .unit = "1", .minimum = -2, .maximum = 2, .typical = 0.3},
    {.name = "second_log_sd", .unit = "1", .minimum = 0, .maximum = 1, .typical = 0.2},
    {.name = "levels_reached", .unit = "1", .minimum = -2, .maximum = 2, .typical = 1},
};

constexpr Separation kSeparations[] = {
    {"endurance_limit", "add a low level with suspended specimens"},
    {"lot_frailty", "test each lot at each level"},
};

std::string_view missing(const LifeCovariates& covariates) {
  return covariates.levels() < 2 ? "two levels or more" : "";
}

/// The shape says how many levels the mode reaches: from the highest load down, or where negative
/// from the lowest up.
bool reached(std::size_t level, std::size_t levels, double reach) {
  const double from_end =
      reach > 0 ? static_cast<double>(levels - 1 - level) : static_cast<double>(level);
  return from_end < std::abs(reach);
}

/// A shift of ln alpha of the levels that are reached.
Columns columns(const LifeCovariates& covariates, const LifeBaseline&,
                std::span<const double> shape) {
  std::vector<double> column;
  for (const std::size_t level : covariates.level) {
    column.push_back(reached(level, covariates.levels(), shape[0]) ? 1 : 0);
  }
  return {column};
}

Scatter scatter(const LifeCovariates& covariates, const LifeBaseline& baseline,
                std::span<const double> shape) {
  Scatter scatter{.log_life_sd = columns(covariates, baseline, shape).front(), .shared_by = {}};
  for (std::size_t specimen = 0; specimen < covariates.specimens(); ++specimen) {
    scatter.shared_by.push_back(specimen);
  }
  return scatter;
}

}  // namespace

std::unique_ptr<LifeEffect> make_second_mode();

std::unique_ptr<LifeEffect> make_second_mode() {
  return effect_of(
      {.id = "second_mode",
       .kind = LifeEffect::Kind::both,
       .term = "competing failure mode",
       .equation = "R = exp(-(n/alpha)^beta - (n/alpha_2)^beta_2) at the levels that the second "
                   "mode reaches",
       .life_consequence = "life there follows another line and another shape: B10 from the common "
                           "shape is too long where the second shape is smaller",
       .parameters = kParameters,
       .separations = kSeparations,
       .shapes = {{-2}, {-1}, {1}, {2}},
       .missing = missing,
       .columns = columns,
       .scatter = scatter});
}

}  // namespace host_sim::effects
