#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/lives/terms.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// Covariates that an effect of the catalogue is all of weigh little against it.
constexpr double kLnLot = -4;
constexpr double kLnDays = -2;
constexpr double kLnShape = -1;

constexpr double kShift_sd = 0.4;
constexpr double kLogShape_sd = 0.5;

TermParameter between(std::string name, double minimum, double maximum, double typical) {
  const double share = (typical - minimum) / (maximum - minimum);
  return {.name = std::move(name),
          .unit = "1",
          .bounded = true,
          .minimum = minimum,
          .maximum = maximum,
          .centre = std::log(share / (1 - share)),
          .spread = 1};
}

Term of_group() {
  return {.id = "group",
          .outside = true,
          .parameters = {between("group_log_sd", 0, 0.6, 0.2)},
          .apply = [](std::span<const double> values, LifeSettings& settings) {
            settings.group_log_sd = values[0];
          }};
}

Term of_lot() {
  return {.id = "lot",
          .outside = true,
          .ln_weight = kLnLot,
          .parameters = {between("lot_log_sd", 0, 0.6, 0.2)},
          .apply = [](std::span<const double> values, LifeSettings& settings) {
            settings.lot_log_sd = values[0];
          }};
}

/// Some specimens live only a part of their life.
Term of_weak() {
  return {.id = "early_failures",
          .outside = true,
          .parameters = {between("weak_share", 0, 0.4, 0.08),
                         between("weak_life_left", 0.01, 0.7, 0.3)},
          .apply = [](std::span<const double> values, LifeSettings& settings) {
            settings.weak_share = values[0];
            settings.weak_life_left = values[1];
          }};
}

/// Lives scatter by another distribution than Weibull's.
Term of_distribution() {
  return {
      .id = "distribution",
      .outside = true,
      .apply = [](std::span<const double>, LifeSettings& settings) { settings.lognormal = true; }};
}

Term of_loads(std::size_t loads) {
  return {.id = "load",
          .outside = true,
          .parameters = std::vector<TermParameter>(loads, shift("load_shift", kShift_sd)),
          .apply = [](std::span<const double> values, LifeSettings& settings) {
            settings.load_shift.assign(values.begin(), values.end());
          }};
}

Term of_shapes(std::size_t levels) {
  return {.id = "shape",
          .outside = true,
          .ln_weight = kLnShape,
          .parameters = std::vector<TermParameter>(levels, shift("log_shape", kLogShape_sd)),
          .apply = [](std::span<const double> values, LifeSettings& settings) {
            settings.level_log_shape.assign(values.begin(), values.end());
          }};
}

Term of_days(const LifeSample& sample) {
  double longest = 0;
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    longest = std::max(longest, specimen.days);
  }
  return {.id = "days",
          .outside = true,
          .ln_weight = kLnDays,
          .parameters = {shift("shift_1_day", kShift_sd / longest)},
          .apply = [](std::span<const double> values, LifeSettings& settings) {
            settings.day_shift = values[0];
          }};
}

Term of_order() {
  return {.id = "block_order",
          .outside = true,
          .parameters = {shift("falling_shift", kShift_sd), shift("rising_shift", kShift_sd)},
          .apply = [](std::span<const double> values, LifeSettings& settings) {
            settings.falling_shift = values[0];
            settings.rising_shift = values[1];
          }};
}

bool any(const LifeSample& sample, bool (*is)(const LifeSample::Specimen&)) {
  return std::ranges::any_of(sample.specimens, is);
}

}  // namespace

std::vector<Term> outside_terms(const LifeSample& sample) {
  std::vector<Term> terms{of_weak()};
  if (sample.groups > 1) {
    terms.push_back(of_group());
  }
  if (sample.lots > 1) {
    terms.push_back(of_lot());
  }
  if (sample.levels > 1) {
    terms.push_back(of_loads(sample.loads));
    terms.push_back(of_shapes(sample.levels));
  } else {
    terms.push_back(of_distribution());
  }
  if (sample.has_days && any(sample, [](const auto& specimen) { return specimen.days > 0; })) {
    terms.push_back(of_days(sample));
  }
  if (any(sample, [](const auto& specimen) { return specimen.blocks.size() > 1; })) {
    terms.push_back(of_order());
  }
  return terms;
}

}  // namespace host_sim::diagnose::lives
