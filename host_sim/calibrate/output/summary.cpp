#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "hal/files/text.hpp"
#include "host_sim/calibrate/output/output.hpp"

namespace host_sim::calibrate {

using hal::files::character_count;
using hal::files::printable;

namespace {

/// Rows of cells in aligned columns for a terminal: the first column to the left, the others to the
/// right.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> head) : rows_{std::move(head)} {}

  /// @pre as many cells as the head has
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

  void write(std::ostream& out) const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;

  std::vector<std::vector<std::string>> rows_;
};

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> widths(rows_.front().size());
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], character_count(row[i]));
    }
  }
  return widths;
}

void TextTable::write(std::ostream& out) const {
  const std::vector<std::size_t> width = widths();
  for (const auto& row : rows_) {
    std::string line = "  ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(width[i] - character_count(row[i]), ' ');
      line += i == 0 ? row[i] + padding : "  " + padding + row[i];
    }
    line.resize(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
}

constexpr double kWholeBelow = 1e6;
constexpr double kTenthsBelow = 100;

std::string special(double value) {
  return std::isnan(value) ? "-" : "no limit";
}

}  // namespace

std::string figure(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : special(value);
}

std::string figure(const statistics::Interval& interval) {
  return fmt::format("{} .. {}", figure(interval.low), figure(interval.high));
}

std::string cycles_text(double cycles) {
  if (!std::isfinite(cycles)) {
    return special(cycles);
  }
  if (cycles < kTenthsBelow || cycles >= kWholeBelow) {
    return fmt::format("{:.4g}", cycles);
  }
  return fmt::format("{:.0f}", cycles);
}

std::string cycles_text(const statistics::Interval& interval_cycles) {
  return fmt::format("{} .. {}", cycles_text(interval_cycles.low),
                     cycles_text(interval_cycles.high));
}

std::string p_text(double p) {
  if (!std::isfinite(p)) {
    return "-";
  }
  return p >= 0.001 || p == 0 ? fmt::format("{:.3f}", p) : fmt::format("{:.0e}", p);
}

std::string_view family_name(statistics::Family family) {
  switch (family) {
    case statistics::Family::normal:
      return "normal";
    case statistics::Family::lognormal:
      return "lognormal";
    case statistics::Family::weibull:
      return "weibull";
  }
  return "";
}

std::optional<statistics::Family> best_family(const LevelResult& level) {
  const statistics::Fit* best = nullptr;
  for (const statistics::Fit& fit : level.fits) {
    if (fit.problem == statistics::FitProblem::none &&
        (best == nullptr || fit.log_likelihood > best->log_likelihood)) {
      best = &fit;
    }
  }
  if (best == nullptr) {
    return std::nullopt;
  }
  return best->distribution.family;
}

std::string validation_name(const CalibrateResult& result, const ValidationResult& validation) {
  return validation.in_blocks ? "in blocks" : result.levels.at(validation.level).name();
}

