#include "host_sim/report/calibrate/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "host_sim/report/calibrate/notation.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page::tables {
namespace {

using calibrate::CalibrateResult;
using calibrate::LevelResult;

constexpr std::array kFamilies = {"normal", "lognormal", "Weibull"};

std::string none_or(bool there, double value) {
  return there ? number_text(value, kDigits) : "none";
}

std::string scale_interval_text(const LevelResult& level) {
  const std::optional<statistics::Interval> interval = scale_interval(level.band);
  return interval ? interval_text(*interval) : "none";
}

/// What is known of the lives of specimens that failed or did not, in rising order.
std::string lives_text(const LevelResult& level, bool failed) {
  statistics::Sample lives;
  std::size_t trimmed = 0;
  for (const statistics::Observation& specimen : level.sample) {
    trimmed += failed && specimen.trimmed ? 1 : 0;
    if (!specimen.trimmed && specimen.failed == failed) {
      lives.push_back(specimen);
    }
  }
  std::ranges::sort(lives, statistics::rises_failures_first);
  std::string text;
  for (const statistics::Observation& life : lives) {
    text += text.empty() ? "" : ", ";
    text += life.from ? number_text(*life.from, kDigits) + " .. " : "";
    text += number_text(life.value, kDigits);
  }
  if (trimmed > 0) {
    text += fmt::format("; {} trimmed", trimmed);
  }
  return text.empty() ? "none" : text;
}

}  // namespace

std::string levels(const CalibrateResult& result) {
  Table table("Weibull fits of the levels",
              {"Level", "Failed", "Suspended", "Scale, cycles", "95 % interval", "Shape",
               "Shape without bias", "Mean life, cycles"});
  for (const LevelResult& level : result.levels) {
    const bool fitted = has_fit(level);
    const statistics::Distribution& weibull = level.weibull().distribution;
    table.row(title_of(level),
              {count_text(level.failed()), count_text(level.sample.size() - level.failed()),
               fitted ? number_text(weibull.first, kDigits)
                      : std::string(calibrate::problem_name(level.weibull().problem)),
               scale_interval_text(level), none_or(fitted, weibull.second),
               none_or(fitted, level.shape_unbiased), none_or(fitted, level.mean_life)});
  }
  return table.html();
}

std::string goodness_of_fit(const CalibrateResult& result) {
  Table table("Goodness of fit of the levels",
              {"Level and family", "K-S", "K-S p", "A-D", "A-D p", "Log-likelihood"});
  for (const LevelResult& level : result.levels) {
    for (std::size_t i = 0; i < level.fits.size(); ++i) {
      const std::string name = fmt::format("{}, {}", title_of(level), kFamilies.at(i));
      const statistics::Fit& fit = level.fits.at(i);
      if (fit.problem != statistics::FitProblem::none) {
        table.row(name, {std::string(calibrate::problem_name(fit.problem)), "", "", "", ""});
      } else if (const auto* const goodness =
                     level.goodness.at(i) ? &*level.goodness.at(i) : nullptr) {
        table.row(name,
                  {number_text(goodness->ks), p_text(goodness->ks_p), number_text(goodness->ad),
                   p_text(goodness->ad_p), number_text(fit.log_likelihood, kDigits + 1)});
      } else {
        table.row(name, {"not computed", "", "", "", number_text(fit.log_likelihood, kDigits + 1)});
      }
    }
  }
  return table.html();
}

std::string specimens(const CalibrateResult& result) {
  Table table("Lives of the specimens, cycles", {"Level", "Failed at", "Suspended at"},
              Table::Cells::texts);
  for (const LevelResult& level : result.levels) {
    table.row(title_of(level), {lives_text(level, true), lives_text(level, false)});
  }
  return table.html();
}

std::string positions(const LevelResult& level) {
  Table table("Failures of " + title_of(level),
              {"Life, cycles", "Broken by plotting position", "Broken by the fit"});
  for (const statistics::PlottingPosition& position : level.positions) {
    table.row(number_text(position.life, kDigits),
              {percent_text(position.p),
               has_fit(level) ? percent_text(level.weibull().distribution.cdf(position.life))
                              : "no fit"});
  }
  return table.html();
}

std::string band(const LevelResult& level) {
  constexpr std::size_t kRows = 9;
  Table table("Quantiles of " + title_of(level),
              {"Broken", "Life by the fit, cycles", "95 % band"});
  const std::size_t size = level.band.p.size();
  const std::size_t rows = std::min(kRows, size);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t i = rows == 1 ? 0 : row * (size - 1) / (rows - 1);
    const double p = level.band.p[i];
    table.row(percent_text(p), {number_text(level.weibull().distribution.quantile(p), kDigits),
                                interval_text({level.band.low[i], level.band.high[i]})});
  }
  return table.html();
}

std::string common_shape(const CalibrateResult& result) {
  Table table("Common shape", {"Common shape", "95 % interval", "Without bias"});
  if (result.common_shape) {
    const calibrate::CommonShape& shape = *result.common_shape;
    table.row(number_text(shape.value, kDigits),
              {interval_text(shape.ci95), number_text(shape.unbiased, kDigits)});
  }
  return table.html();
}

std::string shape_tests(const CalibrateResult& result) {
  Table table("Tests of one shape", {"Levels", "Likelihood ratio", "Degrees of freedom",
                                     "p by chi-square", "p by simulation"});
  const auto row = [&table](std::string_view levels, const statistics::Test& test) {
    table.row(levels, {number_text(test.statistic, kDigits), number_text(test.degrees_of_freedom),
                       p_text(test.p_chi_square), p_text(test.p_simulated)});
  };
  if (result.common_shape) {
    row("of the life law", result.common_shape->homogeneity);
    if (result.common_shape->with_all_levels) {
      row("with those left out", *result.common_shape->with_all_levels);
    }
  }
  return table.html();
}

