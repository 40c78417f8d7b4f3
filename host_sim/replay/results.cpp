#include "host_sim/replay/results.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "hal/files/csv.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/io/json.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/report/replay/captions.hpp"
#include "host_sim/report/replay/flags.hpp"

namespace host_sim {

using hal::files::csv_head;
using hal::files::CsvRow;
using hal::files::InputKind;

namespace {

using nlohmann::ordered_json;

// As the Emergency codes are called.
constexpr std::string_view kTendonBroken = "tendon_broken";
constexpr std::string_view kTendonSlack = "tendon_slack";

ordered_json damage_json(const DamageSplit& damage) {
  return {{"closed", damage.closed}, {"open", damage.open}, {"total", damage.total}};
}

ordered_json watched_json(const Watched& watched) {
  ordered_json events = ordered_json::array();
  for (const FoundInWire& found : watched.found) {
    events.push_back(
        {{"event", to_string(found.event)}, {"time_s", found.time_s}, {"line", found.line}});
  }
  return {{"limits",
           {{"minimum_tension_N", watched.limits.minimum_tension_N},
            {"broken_tension_N", watched.limits.broken_tension_N},
            {"broken_travel_mm", watched.limits.broken_travel_mm},
            {"slack_travel_mm", watched.limits.slack_travel_mm},
            {"suggested", watched.suggested}}},
          {"motion", watched.motion},
          {"peak_ratio", watched.peak_ratio},
          {"above_50", watched.above[0]},
          {"above_70", watched.above[1]},
          {"above_90", watched.above[2]},
          {"below_minimum_s", watched.below_minimum_s},
          {"slack_events", watched.slack_events},
          {"broken", watched.broken},
          {"events", events}};
}

/// As in specimens.csv.
std::string_view status_of(const SeenLife& life) {
  return life.failed ? "failed" : "suspended";
}

ordered_json seen_life_json(const std::optional<SeenLife>& life) {
  return life ? ordered_json{{"cycles", life->cycles},
                             {"effective_tension_N", life->effective_tension_N},
                             {"status", status_of(*life)}}
              : ordered_json(nullptr);
}

void write_watched(std::ostream& out, const Watched& watched) {
  fmt::print(out,
             "  peak          {:.4g} % of the ultimate tension; {} excursions above 50 %, {} above "
             "70 %, {} above 90 %\n",
             100 * watched.peak_ratio, watched.above[0], watched.above[1], watched.above[2]);
  const Model::Watch& limits = watched.limits;
  if (limits.minimum_tension_N > 0) {
    fmt::print(out, "  slack         {:.6g} s below {:.4g} N", watched.below_minimum_s,
               limits.minimum_tension_N);
    if (watched.motion && limits.slack_travel_mm > 0) {
      fmt::print(out, "; loose {} times over {:.4g} mm", watched.slack_events,
                 limits.slack_travel_mm);
    }
    fmt::print(out, "\n");
  }
  if (!watched.motion) {
    fmt::print(out, "  break         not watched: the profile tells no motion of the tendon\n");
  } else if (limits.broken_travel_mm > 0) {
    fmt::print(out, "  break         {}: no more than {:.4g} N over {:.4g} mm of pulling\n",
               watched.broken ? "FOUND" : "none", limits.broken_tension_N, limits.broken_travel_mm);
  }
  if (watched.suggested && limits.broken_travel_mm > 0) {
    fmt::print(out, "  limits        suggested, because the model has no [watch]\n");
  }
}

std::string repeats_text(double repeats) {
  return repeats < 1e6 ? fmt::format("{:.1f}", repeats) : fmt::format("{:.4g}", repeats);
}

void write_repeats(std::ostream& out, const ReplayResult& result) {
  if (!std::isfinite(result.repeats_to.b10)) {
    fmt::print(out, "  repeats       unlimited, no damage in this profile\n");
    return;
  }
  fmt::print(out, "  repeats       {} to B10, {} to B50, {} to the mean life, {} to B90\n",
             repeats_text(result.repeats_to.b10), repeats_text(result.repeats_to.b50),
             repeats_text(result.repeats_to.mean), repeats_text(result.repeats_to.b90));
}

std::string interval_text(const Estimate& estimate, double factor, const char* format) {
  return estimate.interval
             ? fmt::format(" ({} .. {})",
                           fmt::format(fmt::runtime(format), factor * (*estimate.interval)[0]),
                           fmt::format(fmt::runtime(format), factor * (*estimate.interval)[1]))
             : std::string();
}

void write_given_survival(std::ostream& out, const GivenSurvival& given) {
  const auto repeats = [](const Estimate& estimate) {
    return fmt::format("{}{}", repeats_text(estimate.value), interval_text(estimate, 1, "{:.4g}"));
  };
  fmt::print(out, "  whole now     at damage {:.6g}; from there, not from new:\n", given.used);
  if (std::isfinite(given.to_10.value)) {
    fmt::print(out, "                {} repeats to 10 % risk of a break, {} to 50 %, {} to 90 %\n",
               repeats(given.to_10), repeats(given.to_50), repeats(given.to_90));
  } else {
    fmt::print(out, "                unlimited repeats to 10 % risk of a break\n");
  }
  if (given.risk) {
    const std::string hours =
        given.risk->horizon.back() == 'h' ? given.risk->horizon + ", " : std::string();
    fmt::print(out, "                {:.4g} %{} risk of a break within {}{:.5g} repeats\n",
               100 * given.risk->probability.value,
               interval_text(given.risk->probability, 100, "{:.3g}"), hours, given.risk->repeats);
  }
  if (given.level > 0) {
    fmt::print(out, "                in parentheses: {:g} % intervals by the fit alone\n",
               100 * given.level);
  }
}

void write_until_date(std::ostream& out, const UntilDate& until) {
  const AskedUntil& asked = until.asked;
  fmt::print(out,
             "  until date    {}: {:.6g} day{} of {:.4g} h are {:.6g} h or {} repeats; at {:.4g} % "
             "risk of a break\n",
             asked.date, asked.days, asked.days == 1 ? "" : "s", asked.hours_per_day, asked.hours(),
             repeats_text(until.repeats), 100 * asked.risk);
  if (until.lasts_as_it_is()) {
    fmt::print(out,
               "                lasts as it is, with {:.4g} % risk; up to a peak of {:.4g} N, now "
               "{:.4g} N\n",
               100 * until.risk_as_it_is, until.highest_tension_N, until.peak_tension_N);
    return;
  }
  fmt::print(out, "                as it is {:.4g} h to that risk, and {:.4g} % risk at the date\n",
             until.hours_to_risk, 100 * until.risk_as_it_is);
  fmt::print(out,
             "                lasts with a peak of {:.4g} N, now {:.4g} N: {:.3g} % of the tension "
             "given up\n",
             until.highest_tension_N, until.peak_tension_N, 100 * until.tension_given_up());
  fmt::print(out,
             "                or with {:.4g} of the cycles in a time: {:.3g} % of them given up\n",
             until.pace, 100 * until.cycles_given_up());
  fmt::print(out, "                either gains {:.4g} times the life, and {:.4g} % risk\n",
             until.life_gained(), 100 * until.risk_with);
}

ordered_json estimate_json(const Estimate& estimate) {
  ordered_json json{{"value", json_number(estimate.value)}, {"interval", nullptr}};
  if (estimate.interval) {
    json["interval"] = *estimate.interval;
  }
  return json;
}

ordered_json given_survival_json(const GivenSurvival& given) {
  ordered_json json{{"used", given.used},
                    {"repeats_to",
                     {{"10_percent", estimate_json(given.to_10)},
                      {"50_percent", estimate_json(given.to_50)},
                      {"90_percent", estimate_json(given.to_90)}}},
                    {"level", given.level > 0 ? ordered_json(given.level) : ordered_json(nullptr)}};
  if (given.risk) {
    json["break_risk"] = estimate_json(given.risk->probability);
    json["break_risk"]["horizon"] = given.risk->horizon;
    json["break_risk"]["repeats"] = json_number(given.risk->repeats);
  }
  return json;
}

ordered_json until_date_json(const UntilDate& until) {
  const AskedUntil& asked = until.asked;
  return {{"date", asked.date},
          {"days", asked.days},
          {"hours_per_day", asked.hours_per_day},
          {"hours", asked.hours()},
          {"repeats", until.repeats},
          {"risk", asked.risk},
          {"used", until.used},
          {"lasts_as_it_is", until.lasts_as_it_is()},
          {"as_it_is",
           {{"hours_to_risk", json_number(until.hours_to_risk)},
            {"risk_at_date", until.risk_as_it_is}}},
          {"peak_tension_N", until.peak_tension_N},
          {"highest_tension_N", until.highest_tension_N},
          {"tension_given_up", until.tension_given_up()},
          {"pace", until.pace},
          {"cycles_given_up", until.cycles_given_up()},
          {"life_gained", until.life_gained()},
          {"risk_at_date", until.risk_with}};
}

std::string_view prose_of(InputKind kind) {
  switch (kind) {
    case InputKind::kInputTension:
      return "input tension";
    case InputKind::kMotorCurrent:
      return "motor current";
    case InputKind::kOutputTension:
      return "output tension and tendon velocity";
  }
  return "";
}

/// The first of what was found, each with its time and line.
std::vector<std::string> found_sentences(const Watched& watched) {
  constexpr std::size_t kShown = 10;
  std::vector<std::string> sentences;
  for (const FoundInWire& found : watched.found) {
    if (sentences.size() == kShown) {
      sentences.emplace_back("And more: `--json` has them.");
      break;
    }
    sentences.push_back(fmt::format("{} at {:.6g} s, line {} of the profile.",
                                    found.event == WireEvent::broken
                                        ? "Broken: friction alone was left while it was pulled"
                                        : "Loose",
                                    found.time_s, found.line));
  }
  return sentences;
}

/// Parameters of what was evaluated among the constants, what was not among the warnings.
void add_extensions(ReplayReport& report, const ReplayResult& result, const Model& model) {
  for (const std::string& id : result.extensions) {
    for (const Extension::Value& value : extension_of(model.extensions, id)->values) {
      for (const double number : value.values) {
        report.model_constants.push_back({fmt::format("{} of {}", value.name, id), number, ""});
      }
    }
  }
  for (const NotEvaluated& effect : result.not_evaluated) {
    report.warnings.push_back(fmt::format("{} is left out: {}", effect.id, effect.why));
  }
}

}  // namespace

std::string replay_json(const ReplayResult& result) {
  ordered_json json{
      {"input", to_string(result.input)},
      {"samples", result.samples},
      {"duration_s", result.duration_s},
      {"cycles", {{"closed", result.cycles.closed}, {"open_half", result.cycles.open_half}}},
      {"damage", damage_json(result.damage)},
      {"reference_damage", damage_json(result.reference_damage)},
      {"relative_error", json_number(result.relative_error)},
      {"equivalent_effective_tension_N", result.equivalent_effective_tension_N},
      {"peak_tension_N", result.peak_tension_N},
      {"survival_probability", result.survival_probability},
      {"repeats_to",
       {{"B10", json_number(result.repeats_to.b10)},
        {"B50", json_number(result.repeats_to.b50)},
        {"mean", json_number(result.repeats_to.mean)},
        {"B90", json_number(result.repeats_to.b90)}}},
      {"watch", watched_json(result.watched)},
      {"seen_life", seen_life_json(result.seen_life)},
      {"overloads", result.overloads},
      {"missing_samples", result.missing_samples},
      {"flags", result.flags},
      {"warnings", result.warnings},
      {"model_digest", result.model_digest},
  };
  if (!result.extensions.empty() || !result.not_evaluated.empty()) {
    json["extensions"] = result.extensions;
    json["not_evaluated"] = ordered_json::array();
    for (const NotEvaluated& effect : result.not_evaluated) {
      json["not_evaluated"].push_back({{"id", effect.id}, {"why", effect.why}});
    }
  }
  if (result.given_survival) {
    json["given_survival"] = given_survival_json(*result.given_survival);
  }
  if (result.until_date) {
    json["until_date"] = until_date_json(*result.until_date);
  }
  if (result.can_frames) {
    json["can_frames"] = *result.can_frames;
  }
  return json.dump(2) + "\n";
}

void write_summary(std::ostream& out, const ReplayResult& result, const std::string& profile_name,
                   const std::string& model_name) {
  fmt::print(out, "{}: {} samples of {}, {:.6g} s; model {} ({})\n", profile_name, result.samples,
             prose_of(result.input), result.duration_s, model_name, result.model_digest);
  fmt::print(out, "  cycles        {} full, {} half open; equivalent effective tension {:.2f} N\n",
             result.cycles.closed, result.cycles.open_half, result.equivalent_effective_tension_N);
  fmt::print(out, "  life used     {:.6g}  (closed {:.6g}, open {:.6g})\n", result.damage.total,
             result.damage.closed, result.damage.open);
  fmt::print(out, "  reference     {:.6g}  in double precision, relative error {:.1e}\n",
             result.reference_damage.total, result.relative_error);
  fmt::print(out, "  survival      {:.4f} %  after one pass\n", 100 * result.survival_probability);
  write_repeats(out, result);
  if (result.gaps > 0) {
    fmt::print(out, "  gaps          {}, in which {} samples are missing\n", result.gaps,
               result.missing_samples);
  }
  write_watched(out, result.watched);
  if (result.given_survival) {
    write_given_survival(out, *result.given_survival);
  }
  if (result.until_date) {
    write_until_date(out, *result.until_date);
  }
  for (const std::string& id : result.extensions) {
    fmt::print(out, "  {:<13} {}\n", id == kEmpirical ? "correction" : "extension", id);
  }
  for (const NotEvaluated& effect : result.not_evaluated) {
    fmt::print(out, "  left out      {}: {}\n", effect.id, effect.why);
  }
  if (result.can_frames) {
    fmt::print(out, "  bus           {} frames of the firmware\n", *result.can_frames);
  }
  for (const std::string& flag : result.flags) {
    fmt::print(out, "  flag          {}: {}\n", flag, flag_text(flag).meaning);
  }
  for (const std::string& warning : result.warnings) {
    fmt::print(out, "  warning       {}\n", warning);
  }
}

void fill_report(ReplayReport& report, const ReplayResult& result, const Model& model) {
  report.input_kind = prose_of(result.input);
  report.model_digest = result.model_digest;
  report.samples = result.samples;
  report.gaps = result.gaps;
  report.missing_samples = result.missing_samples;
  report.duration_s = result.duration_s;
  report.cycles = result.cycles;
  report.damage = result.damage;
  report.reference_damage = result.reference_damage;
  report.relative_error = result.relative_error;
  report.equivalent_effective_tension_N = result.equivalent_effective_tension_N;
  report.survival_probability = result.survival_probability;
  report.repeats_to = {result.repeats_to.b10, result.repeats_to.b50, result.repeats_to.mean,
                       result.repeats_to.b90};
  report.flags = result.flags;
  report.warnings = result.warnings;
  report.weibull_shape = model.life.weibull_shape;
  report.ultimate_tension_N = model.cable.ultimate_tension_N;
  report.hysteresis_N = model.counting.hysteresis_N;
  report.peak_ratio = result.watched.peak_ratio;
  report.above = result.watched.above;
  report.minimum_tension_N = result.watched.limits.minimum_tension_N;
  report.below_minimum_s = result.watched.below_minimum_s;
  report.slack_events = result.watched.slack_events;
  report.broken = result.watched.broken;
  report.motion = result.watched.motion;
  report.found = found_sentences(result.watched);
  report.given_survival = result.given_survival;
  report.until_date = result.until_date;
  if (result.given_survival) {
    report.break_curve = break_curve(result.given_survival->used, result.damage.total,
                                     result.equivalent_effective_tension_N, model.life);
  }
  report.model_constants = {
      {"cable diameter", model.cable.diameter_mm, "mm"},
      {"ultimate tension", model.cable.ultimate_tension_N, "N"},
      {"friction coefficient", model.sheath.friction_coefficient, ""},
      {"bend angle", model.sheath.bend_angle_deg, "deg"},
      {"sample rate", model.counting.sample_rate_Hz, "Hz"},
      {"hysteresis", model.counting.hysteresis_N, "N"},
      {"scale A of the inverse power law", model.life.ipl_scale, ""},
      {"exponent gamma of the inverse power law", model.life.ipl_exponent, ""},
      {"Weibull shape beta", model.life.weibull_shape, ""},
  };
  const Model::Watch& limits = result.watched.limits;
  const std::string from = result.watched.suggested ? ", suggested" : "";
  for (const ModelConstant& limit : std::initializer_list<ModelConstant>{
           {"minimum tension", limits.minimum_tension_N, "N"},
           {"tension of friction alone", limits.broken_tension_N, "N"},
           {"travel of a slack wire", limits.slack_travel_mm, "mm"},
           {"travel of a broken wire", limits.broken_travel_mm, "mm"}}) {
    if (limit.value > 0) {
      report.model_constants.push_back({limit.name + from, limit.value, limit.unit});
    }
  }
  if (model.drive) {
    report.model_constants.push_back(
        {"torque constant", model.drive->torque_constant_Nm_per_A, "Nm/A"});
    report.model_constants.push_back({"gear ratio", model.drive->gear_ratio, ""});
    report.model_constants.push_back({"gear efficiency", model.drive->gear_efficiency, ""});
    report.model_constants.push_back({"spool radius", model.drive->spool_radius_mm, "mm"});
    report.model_constants.push_back({"current offset", model.drive->current_offset_A, "A"});
  }
  add_extensions(report, result, model);
}

std::string specimens_head() {
  constexpr std::array<std::string_view, 6> kSpecimenColumns{
      "specimen", "lot", "input_tension_mean_N", "input_tension_amplitude_N", "cycles", "status"};
  return csv_head(kSpecimenColumns);
}

std::string specimen_row(std::string_view specimen, const SeenLife& life) {
  CsvRow row;
  row.add(specimen);
  row.add("field");
  row.add(0.0);
  row.add(life.effective_tension_N);
  row.add(life.cycles);
  row.add(status_of(life));
  return row.line();
}

std::vector<std::string> found_in(const ReplayResult& result) {
  std::vector<std::string> found = result.flags;
  if (result.watched.broken) {
    found.emplace_back(kTendonBroken);
  }
  if (result.watched.slack_events > 0) {
    found.emplace_back(kTendonSlack);
  }
  return found;
}

std::vector<std::string> all_findings() {
  std::vector<std::string> names = all_flag_names();
  names.emplace_back(kTendonBroken);
  names.emplace_back(kTendonSlack);
  return names;
}

namespace {

constexpr std::array<std::string_view, 40> kColumns{"profile",
                                                    "model",
                                                    "input",
                                                    "samples",
                                                    "duration_s",
                                                    "cycles_closed",
                                                    "cycles_open_half",
                                                    "damage_closed",
                                                    "damage_open",
                                                    "damage_total",
                                                    "reference_damage_closed",
                                                    "reference_damage_open",
                                                    "reference_damage_total",
                                                    "relative_error",
                                                    "equivalent_effective_tension_N",
                                                    "peak_tension_N",
                                                    "survival_probability",
                                                    "repeats_to_B10",
                                                    "repeats_to_B50",
                                                    "repeats_to_mean",
                                                    "repeats_to_B90",
                                                    "overloads",
                                                    "missing_samples",
                                                    "flags",
                                                    "extensions",
                                                    "not_evaluated",
                                                    "watch_motion",
                                                    "watch_peak_ratio",
                                                    "watch_above_50",
                                                    "watch_above_70",
                                                    "watch_above_90",
                                                    "watch_below_minimum_s",
                                                    "watch_slack_events",
                                                    "watch_broken",
                                                    "seen_life_cycles",
                                                    "seen_life_effective_tension_N",
                                                    "seen_life_status",
                                                    "warnings",
                                                    "model_digest",
                                                    "error"};

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

void add(CsvRow& row, const DamageSplit& damage) {
  row.add(damage.closed);
  row.add(damage.open);
  row.add(damage.total);
}

void add(CsvRow& row, const reference::LifePoints& repeats) {
  row.add(repeats.b10);
  row.add(repeats.b50);
  row.add(repeats.mean);
  row.add(repeats.b90);
}

void add(CsvRow& row, const Watched& watched) {
  row.add(watched.motion ? 1U : 0U);
  row.add(watched.peak_ratio);
  for (const std::uint32_t count : watched.above) {
    row.add(count);
  }
  row.add(watched.below_minimum_s);
  row.add(watched.slack_events);
  row.add(watched.broken ? 1U : 0U);
}

void add(CsvRow& row, const std::optional<SeenLife>& life) {
  row.add(life ? life->cycles : kNothing);
  row.add(life ? life->effective_tension_N : kNothing);
  row.add(life ? status_of(*life) : "");
}

std::vector<std::string_view> ids_of(const std::vector<NotEvaluated>& effects) {
  std::vector<std::string_view> ids;
  ids.reserve(effects.size());
  for (const NotEvaluated& effect : effects) {
    ids.emplace_back(effect.id);
  }
  return ids;
}

}  // namespace

std::string replay_table_head() {
  return csv_head(kColumns);
}

std::string replay_table_row(std::string_view profile, std::string_view model,
                             const ReplayResult& result) {
  CsvRow row;
  row.add(profile);
  row.add(model);
  row.add(to_string(result.input));
  row.add(result.samples);
  row.add(result.duration_s);
  row.add(result.cycles.closed);
  row.add(result.cycles.open_half);
  add(row, result.damage);
  add(row, result.reference_damage);
  row.add(result.relative_error);
  row.add(result.equivalent_effective_tension_N);
  row.add(result.peak_tension_N);
  row.add(result.survival_probability);
  add(row, result.repeats_to);
  row.add(result.overloads);
  row.add(result.missing_samples);
  row.add(fmt::format("{}", fmt::join(result.flags, " ")));
  row.add(fmt::format("{}", fmt::join(result.extensions, " ")));
  row.add(fmt::format("{}", fmt::join(ids_of(result.not_evaluated), " ")));
  add(row, result.watched);
  add(row, result.seen_life);
  row.add(fmt::format("{}", fmt::join(result.warnings, "; ")));
  row.add(result.model_digest);
  row.fill_to(kColumns.size());
  return row.line();
}

std::string refused_replay_row(std::string_view profile, std::string_view model,
                               std::string_view error) {
  CsvRow row;
  row.add(profile);
  row.add(model);
  row.fill_to(kColumns.size() - 1);
  row.add(error);
  return row.line();
}

}  // namespace host_sim
