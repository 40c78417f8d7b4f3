#include "host_sim/calibrate/output/table_row.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "host_sim/calibrate/output/findings.hpp"
#include "host_sim/io/printable.hpp"

namespace host_sim::calibrate {
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

/// A field in quotes where RFC 4180 wants them.
std::string field(std::string_view text) {
  std::string safe = printable(text);
  if (safe.find_first_of(",\"") == std::string::npos) {
    return safe;
  }
  for (std::size_t at = safe.find('"'); at != std::string::npos; at = safe.find('"', at + 2)) {
    safe.insert(at, 1, '"');
  }
  return '"' + safe + '"';
}

class Row {
 public:
  explicit Row(std::string_view name) { cells_.push_back(field(name)); }

  void add(std::string_view text) { cells_.push_back(field(text)); }
  void add(std::size_t count) { cells_.push_back(std::to_string(count)); }
  void add(double value) { cells_.push_back(std::isnan(value) ? "" : fmt::format("{}", value)); }
  void add(double value, const Interval& interval) {
    add(value);
    add(interval.low);
    add(interval.high);
  }
  void skip_to_last() { cells_.resize(kColumns.size() - 1); }

  [[nodiscard]] std::string line() const { return fmt::format("{}\n", fmt::join(cells_, ",")); }

 private:
  std::vector<std::string> cells_;
};

void add_common_shape(Row& row, const CalibrateResult& result) {
  if (result.common_shape) {
    row.add(result.common_shape->value, result.common_shape->ci95);
    row.add(p_of(result.common_shape->homogeneity));
  } else {
    row.add(kNone, kNoInterval);
    row.add(kNone);
  }
}

void add_law(Row& row, const CalibrateResult& result) {
  if (result.stress_life) {
    const StressLife& life = *result.stress_life;
    row.add(life.law.scale, life.scale_ci95);
    row.add(life.law.exponent, life.exponent_ci95);
    row.add(life.law.shape, life.shape_ci95);
    row.add(life.log_likelihood);
  } else {
    row.add(kNone, kNoInterval);
    row.add(kNone, kNoInterval);
    row.add(kNone, kNoInterval);
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
  return fmt::format("{}\n", fmt::join(kColumns, ","));
}

std::string table_row(std::string_view name, const CalibrateResult& result) {
  Row row(name);
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
  Row row(name);
  row.skip_to_last();
  row.add(error);
  return row.line();
}

}  // namespace host_sim::calibrate
