#include <fmt/ostream.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "hal/files/csv.hpp"
#include "host_sim/design/study.hpp"
#include "host_sim/io/json.hpp"

namespace host_sim::design {
namespace {

using hal::files::CsvRow;
using nlohmann::ordered_json;

ordered_json tendon_json(const Tendon& tendon) {
  return {{"bend_angle_deg", tendon.bend_angle_deg},
          {"friction_coefficient", tendon.friction_coefficient},
          {"output_tension_max_N", tendon.output_max_N},
          {"output_tension_min_N", tendon.output_min_N},
          {"diameter_mm", tendon.diameter_mm}};
}

ordered_json margin_json(const Margin& margin) {
  return {{"life", json_number(margin.life)}, {"tension", json_number(margin.tension)}};
}

ordered_json elasticity_json(const Elasticity& elasticity) {
  return {{"input", elasticity.input},
          {"percent_per_percent", json_number(elasticity.value)},
          {"life_factor_tenth_less", json_number(elasticity.life_tenth_less)},
          {"life_factor_tenth_more", json_number(elasticity.life_tenth_more)}};
}

ordered_json curve_json(const Curve& curve) {
  return {{"bend_angle_deg", curve.bend_angle_deg},
          {"output_tension_max_N", json_list(curve.output_max_N, json_number)},
          {"life_cycles", json_list(curve.life_cycles, json_number)}};
}

ordered_json test_json(const std::optional<AcceleratedTest>& test) {
  if (!test) {
    return nullptr;
  }
  return {{"tendon", tendon_json(test->tendon)},
          {"acceleration_factor", json_number(test->factor)},
          {"life_cycles", json_number(test->life_cycles)}};
}

std::string_view name_of(Unknown unknown) {
  return unknown_names()[static_cast<std::size_t>(unknown)];
}

double hours_of(double cycles, double cycles_per_minute) {
  return cycles / cycles_per_minute / 60;
}

}  // namespace

std::string design_json(const Study& study, const Telling& telling) {
  const auto& [design, stress, life_cycles, interval, lives, safety, elasticities, test, curves] =
      study;
  ordered_json json{{"model_digest", telling.model_digest},
                    {"found", name_of(design.found)},
                    {"tendon", tendon_json(design.tendon)},
                    {"ultimate_tension_N", stress.ultimate_tension_N},
                    {"risk", design.risk},
                    {"life_cycles", json_number(life_cycles)},
                    {"wanted_life_cycles", json_number(design.life_cycles)}};
  if (telling.cycles_per_minute) {
    json["life_hours"] = json_number(hours_of(life_cycles, *telling.cycles_per_minute));
  }
  json["life_interval_cycles"] = interval
                                     ? ordered_json{{"level", interval->level},
                                                    {"low", json_number(interval->low_cycles)},
                                                    {"high", json_number(interval->high_cycles)}}
                                     : ordered_json(nullptr);
  json.update({{"efficiency", stress.efficiency},
               {"input_tension_mean_N", stress.input.mean_N},
               {"input_tension_amplitude_N", stress.input.amplitude_N},
               {"effective_tension_N", stress.effective_tension_N},
               {"lives_cycles",
                {{"B10", json_number(lives.b10)},
                 {"B50", json_number(lives.b50)},
                 {"mean", json_number(lives.mean)},
                 {"B90", json_number(lives.b90)}}},
               {"safety",
                {{"strength", safety.strength},
                 {"at_risk", margin_json(safety.at_risk)},
                 {"at_half", margin_json(safety.at_half)}}},
               {"elasticities", json_list(elasticities, elasticity_json)},
               {"test", test_json(test)},
               {"curves", json_list(curves, curve_json)}});
  return json.dump(2) + "\n";
}

namespace {

std::string table_row(const Model& model, const Tendon& tendon, double life_cycles,
                      std::string_view what) {
  const Stress stress = stress_of(model, tendon);
  CsvRow row;
  row.add(what);
  for (const double value : {tendon.bend_angle_deg, tendon.friction_coefficient,
                             tendon.output_min_N, tendon.output_max_N, tendon.diameter_mm,
                             stress.peak_N(), stress.effective_tension_N, life_cycles}) {
    row.add(value);
  }
  return row.line();
}

}  // namespace

std::string design_table(const Model& model, const Study& study) {
  constexpr std::array<std::string_view, 9> kColumns{"what",
                                                     "bend_angle_deg",
                                                     "friction_coefficient",
                                                     "output_tension_min_N",
                                                     "output_tension_max_N",
                                                     "diameter_mm",
                                                     "input_tension_peak_N",
                                                     "effective_tension_N",
                                                     "life_cycles"};
  const Design& design = study.design;
  std::string table =
      hal::files::csv_head(kColumns) + table_row(model, design.tendon, study.life_cycles, "design");
  for (const Curve& curve : study.curves) {
    Tendon tendon = design.tendon;
    tendon.bend_angle_deg = curve.bend_angle_deg;
    for (std::size_t i = 0; i < curve.output_max_N.size(); ++i) {
      tendon.output_max_N = curve.output_max_N[i];
      tendon.output_min_N = design.tendon.load_ratio() * tendon.output_max_N;
      table += table_row(model, tendon, curve.life_cycles[i], "curve");
    }
  }
  return table;
}

namespace {

std::string cycles_text(double cycles) {
  return std::isinf(cycles) ? "unlimited" : fmt::format("{:.4g} cycles", cycles);
}

std::string load_text(const Tendon& tendon) {
  return tendon.output_min_N == tendon.output_max_N
             ? fmt::format("{:.4g} N, constant", tendon.output_max_N)
             : fmt::format("{:.4g} .. {:.4g} N", tendon.output_min_N, tendon.output_max_N);
}

/// Marks the line of what was found.
std::string_view mark(const Design& design, Unknown unknown) {
  return design.found == unknown ? "  <- found" : "";
}

void write_tendon(std::ostream& out, const Study& study, const Telling& telling) {
  const Design& design = study.design;
  const Tendon& tendon = design.tendon;
  fmt::print(out, "  output tension        {}{}\n", load_text(tendon),
             mark(design, Unknown::tension));
  fmt::print(out, "  bend angle            {:.4g} deg{}\n", tendon.bend_angle_deg,
             mark(design, Unknown::bend));
  fmt::print(out, "  friction coefficient  {:.4g}{}\n", tendon.friction_coefficient,
             mark(design, Unknown::friction));
  fmt::print(out, "  wire                  {:.4g} mm, holds {:.4g} N{}\n", tendon.diameter_mm,
             study.stress.ultimate_tension_N, mark(design, Unknown::wire));
  fmt::print(out, "  life                  {}", cycles_text(study.life_cycles));
  if (telling.cycles_per_minute && std::isfinite(study.life_cycles)) {
    fmt::print(out, ", {:.4g} h at {:g} a minute",
               hours_of(study.life_cycles, *telling.cycles_per_minute), *telling.cycles_per_minute);
  }
  fmt::print(out, "{}\n", mark(design, Unknown::life));
  if (study.interval) {
    fmt::print(out, "    {:g} % interval      {:.4g} .. {:.4g} cycles\n",
               100 * study.interval->level, study.interval->low_cycles,
               study.interval->high_cycles);
  }
  fmt::print(out, "  risk                  {:.4g} %{}\n", 100 * design.risk,
             mark(design, Unknown::risk));
}

void write_stress(std::ostream& out, const Study& study) {
  const Stress& stress = study.stress;
  fmt::print(out, "  efficiency            {:.3f}\n", stress.efficiency);
  fmt::print(out, "  input tension         {:.4g} .. {:.4g} N\n",
             stress.input.mean_N - stress.input.amplitude_N, stress.peak_N());
  fmt::print(out, "  effective tension     {:.4g} N\n", stress.effective_tension_N);
  const reference::LifePoints& lives = study.lives_cycles;
  if (std::isfinite(lives.mean)) {
    fmt::print(out, "  B10, B50, mean, B90   {:.4g}, {:.4g}, {:.4g}, {:.4g} cycles\n", lives.b10,
               lives.b50, lives.mean, lives.b90);
  }
}

void write_safety(std::ostream& out, const Study& study) {
  const Safety& safety = study.safety;
  fmt::print(out, "safety factors          of tension  of life\n");
  fmt::print(out, "  until torn at once    {:10.3f}\n", safety.strength);
  if (!std::isfinite(study.design.life_cycles)) {
    return;
  }
  fmt::print(out, "  until {:<15} {:10.3f} {:8.3f}\n",
             fmt::format("{:.4g} % break", 100 * study.design.risk), safety.at_risk.tension,
             safety.at_risk.life);
  fmt::print(out, "  until half break      {:10.3f} {:8.3f}\n", safety.at_half.tension,
             safety.at_half.life);
}

void write_elasticities(std::ostream& out, const std::vector<Elasticity>& elasticities) {
  if (elasticities.empty()) {
    return;
  }
  fmt::print(out, "percent of life per percent of    times the life with -10 %   +10 %\n");
  for (const Elasticity& of : elasticities) {
    fmt::print(out, "  {:<22} {:8.3f} {:23.3f} {:>12}\n", of.input, of.value, of.life_tenth_less,
               of.life_tenth_more == 0 ? "torn" : fmt::format("{:.3f}", of.life_tenth_more));
  }
}

}  // namespace

std::string sentence_of(const Study& study) {
  const Design& design = study.design;
  const Tendon& tendon = design.tendon;
  const std::string life =
      fmt::format("{} at a risk of {:.4g} %", cycles_text(design.life_cycles), 100 * design.risk);
  switch (design.found) {
    case Unknown::life:
      return std::isinf(design.life_cycles)
                 ? std::string("Life has no end: nothing varies the tension")
                 : fmt::format("Life: {}", life);
    case Unknown::tension:
      return fmt::format("Output tension: {}, for {}", load_text(tendon), life);
    case Unknown::bend:
      return fmt::format("Bend angle: {:.4g} deg, for {}", tendon.bend_angle_deg, life);
    case Unknown::friction:
      return fmt::format("Friction coefficient: {:.4g}, for {}", tendon.friction_coefficient, life);
    case Unknown::wire:
      return fmt::format("Wire: {:.4g} mm that holds {:.4g} N, for {}", tendon.diameter_mm,
                         study.stress.ultimate_tension_N, life);
    case Unknown::risk:
      return fmt::format("Risk: {:.4g} % break within {}", 100 * design.risk,
                         cycles_text(design.life_cycles));
    case Unknown::safety:
      return fmt::format("Safety: {:.3g} times the tension or {:.3g} times the life of {}",
                         study.safety.at_risk.tension, study.safety.at_risk.life, life);
  }
  return {};
}

void write_design(std::ostream& out, const Study& study, const Telling& telling) {
  fmt::print(out, "{}\n", sentence_of(study));
  write_tendon(out, study, telling);
  write_stress(out, study);
  write_safety(out, study);
  write_elasticities(out, study.elasticities);
  if (study.test) {
    fmt::print(out,
               "acceleration factor     {:.4g}: a test at {}, {:.4g} deg lasts {} at that risk\n",
               study.test->factor, load_text(study.test->tendon), study.test->tendon.bend_angle_deg,
               cycles_text(study.test->life_cycles));
  }
}

}  // namespace host_sim::design
