#include "host_sim/report/calibrate/law_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_sim/report/calibrate/texts.hpp"
#include "host_sim/report/page/number_text.hpp"
#include "host_sim/report/page/table.hpp"

namespace host_sim::calibrate_page::tables {
namespace {

using calibrate::CalibrateResult;

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
