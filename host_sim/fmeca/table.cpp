#include "host_sim/fmeca/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

#include "hal/files/input_file.hpp"
#include "hal/files/text.hpp"
#include "hal/files/toml_table.hpp"

/// The table of the paper, embedded when the program is built.
namespace host_sim::fmeca_assets {

// NOLINTNEXTLINE(readability-identifier-naming): named after the file
extern const std::string_view paper_toml;

}  // namespace host_sim::fmeca_assets

namespace host_sim::fmeca {

using hal::files::describe;
using hal::files::in_quotes;
using hal::files::NumberKey;
using hal::files::TomlTable;

namespace {

constexpr int kMostRating = 10;

/// A whole number from 1 to the largest.
int rating_of(const TomlTable& table, std::string_view key, int largest) {
  const double value = table.number({key, "", {1.0, static_cast<double>(largest)}});
  if (value != std::floor(value)) {
    table.fail(table.place_of(key), fmt::format("{} is {}", key, value),
               fmt::format("{} as a whole number from 1 to {}", key, largest));
  }
  return static_cast<int>(value);
}

int rating_or(const TomlTable& table, std::string_view key, int standard) {
  return table.has(key) ? rating_of(table, key, kMostRating) : standard;
}

Ratings ratings_of(const TomlTable& top) {
  constexpr std::array<std::string_view, 3> kKeys{"severity", "occurrence", "detection"};
  const TomlTable table = top.table("ratings");
  table.refuse_unknown_keys({}, kKeys);
  const Ratings standard;
  return {rating_of(table, "severity", kMostRating), rating_of(table, "occurrence", kMostRating),
          rating_or(table, "detection", standard.detection)};
}

std::vector<RiskLevel> levels_of(const TomlTable& top) {
  static constexpr std::array<std::string_view, 2> kKeys{"name", "from"};
  std::vector<RiskLevel> levels;
  for (const TomlTable& table : top.tables("level", "[[level]] with name and from")) {
    table.refuse_unknown_keys({}, kKeys);
    const RiskLevel level{table.text("name"), table.number({"from", "", {1.0, 1000.0}})};
    const bool is_first = levels.empty();
    if (is_first ? level.from != 1 : level.from <= levels.back().from) {
      table.fail(table.place_of("from"), fmt::format("from is {}", level.from),
                 is_first ? std::string("from = 1 of the first level")
                          : fmt::format("more than {} of the level before", levels.back().from));
    }
    levels.push_back(level);
  }
  if (levels.empty()) {
    top.fail(top.place_of("level"), "no level", "[[level]] with name and from");
  }
  return levels;
}

std::vector<OccurrenceRate> rates_of(const TomlTable& top, int largest) {
  static constexpr std::array<std::string_view, 3> kKeys{"rating", "name", "from_per_h"};
  constexpr std::string_view kAccepted = "[[occurrence_rate]] with rating, name and from_per_h";
  std::vector<OccurrenceRate> rates;
  if (!top.has("occurrence_rate")) {
    return rates;
  }
  for (const TomlTable& table : top.tables("occurrence_rate", kAccepted)) {
    table.refuse_unknown_keys({}, kKeys);
    const OccurrenceRate rate{rating_of(table, "rating", largest), table.text("name"),
                              table.number({"from_per_h", "per_h", {0.0, 1e6}})};
    if (rates.empty() && rate.from_per_h != 0) {
      table.fail(table.place_of("from_per_h"), fmt::format("from_per_h is {}", rate.from_per_h),
                 "from_per_h = 0 of the first rate");
    }
    if (!rates.empty() && rate.from_per_h <= rates.back().from_per_h) {
      table.fail(table.place_of("from_per_h"), fmt::format("from_per_h is {}", rate.from_per_h),
                 fmt::format("more than {} of the rate before", rates.back().from_per_h));
    }
    if (!rates.empty() && rate.rating <= rates.back().rating) {
      table.fail(table.place_of("rating"), fmt::format("rating is {}", rate.rating),
                 fmt::format("more than {} of the rate before", rates.back().rating));
    }
    rates.push_back(rate);
  }
  return rates;
}

/// Names of what watches; each means something.
std::vector<std::string> watches_of(const TomlTable& table, std::string_view key) {
  std::vector<std::string> names;
  if (!table.has(key)) {
    return names;
  }
  const std::string accepted = fmt::format("{} as an array of texts", key);
  const toml::node& node = table.node(key, accepted);
  const toml::array* const array = node.as_array();
  if (array == nullptr) {
    table.fail(table.place_of(key), fmt::format("{} is {}", key, describe(node)), accepted);
  }
  for (const toml::node& element : *array) {
    const auto* const text = element.as_string();
    if (text == nullptr) {
      table.fail(element.source().begin, fmt::format("{} holds {}", key, describe(element)),
                 accepted);
    }
    const Watch watch = what_is(text->get());
    if (watch.words.empty()) {
      table.fail(element.source().begin,
                 fmt::format("{} holds {}, which nothing is called", key, in_quotes(text->get())),
                 watch.accepted);
    }
    names.push_back(text->get());
  }
  return names;
}

bool is_id(std::string_view text) {
  return std::ranges::all_of(
      text, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

FailureMode mode_of(const TomlTable& table, const Ratings& largest) {
  static constexpr std::array<std::string_view, 10> kKeys{
      "id",       "component",  "mode",      "cause",     "mechanism",
      "severity", "occurrence", "detection", "warned_by", "seen_by"};
  table.refuse_unknown_keys({}, kKeys);
  FailureMode mode;
  mode.id = table.text("id");
  if (!is_id(mode.id)) {
    table.fail(table.place_of("id"), fmt::format("id is {}", in_quotes(mode.id)),
               "small letters, digits and _");
  }
  mode.component = table.text("component");
  mode.mode = table.text("mode");
  mode.cause = table.text("cause");
  mode.mechanism = table.has("mechanism") ? table.text("mechanism") : "";
  mode.severity = rating_of(table, "severity", largest.severity);
  mode.occurrence = rating_of(table, "occurrence", largest.occurrence);
  if (table.has("detection")) {
    mode.detection = rating_of(table, "detection", largest.detection);
  }
  mode.warned_by = watches_of(table, "warned_by");
  mode.seen_by = watches_of(table, "seen_by");
  return mode;
}

std::vector<FailureMode> modes_of(const TomlTable& top, const Ratings& largest) {
  constexpr std::string_view kAccepted = "[[failure]] with id, component, mode, cause, ratings";
  std::vector<FailureMode> modes;
  std::set<std::string> ids;
  for (const TomlTable& table : top.tables("failure", kAccepted)) {
    modes.push_back(mode_of(table, largest));
    if (!ids.insert(modes.back().id).second) {
      table.fail(table.place_of("id"), fmt::format("id {} a second time", modes.back().id),
                 "each id once");
    }
    if (modes.back().detection.has_value() != modes.front().detection.has_value()) {
      table.fail(table.place_of("detection"),
                 modes.back().detection ? "a detection, which those before have not"
                                        : "no detection, which those before have",
                 "detection of each failure, or of none");
    }
  }
  if (modes.empty()) {
    top.fail(top.place_of("failure"), "no failure", kAccepted);
  }
  return modes;
}

}  // namespace

RiskTable parse_table(std::string_view text, std::string_view file) {
  constexpr std::array<std::string_view, 6> kTables{"schema", "fmeca",           "ratings",
                                                    "level",  "occurrence_rate", "failure"};
  static constexpr std::array<std::string_view, 1> kNameKeys{"name"};
  const toml::table values = hal::files::parse_toml(text, file);
  const TomlTable top(file, values, "", {});
  top.refuse_unknown_keys({}, kTables);
  static_cast<void>(top.number({"schema", "", {1.0, 1.0}}));
  const TomlTable fmeca = top.table("fmeca");
  fmeca.refuse_unknown_keys({}, kNameKeys);
  RiskTable table;
  table.file = file;
  table.name = fmeca.text("name");
  table.largest = ratings_of(top);
  table.levels = levels_of(top);
  table.occurrence_rates = rates_of(top, table.largest.occurrence);
  table.modes = modes_of(top, table.largest);
  return table;
}

RiskTable read_table(const std::filesystem::path& path) {
  return parse_table(
      hal::files::read_text_file(path, "a table of failure modes (TOML) of at most 1 MiB"),
      hal::files::file_name(path));
}

RiskTable paper_table() {
  return parse_table(fmeca_assets::paper_toml, "the table of the paper");
}

}  // namespace host_sim::fmeca
