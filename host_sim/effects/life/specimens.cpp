#include "host_sim/effects/life/definition.hpp"

namespace host_sim::effects {
namespace {

namespace ageing {

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

LifeDefinition definition() {
  return {.id = "ageing",
          .term = "corrosion, calendar time",
          .equation = "alpha exp(-lambda days)",
          .life_consequence =
              "a tendon that is used seldom fails after fewer cycles than the test says",
          .parameters = kParameters,
          .separations = kSeparations,
          .missing = missing,
          .columns = columns};
}

}  // namespace ageing

namespace lot_frailty {

constexpr Parameter kParameters[] = {
    {.name = "lot_log_sd", .unit = "1", .minimum = 0, .maximum = 3, .typical = 0.2},
};

constexpr Separation kSeparations[] = {
    {"second_mode", "test each lot at each level"},
    {"load_sequence", "load blocks from high to low AND from low to high, in each lot"},
};

std::string_view missing(const LifeCovariates& covariates) {
  return covariates.lots() < 2 ? "a second lot: one has no scatter between lots" : "";
}

Scatter scatter(const LifeCovariates& covariates, const LifeBaseline&, std::span<const double>) {
  return {.log_life_sd = std::vector<double>(covariates.specimens(), 1),
          .shared_by = covariates.lot};
}

LifeDefinition definition() {
  return {.id = "lot_frailty",
          .kind = LifeEffectKind::scatter,
          .term = "batch-to-batch scatter",
          .equation = "ln N + sigma z, z standard normal, one for each lot",
          .life_consequence =
              "specimens of one lot do not count as independent: intervals from one "
              "lot are too narrow, B10 over lots is lower",
          .parameters = kParameters,
          .separations = kSeparations,
          .missing = missing,
          .scatter = scatter};
}

}  // namespace lot_frailty

namespace second_mode {

constexpr Parameter kParameters[] = {
    {.name = "log_life_shift", .unit = "1", .minimum = -5, .maximum = 2, .typical = 0.3},
    {.name = "second_log_sd", .unit = "1", .minimum = 0, .maximum = 1, .typical = 0.2},
    {.name = "levels_reached", .unit = "1", .minimum = -2, .maximum = 2, .typical = 1},
    {.name = "second_share",
     .unit = "1",
     .minimum = 0,
     .maximum = 1,
     .typical = 0.5,
     .off_line = true},
};

constexpr Separation kSeparations[] = {
    {"endurance_limit", "add a low level with suspended specimens"},
    {"lot_frailty", "test each lot at each level"},
};

/// The shape says how many levels the mode reaches, in all of their specimens: from the highest
/// load down, or where negative from the lowest up.
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

LifeDefinition definition() {
  return {.id = "second_mode",
          .kind = LifeEffectKind::both,
          .term = "competing failure mode",
          .equation =
              "R = exp(-(n/alpha)^beta - (n/alpha_2)^beta_2) at the levels that the second "
              "mode reaches; or (1 - q) exp(-(n/alpha)^beta) + q exp(-(n/alpha_2)^beta_2), q the "
              "share of specimens that have it",
          .life_consequence =
              "life there follows another line and another shape: B10 from the common "
              "shape is too long where the second shape is smaller",
          .parameters = kParameters,
          .separations = kSeparations,
          .shapes = {{-2, 0}, {-1, 0}, {1, 0}, {2, 0}},
          .columns = columns,
          .scatter = scatter};
}

}  // namespace second_mode

}  // namespace

std::vector<LifeDefinition> specimen_effects() {
  return {ageing::definition(), lot_frailty::definition(), second_mode::definition()};
}

}  // namespace host_sim::effects
