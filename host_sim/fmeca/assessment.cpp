#include "host_sim/fmeca/assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/io/compressed.hpp"

namespace host_sim::fmeca {

using hal::files::in_quotes;

double FieldCount::limit_per_h() const {
  constexpr double kConfidence = 0.6;
  // Half the quantile of chi-square with 2 n + 2 degrees of freedom.
  return boost::math::gamma_p_inv(static_cast<double>(events) + 1, kConfidence) / operating_h;
}

namespace {

enum FieldColumn : unsigned { kFailure, kEvents, kHours, kFieldColumnCount };

std::uint64_t events_in(const CsvTable& rows) {
  const double events = rows.number(kEvents, {0.0, 1e9});
  if (events != std::floor(events)) {
    rows.place(kEvents).fail(fmt::format("events is {}", in_quotes(rows.cell(kEvents))),
                             "a whole number from 0");
  }
  return static_cast<std::uint64_t>(events);
}

std::string ids_of(const RiskTable& table) {
  std::vector<std::string_view> ids;
  ids.reserve(table.modes.size());
  for (const FailureMode& mode : table.modes) {
    ids.push_back(mode.id);
  }
  return fmt::format("{}", fmt::join(ids, ", "));
}

}  // namespace

FieldCounts parse_field(std::unique_ptr<hal::files::ByteSource> source, std::string_view name,
                        const RiskTable& table) {
  static constexpr std::array<CsvColumn, kFieldColumnCount> kColumns{
      {{.name = "failure", .required = true},
       {.name = "events", .required = true},
       {.name = "operating_hours", .unit = "hours", .required = true}}};
  if (table.occurrence_rates.empty()) {
    throw hal::files::InputError(table.file, 0, 0, "no rates to rate field records by",
                                 "[[occurrence_rate]] with rating, name and from_per_h");
  }
  CsvTable rows(std::move(source), name, kColumns);
  FieldCounts counts;
  while (rows.next()) {
    const std::string failure = name_in_row(rows, kFailure);
    if (std::ranges::find(table.modes, failure, &FailureMode::id) == table.modes.end()) {
      rows.place(kFailure).fail(fmt::format("failure {} is not in the table", in_quotes(failure)),
                                ids_of(table));
    }
    FieldCount& count = counts[failure];
    count.events += events_in(rows);
    count.operating_h += rows.number(kHours, {0.0, 1e12, true});
  }
  return counts;
}

FieldCounts read_field(const std::filesystem::path& path, const RiskTable& table) {
  return parse_field(open_input(path, "field records (CSV) with failure, events, operating_hours"),
                     hal::files::file_name(path), table);
}

namespace {

int rating_of(const RiskTable& table, double rate_per_h) {
  int rating = table.occurrence_rates.front().rating;
  for (const OccurrenceRate& rate : table.occurrence_rates) {
    rating = rate_per_h >= rate.from_per_h ? rate.rating : rating;
  }
  return rating;
}

std::size_t level_of(const RiskTable& table, int risk) {
  std::size_t level = 0;
  for (std::size_t i = 0; i < table.levels.size(); ++i) {
    level = risk >= table.levels[i].from ? i : level;
  }
  return level;
}

int number_of(const Assessed& assessed) {
  return assessed.rpn.value_or(assessed.risk);
}

}  // namespace

Assessment assess(const RiskTable& table, const FieldCounts& field) {
  Assessment assessment{&table, {}};
  for (const FailureMode& mode : table.modes) {
    Assessed assessed;
    assessed.mode = &mode;
    assessed.occurrence = mode.occurrence;
    if (const auto count = field.find(mode.id); count != field.end()) {
      assessed.field = count->second;
      assessed.occurrence = rating_of(table, count->second.limit_per_h());
    }
    assessed.risk = mode.severity * assessed.occurrence;
    if (mode.detection) {
      assessed.rpn = assessed.risk * *mode.detection;
    }
    assessed.level = level_of(table, assessed.risk);
    assessment.modes.push_back(assessed);
  }
  std::stable_sort(assessment.modes.begin(), assessment.modes.end(),
                   [](const Assessed& a, const Assessed& b) {
                     return std::pair(number_of(a), a.mode->severity) >
                            std::pair(number_of(b), b.mode->severity);
                   });
  for (std::size_t i = 0; i < assessment.modes.size(); ++i) {
    Assessed& assessed = assessment.modes[i];
    const bool is_equal = i > 0 && number_of(assessment.modes[i - 1]) == number_of(assessed);
    assessed.rank = is_equal ? assessment.modes[i - 1].rank : i + 1;
  }
  return assessment;
}

}  // namespace host_sim::fmeca