namespace {

using statistics::Family;
using statistics::FitProblem;

std::string mark_of(const LevelResult& level) {
  if (level.role == Campaign::Role::validation) {
    return level.name() + " (validation)";
  }
  return level.left_out.empty() ? level.name() : level.name() + " (left out)";
}

std::vector<std::string> level_row(const LevelResult& level) {
  std::vector<std::string> row{mark_of(level), std::to_string(level.sample.size()),
                               std::to_string(level.failed()),
                               std::to_string(level.sample.size() - level.failed())};
  const statistics::Fit& fit = level.weibull();
  if (fit.problem != FitProblem::none) {
    row.insert(row.end(), 6, "-");
  } else {
    const auto& goodness = level.goodness[static_cast<std::size_t>(Family::weibull)];
    for (const std::string& cell :
         {cycles_text(fit.distribution.first), figure(fit.distribution.second),
          figure(level.shape_unbiased), cycles_text(level.mean_life),
          goodness ? p_text(goodness->ks_p) : "-", goodness ? p_text(goodness->ad_p) : "-"}) {
      row.push_back(cell);
    }
  }
  const auto best = best_family(level);
  row.emplace_back(best ? family_name(*best) : problem_name(fit.problem));
  return row;
}

void write_levels(std::ostream& out, const CalibrateResult& result) {
  TextTable table({"level", "n", "failed", "suspended", "scale", "shape", "unbiased", "mean life",
                   "K-S p", "A-D p", "likeliest"});
  for (const LevelResult& level : result.levels) {
    table.add(level_row(level));
  }
  table.write(out);
  for (const LevelResult& level : result.levels) {
    if (level.trimmed() > 0 || level.found_broken() > 0) {
      fmt::print(out, "  {}: of the failed {} found broken at inspections, {} trimmed\n",
                 level.name(), level.found_broken(), level.trimmed());
    }
    if (!level.left_out.empty()) {
      fmt::print(out, "  left out: {}: {}\n", level.name(), printable(level.left_out));
    }
  }
}

std::string test_text(const Test& test) {
  return fmt::format("{}: statistic {}, {} df, p {} simulated, {} chi-square",
                     rejected(test) ? "rejected" : "not rejected", figure(test.statistic),
                     figure(test.degrees_of_freedom), p_text(test.p_simulated),
                     p_text(test.p_chi_square));
}

void write_common_shape(std::ostream& out, const CalibrateResult& result) {
  const CommonShape& shape = *result.common_shape;
  fmt::print(out, "common shape      {}  (95 %: {}; without its bias {})\n", figure(shape.value),
             figure(shape.ci95), figure(shape.unbiased));
  fmt::print(out, "  one shape       {}\n", test_text(shape.homogeneity));
  if (shape.with_all_levels) {
    fmt::print(out, "  with all levels {}\n", test_text(*shape.with_all_levels));
  }
  for (const OddLevel& odd : shape.odd_levels) {
    if (odd.p_corrected < kSignificance) {
      fmt::print(out, "  odd one         {}: p {} for its own shape, looked for in {} levels\n",
                 result.levels.at(odd.level).name(), p_text(odd.p_corrected),
                 shape.odd_levels.size());
    }
  }
}

void write_stress_life(std::ostream& out, const StressLife& life) {
  fmt::print(out, "life law          A {}  (95 %: {})\n", figure(life.law.scale),
             figure(life.scale_ci95));
  fmt::print(out, "                  gamma {}  (95 %: {})\n", figure(life.law.exponent),
             figure(life.exponent_ci95));
  fmt::print(out, "                  beta {}  (95 %: {}; without its bias {})\n",
             figure(life.law.shape), figure(life.shape_ci95), figure(life.shape_unbiased));
  fmt::print(out, "                  maximum likelihood, log-likelihood {:.6g}\n",
             life.log_likelihood);
  if (life.least_squares) {
    fmt::print(out, "  least squares   A {}, gamma {}, beta {}, RMSE {} cycles; the paper's way\n",
               figure(life.least_squares->scale), figure(life.least_squares->exponent),
               figure(life.least_squares->shape), figure(life.least_squares_rmse));
  }
  if (life.against_free_levels) {
    fmt::print(out, "  power law       {}\n", test_text(*life.against_free_levels));
  }
  if (life.against_curvature) {
    fmt::print(out, "  no curvature    {}\n", test_text(*life.against_curvature));
  }
  if (life.against_growing_scatter) {
    fmt::print(out, "  equal scatter   {}\n", test_text(*life.against_growing_scatter));
  }
}

void write_use_levels(std::ostream& out, const CalibrateResult& result) {
  fmt::print(out, "use levels, lives in cycles\n");
  TextTable table({"load", "T_eff", "mean", "95 %", "B10", "95 %", "one more specimen, 95 %"});
  for (const UseLevel& use : result.use_levels) {
    table.add({printable(use.name), fmt::format("{:.2f} N", use.effective_tension_N),
               cycles_text(use.mean), cycles_text(use.mean_ci95), cycles_text(use.b10),
               cycles_text(use.b10_ci95), cycles_text(use.next_specimen_95)});
  }
  table.write(out);
}

void write_validation(std::ostream& out, const CalibrateResult& result) {
  fmt::print(out, "validation\n");
  for (const ValidationResult& validation : result.validation) {
    fmt::print(out, "  {}: mean {} predicted, {} measured; {} below B10, {} within, {} above B90\n",
               validation_name(result, validation), cycles_text(validation.predicted_mean),
               cycles_text(validation.measured_mean), validation.below_b10,
               validation.inside_b10_b90, validation.above_b90);
    fmt::print(out, "    {}\n", printable(validation.words));
  }
}

void write_mixes(std::ostream& out, const CalibrateResult& result) {
  fmt::print(out, "mixes of loads, the constant effective tension that does the same\n");
  TextTable table({"mix", "by damage", "by the paper's average of lives"});
  for (const MixResult& mix : result.mixes) {
    table.add({printable(mix.name), fmt::format("{:.2f} N", mix.by_damage_N),
               fmt::format("{:.2f} N", mix.by_average_of_lives_N)});
  }
  table.write(out);
}

}  // namespace

void write_summary(std::ostream& out, const CalibrateResult& result) {
  fmt::print(out, "{}: {} specimens, {} failed, {} suspended", printable(result.campaign),
             result.specimens, result.failed, result.suspended);
  if (result.in_blocks > 0) {
    fmt::print(out, ", {} loaded in blocks", result.in_blocks);
  }
  out << '\n';
  if (!result.levels.empty()) {
    write_levels(out, result);
  }
  if (result.common_shape) {
    write_common_shape(out, result);
  }
  if (result.stress_life) {
    write_stress_life(out, *result.stress_life);
  }
  if (!result.use_levels.empty()) {
    write_use_levels(out, result);
  }
  if (!result.validation.empty()) {
    write_validation(out, result);
  }
  if (!result.mixes.empty()) {
    write_mixes(out, result);
  }
  fmt::print(out, "p-values and bands from {} bootstraps, seed {}\n", result.bootstraps,
             result.seed);
  for (const std::string& warning : result.warnings) {
    fmt::print(out, "warning: {}\n", printable(warning));
  }
}

}  // namespace host_sim::calibrate
