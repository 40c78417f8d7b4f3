#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "hal/files/csv.hpp"
#include "host_sim/fmeca/assessment.hpp"
#include "host_sim/io/json.hpp"

namespace host_sim::fmeca {
namespace {

using nlohmann::ordered_json;

ordered_json watches_json(const std::vector<std::string>& names) {
  return json_list(names, [](const std::string& name) {
    return ordered_json{{"name", name}, {"what", what_is(name).words}};
  });
}

ordered_json field_json(const std::optional<FieldCount>& field) {
  if (!field) {
    return nullptr;
  }
  return {{"events", field->events},
          {"operating_hours", field->operating_h},
          {"rate_per_h", static_cast<double>(field->events) / field->operating_h},
          {"limit_per_h", field->limit_per_h()}};
}

std::string_view level_name(const Assessment& assessment, const Assessed& one) {
  return assessment.table->levels[one.level].name;
}

ordered_json rating_json(const std::optional<int>& rating) {
  return rating ? ordered_json(*rating) : ordered_json(nullptr);
}

ordered_json mode_json(const Assessment& assessment, const Assessed& one) {
  const FailureMode& mode = *one.mode;
  return {{"rank", one.rank},
          {"id", mode.id},
          {"component", mode.component},
          {"mode", mode.mode},
          {"cause", mode.cause},
          {"mechanism", mode.mechanism},
          {"severity", mode.severity},
          {"occurrence", one.occurrence},
          {"detection", rating_json(mode.detection)},
          {"risk", one.risk},
          {"risk_priority_number", rating_json(one.rpn)},
          {"level", level_name(assessment, one)},
          {"field", field_json(one.field)},
          {"warned_by", watches_json(mode.warned_by)},
          {"seen_by", watches_json(mode.seen_by)}};
}

bool is_unwatched(const Assessed& one) {
  return one.mode->warned_by.empty() && one.mode->seen_by.empty();
}

std::ptrdiff_t unwatched(const Assessment& assessment) {
  return std::ranges::count_if(assessment.modes, is_unwatched);
}

}  // namespace

std::string fmeca_json(const Assessment& assessment) {
  ordered_json nothing = ordered_json::array();
  for (const Assessed& one : assessment.modes) {
    if (is_unwatched(one)) {
      nothing.push_back(one.mode->id);
    }
  }
  const ordered_json json{
      {"name", assessment.table->name},
      {"failures", json_list(assessment.modes,
                             [&](const Assessed& one) { return mode_json(assessment, one); })},
      {"watched_by_nothing", nothing}};
  return json.dump(2) + "\n";
}

std::string fmeca_table(const Assessment& assessment) {
  constexpr std::array<std::string_view, 15> kColumns{"rank",
                                                      "id",
                                                      "component",
                                                      "mode",
                                                      "cause",
                                                      "mechanism",
                                                      "severity",
                                                      "occurrence",
                                                      "detection",
                                                      "risk",
                                                      "risk_priority_number",
                                                      "level",
                                                      "field_per_h",
                                                      "warned_by",
                                                      "seen_by"};
  std::string table = hal::files::csv_head(kColumns);
  for (const Assessed& one : assessment.modes) {
    const FailureMode& mode = *one.mode;
    const auto text = [](const std::optional<int>& rating) {
      return rating ? std::to_string(*rating) : std::string();
    };
    hal::files::CsvRow row;
    row.add(one.rank);
    for (const std::string& cell :
         {mode.id, mode.component, mode.mode, mode.cause, mode.mechanism,
          std::to_string(mode.severity), std::to_string(one.occurrence), text(mode.detection),
          std::to_string(one.risk), text(one.rpn), std::string(level_name(assessment, one)),
          one.field ? fmt::format("{}", one.field->limit_per_h()) : std::string(),
          fmt::format("{}", fmt::join(mode.warned_by, " ")),
          fmt::format("{}", fmt::join(mode.seen_by, " "))}) {
      row.add(cell);
    }
    table += row.line();
  }
  return table;
}

std::string sentence_of(const Assessment& assessment) {
  const std::size_t worst = assessment.table->levels.size() - 1;
  const auto grave = std::ranges::count(assessment.modes, worst, &Assessed::level);
  const auto blind = unwatched(assessment);
  return fmt::format("{} failure modes, {} {}; {}", assessment.modes.size(), grave,
                     assessment.table->levels[worst].name,
                     blind == 0 ? std::string("each is watched")
                                : fmt::format("nothing watches {} of them", blind));
}

namespace {

void write_watches(std::ostream& out, std::string_view how, const std::vector<std::string>& names) {
  if (!names.empty()) {
    fmt::print(out, "{:>18} {}\n", how, fmt::join(names, ", "));
  }
}

void write_mode(std::ostream& out, const Assessment& assessment, const Assessed& one) {
  const FailureMode& mode = *one.mode;
  const std::string numbers =
      one.rpn ? fmt::format("{:>4} {:>4} {:>2} {:>2} {:>2}", *one.rpn, one.risk, mode.severity,
                            one.occurrence, *mode.detection)
              : fmt::format("{:>4} {:>2} {:>2}", one.risk, mode.severity, one.occurrence);
  fmt::print(out, "{:>4} {}{} {:<9} {}: {} ({})\n", one.rank, numbers, one.field ? "*" : " ",
             level_name(assessment, one), mode.component, mode.mode, mode.cause);
  write_watches(out, "warned by", mode.warned_by);
  write_watches(out, "seen by", mode.seen_by);
}

}  // namespace

void write_fmeca(std::ostream& out, const Assessment& assessment) {
  fmt::print(out, "{}: {}\n", assessment.table->name, sentence_of(assessment));
  fmt::print(out, "rank {} level     failure mode (cause)\n",
             assessment.has_rpn() ? " RPN risk  S  O  D " : "risk  S  O ");
  for (const Assessed& one : assessment.modes) {
    write_mode(out, assessment, one);
  }
  if (std::ranges::any_of(assessment.modes,
                          [](const Assessed& one) { return one.field.has_value(); })) {
    fmt::print(out, "* occurrence from the field: events per operating hour, 60 % upper limit\n");
  }
  if (unwatched(assessment) > 0) {
    fmt::print(out, "watched by nothing:");
    const char* before = " ";
    for (const Assessed& one : assessment.modes) {
      if (is_unwatched(one)) {
        fmt::print(out, "{}{}", before, one.mode->id);
        before = ", ";
      }
    }
    fmt::print(out, "\n");
  }
}

}  // namespace host_sim::fmeca
