#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "hal/files/csv.hpp"
#include "host_sim/calibrate/output/output.hpp"

namespace host_sim::calibrate {

using hal::files::csv_head;
using hal::files::CsvRow;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr Interval kNoInterval{kNone, kNone};

constexpr std::array<std::string_view, 23> kColumns{"campaign",
                                                    "specimens",
                                                    "failed",
                                                    "suspended",
                                                    "common_shape",
                                                    "common_shape_low",
                                                    "common_shape_high",
                                                    "homogeneity_p",
                                                    "ipl_scale",
                                                    "ipl_scale_low",
                                                    "ipl_scale_high",
                                                    "ipl_exponent",
                                                    "ipl_exponent_low",
                                                    "ipl_exponent_high",
                                                    "weibull_shape",
                                                    "weibull_shape_low",
                                                    "weibull_shape_high",
                                                    "log_likelihood",
                                                    "least_validation_p",
                                                    "levels_left_out",
                                                    "findings",
                                                    "warnings",
                                                    "error"};

void add(CsvRow& row, double value, const Interval& interval) {
  row.add(value);
  row.add(interval.low);
  row.add(interval.high);
}

void add_common_shape(CsvRow& row, const CalibrateResult& result) {
  if (result.common_shape) {
    add(row, result.common_shape->value, result.common_shape->ci95);
    row.add(p_of(result.common_shape->homogeneity));
  } else {
    add(row, kNone, kNoInterval);
    row.add(kNone);
  }
}

void add_law(CsvRow& row, const CalibrateResult& result) {
  if (result.stress_life) {
    const StressLife& life = *result.stress_life;
    add(row, life.law.scale, life.scale_ci95);
    add(row, life.law.exponent, life.exponent_ci95);
    add(row, life.law.shape, life.shape_ci95);
    row.add(life.log_likelihood);
  } else {
    add(row, kNone, kNoInterval);
    add(row, kNone, kNoInterval);
    add(row, kNone, kNoInterval);
    row.add(kNone);
  }
}

double least_validation_p(const CalibrateResult& result) {
  double least = kNone;
  for (const ValidationResult& validation : result.validation) {
    least = std::fmin(least, validation.p);
  }
  return least;
}

std::size_t levels_left_out(const CalibrateResult& result) {
  std::size_t count = 0;
  for (const LevelResult& level : result.levels) {
    count += level.left_out.empty() ? 0U : 1U;
  }
  return count;
}

}  // namespace

std::string table_head() {
  return csv_head(kColumns);
}

std::string table_row(std::string_view name, const CalibrateResult& result) {
  CsvRow row;
  row.add(name);
  row.add(result.specimens);
  row.add(result.failed);
  row.add(result.suspended);
  add_common_shape(row, result);
  add_law(row, result);
  row.add(least_validation_p(result));
  row.add(levels_left_out(result));
  row.add(fmt::format("{}", fmt::join(found_in(result), " ")));
  row.add(result.warnings.size());
  row.add(std::string_view());
  return row.line();
}

std::string refused_row(std::string_view name, std::string_view error) {
  CsvRow row;
  row.add(name);
  row.fill_to(kColumns.size() - 1);
  row.add(error);
  return row.line();
}

}  // namespace host_sim::calibrate
