#include "host_sim/replay/results.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <cmath>
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

ordered_json damage_json(const DamageSplit& damage) {
  return {{"closed", damage.closed}, {"open", damage.open}, {"total", damage.total}};
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

namespace {

constexpr std::array<std::string_view, 29> kColumns{"profile",
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
                                                    "warnings",
                                                    "model_digest",
                                                    "error"};

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