std::string odd_levels(const CalibrateResult& result) {
  Table table("Each level's shape against that of the others",
              {"Level", "Likelihood ratio", "p by chi-square", "p by simulation",
               "p for having looked at all"});
  if (result.common_shape) {
    for (const calibrate::OddLevel& odd : result.common_shape->odd_levels) {
      table.row(title_of(result.levels.at(odd.level)),
                {number_text(odd.test.statistic, kDigits), p_text(odd.test.p_chi_square),
                 p_text(odd.test.p_simulated), p_text(odd.p_corrected)});
    }
  }
  return table.html();
}

namespace {

constexpr int kLawDigits = 5;

std::string parts_text(const calibrate::MixResult& mix) {
  std::string text;
  for (const calibrate::MixResult::Part& part : mix.parts) {
    text += fmt::format("{}{} of cycles at {}", text.empty() ? "" : ", ", percent_text(part.share),
                        quantity_text(part.effective_tension_N, "N"));
  }
  return text;
}

}  // namespace

std::string law(const CalibrateResult& result) {
  Table table("Parameters of the life law",
              {"Parameter", "Maximum likelihood", "95 % interval", "Least squares"});
  if (!result.stress_life) {
    table.row("Life law", {"none", "none", "none"});
    return table.html();
  }
  const calibrate::StressLife& law = *result.stress_life;
  const life_law::LifeLaw* const other = law.least_squares ? &*law.least_squares : nullptr;
  const auto row = [&](std::string_view name, double life_law::LifeLaw::*value,
                       statistics::Interval interval) {
    table.row(name, {number_text(law.law.*value, kLawDigits), interval_text(interval),
                     other != nullptr ? number_text(other->*value, kLawDigits) : "none"});
  };
  row("Scale A, cycles N^gamma", &life_law::LifeLaw::scale, law.scale_ci95);
  row("Exponent gamma", &life_law::LifeLaw::exponent, law.exponent_ci95);
  row("Weibull shape beta", &life_law::LifeLaw::shape, law.shape_ci95);
  table.row("Shape without bias", {number_text(law.shape_unbiased, kLawDigits), "", ""});
  table.row("Log-likelihood", {number_text(law.log_likelihood, kLawDigits + 1), "", ""});
  table.row("Root mean square error, cycles",
            {"", "", other != nullptr ? number_text(law.least_squares_rmse, kDigits) : "none"});
  return table.html();
}

std::string law_lines(const CalibrateResult& result) {
  constexpr std::size_t kRows = 9;
  Table table("The life law over tension",
              {"Effective tension, N", "B10, cycles", "Mean life, cycles", "95 % band of the mean",
               "B90, cycles", "Mean by least squares"});
  if (result.stress_life) {
    const calibrate::StressLife& law = *result.stress_life;
    const std::size_t size = std::min(law.band_tension_N.size(), law.band_mean.size());
    const std::size_t rows = std::min(kRows, size);
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t i = rows == 1 ? 0 : row * (size - 1) / (rows - 1);
      const double tension_N = law.band_tension_N[i];
      table.row(
          number_text(tension_N, kDigits),
          {number_text(law.law.quantile(0.1, tension_N), kDigits),
           number_text(law.law.mean_life(tension_N), kDigits), interval_text(law.band_mean[i]),
           number_text(law.law.quantile(0.9, tension_N), kDigits),
           law.least_squares ? number_text(law.least_squares->mean_life(tension_N), kDigits)
                             : "none"});
    }
  }
  return table.html();
}

std::string use_levels(const CalibrateResult& result) {
  Table table("Lives at the use levels, cycles",
              {"Use level", "Effective tension, N", "Mean", "95 % interval", "B10",
               "95 % interval of B10", "B50", "B90", "One more specimen, 95 %"});
  for (const calibrate::UseLevel& use : result.use_levels) {
    table.row(use.name,
              {number_text(use.effective_tension_N, kDigits), number_text(use.mean, kDigits),
               interval_text(use.mean_ci95), number_text(use.b10, kDigits),
               interval_text(use.b10_ci95), number_text(use.b50, kDigits),
               number_text(use.b90, kDigits), interval_text(use.next_specimen_95)});
  }
  return table.html();
}

std::string validation(const CalibrateResult& result) {
  Table table("Predicted and measured lives at the validation levels",
              {"Level", "Predicted mean", "Measured mean", "True over predicted mean, 95 %", "p",
               "Failed before B10", "B10 to B90", "After B90"});
  for (const calibrate::ValidationResult& validation : result.validation) {
    const std::string name =
        validation.in_blocks ? "in blocks, in damage" : result.levels.at(validation.level).name();
    table.row(name, {number_text(validation.predicted_mean, kDigits),
                     number_text(validation.measured_mean, kDigits),
                     interval_text(validation.ratio_ci95, 3), p_text(validation.p),
                     count_text(validation.below_b10), count_text(validation.inside_b10_b90),
                     count_text(validation.above_b90)});
  }
  return table.html();
}

std::string mixes(const CalibrateResult& result) {
  Table table("Constant load that equals a mix",
              {"Mix", "Parts", "By damage", "By the average of lives"}, Table::Cells::texts);
  for (const calibrate::MixResult& mix : result.mixes) {
    table.row(mix.name, {parts_text(mix), quantity_text(mix.by_damage_N, "N", kDigits),
                         quantity_text(mix.by_average_of_lives_N, "N", kDigits)});
  }
  return table.html();
}

}  // namespace host_sim::calibrate_page::tables
