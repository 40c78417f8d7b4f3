#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "host_sim/compare/compare.hpp"
#include "host_sim/io/json.hpp"

namespace host_sim::compare {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, 2> kNames{"A", "B"};

ordered_json life_json(const Side& side, const std::function<double(double)>& of_repeats) {
  const RepeatsTo& to = side.report.repeats_to;
  return {{"B10", json_number(of_repeats(to.B10))},
          {"B50", json_number(of_repeats(to.B50))},
          {"mean", json_number(of_repeats(to.mean))},
          {"B90", json_number(of_repeats(to.B90))}};
}

ordered_json side_json(const Side& side) {
  const ReplayReport& report = side.report;
  return {{"profile", side.profile},
          {"model", side.model},
          {"model_digest", report.model_digest},
          {"samples", report.samples},
          {"missing_samples", report.missing_samples},
          {"duration_s", report.duration_s},
          {"cycles", {{"closed", report.cycles.closed}, {"open_half", report.cycles.open_half}}},
          {"damage", report.damage.total},
          {"equivalent_effective_tension_N", report.equivalent_effective_tension_N},
          {"peak_tension_N", side.peak_tension_N()},
          {"repeats_to", life_json(side, [](double repeats) { return repeats; })},
          {"hours_to", life_json(side, [&side](double repeats) { return side.hours(repeats); })},
          {"flags", report.flags},
          {"warnings", report.warnings}};
}

ordered_json optional_json(const std::optional<double>& value) {
  return value ? json_number(*value) : ordered_json(nullptr);
}

ordered_json first_json(const std::optional<FirstDifference>& first) {
  if (!first) {
    return nullptr;
  }
  const auto side = [](std::uint64_t line, double value) {
    return line == 0 ? ordered_json(nullptr) : ordered_json{{"line", line}, {"value", value}};
  };
  return {{"time_s", first->time_s},
          {"a", side(first->line_a, first->a)},
          {"b", side(first->line_b, first->b)}};
}

std::string number_of(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string("unlimited");
}

std::string number_of(const std::optional<double>& value) {
  return value ? number_of(*value) : std::string("none");
}

std::string factor_of(double factor) {
  return fmt::format("{:.4g}", factor);
}

}  // namespace

std::string compare_json(const Comparison& comparison) {
  ordered_json ratios;
  const auto add = [&](const char* name, const std::function<double(const Side&)>& value) {
    ratios[name] = json_number(ratio(value(comparison.b()), value(comparison.a())));
  };
  add("damage", [](const Side& side) { return side.report.damage.total; });
  add("equivalent_effective_tension_N",
      [](const Side& side) { return side.report.equivalent_effective_tension_N; });
  add("repeats_to_B10", [](const Side& side) { return side.report.repeats_to.B10; });
  add("hours_to_B10", [](const Side& side) { return side.hours(side.report.repeats_to.B10); });
  const ordered_json json{
      {"of", comparison.of_models ? "models" : "profiles"},
      {"a", side_json(comparison.a())},
      {"b", side_json(comparison.b())},
      {"b_over_a", ratios},
      {"differences", json_list(comparison.differences,
                                [](const Difference& one) {
                                  return ordered_json{
                                      {"name", one.name},
                                      {"a", optional_json(one.a)},
                                      {"b", optional_json(one.b)},
                                      {"life_ratio", optional_json(one.life_ratio)}};
                                })},
      {"first_sample", first_json(comparison.first)},
      {"apart_s", optional_json(comparison.apart_s)},
      {"classes", json_list(comparison.classes, [](const CycleClass& one) {
         return ordered_json{{"range_N", one.range_N},
                             {"mean_N", one.mean_N},
                             {"cycles", one.cycles},
                             {"damage", one.damage}};
       })}};
  return json.dump(2) + "\n";
}

namespace {

void write_differences(std::ostream& out, const std::vector<Difference>& differences) {
  if (differences.empty()) {
    fmt::print(out, "The models say the same.\n");
    return;
  }
  fmt::print(out, "{:<40} {:>12} {:>12} {:>12}\n", "differs", "A", "B", "life alone");
  for (const Difference& one : differences) {
    fmt::print(out, "{:<40} {:>12} {:>12} {:>12}\n", one.name, number_of(one.a), number_of(one.b),
               one.life_ratio ? "x " + factor_of(*one.life_ratio) : "unknown");
  }
}

void write_classes(std::ostream& out, const std::vector<CycleClass>& classes) {
  constexpr std::size_t kShown = 5;
  if (classes.empty()) {
    fmt::print(out, "No cycle was counted in either.\n");
    return;
  }
  fmt::print(out, "{:<40} {:>12} {:>12}\n", "damage by class of cycles", "A", "B");
  for (std::size_t i = 0; i < std::min(kShown, classes.size()); ++i) {
    const CycleClass& one = classes[i];
    const std::string name =
        fmt::format("  {:.4g} to {:.4g} N about {:.4g} to {:.4g} N", one.range_N[0], one.range_N[1],
                    one.mean_N[0], one.mean_N[1]);
    fmt::print(out, "{:<40} {:>12} {:>12}\n", name, number_of(one.damage[0]),
               number_of(one.damage[1]));
  }
  if (classes.size() > kShown) {
    fmt::print(out, "  and {} more, which differ less\n", classes.size() - kShown);
  }
}

}  // namespace

void write_compare(std::ostream& out, const Comparison& comparison) {
  for (std::size_t i = 0; i < comparison.sides.size(); ++i) {
    const Side& side = comparison.sides[i];
    fmt::print(out, "{}  {} with model {} ({})\n", kNames[i], side.profile, side.model,
               side.report.model_digest);
  }
  fmt::print(out, "{}\n{:<40} {:>12} {:>12} {:>12}\n", sentence_of(comparison), "", "A", "B",
             "B / A");
  for (const Quantity& quantity : quantities_of(comparison)) {
    const auto& [a, b] = quantity.values;
    fmt::print(out, "{:<40} {:>12} {:>12} {:>12}\n",
               quantity.unit.empty() ? quantity.name : quantity.name + ", " + quantity.unit,
               number_of(a), number_of(b), factor_of(ratio(b, a)));
  }
  if (comparison.of_models) {
    write_differences(out, comparison.differences);
  } else {
    fmt::print(out, "{}\n", first_of(comparison));
  }
  write_classes(out, comparison.classes);
  if (comparison.apart_s) {
    fmt::print(out, "The damages are apart by more than {:g} % after {:.6g} s.\n", 100 * kApart,
               *comparison.apart_s);
  } else {
    fmt::print(out, "The damages are never apart by more than {:g} % while both last.\n",
               100 * kApart);
  }
  for (std::size_t i = 0; i < comparison.sides.size(); ++i) {
    for (const std::string& warning : comparison.sides[i].report.warnings) {
      fmt::print(out, "warning of {}: {}\n", kNames[i], warning);
    }
  }
}

}  // namespace host_sim::compare
