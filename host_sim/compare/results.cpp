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
  const reference::LifePoints& to = side.result.repeats_to;
  return {{"B10", json_number(of_repeats(to.b10))},
          {"B50", json_number(of_repeats(to.b50))},
          {"mean", json_number(of_repeats(to.mean))},
          {"B90", json_number(of_repeats(to.b90))}};
}

ordered_json side_json(const Side& side) {
  const ReplayResult& result = side.result;
  return {{"profile", side.of.profile},
          {"model", side.of.model_file},
          {"model_digest", result.model_digest},
          {"samples", result.samples},
          {"missing_samples", result.missing_samples},
          {"duration_s", result.duration_s},
          {"cycles", {{"closed", result.cycles.closed}, {"open_half", result.cycles.open_half}}},
          {"damage", result.damage.total},
          {"equivalent_effective_tension_N", result.equivalent_effective_tension_N},
          {"peak_tension_N", result.peak_tension_N},
          {"repeats_to", life_json(side, [](double repeats) { return repeats; })},
          {"hours_to", life_json(side, [&side](double repeats) { return side.hours(repeats); })},
          {"flags", result.flags},
          {"warnings", result.warnings}};
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

std::string_view unit_of(hal::files::InputKind kind) {
  return kind == hal::files::InputKind::kMotorCurrent ? "A" : "N";
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

std::vector<Quantity> quantities_of(const Comparison& comparison) {
  const auto both = [&comparison](std::string name, std::string unit,
                                  const std::function<double(const Side&)>& value) {
    return Quantity{
        std::move(name), std::move(unit), {value(comparison.a()), value(comparison.b())}};
  };
  return {
      both("Life used", "", [](const Side& side) { return side.result.damage.total; }),
      both("Repeats to B10", "", [](const Side& side) { return side.result.repeats_to.b10; }),
      both("Repeats to B50", "", [](const Side& side) { return side.result.repeats_to.b50; }),
      both("Hours to B10", "h",
           [](const Side& side) { return side.hours(side.result.repeats_to.b10); }),
      both("Hours to B50", "h",
           [](const Side& side) { return side.hours(side.result.repeats_to.b50); }),
      both("Equivalent effective tension", "N",
           [](const Side& side) { return side.result.equivalent_effective_tension_N; }),
      both("Highest tension", "N", [](const Side& side) { return side.result.peak_tension_N; }),
      both("Full cycles", "",
           [](const Side& side) { return static_cast<double>(side.result.cycles.closed); }),
      both("Half cycles", "",
           [](const Side& side) { return static_cast<double>(side.result.cycles.open_half); }),
      both("Length", "s", [](const Side& side) { return side.result.duration_s; }),
      both("Missing samples", "",
           [](const Side& side) { return static_cast<double>(side.result.missing_samples); }),
  };
}

std::string sentence_of(const Comparison& comparison) {
  const auto hours = [](const Side& side) { return side.hours(side.result.repeats_to.b10); };
  const double life = ratio(hours(comparison.b()), hours(comparison.a()));
  const std::string_view what = comparison.of_models ? "model" : "profile";
  const std::string lives =
      life == 1 ? fmt::format("as long with {} B as with A", what)
      : std::isinf(life) || life == 0
          ? fmt::format("without limit with {} {} alone", what, life == 0 ? "A" : "B")
          : fmt::format("{:.3g} times as long with {} B as with A", life, what);
  return fmt::format(
      "The wire lives {} (B10, in operation); effective tension {:.4g} N with A, "
      "{:.4g} N with B.",
      lives, comparison.a().result.equivalent_effective_tension_N,
      comparison.b().result.equivalent_effective_tension_N);
}

std::string first_of(const Comparison& comparison) {
  if (comparison.of_models) {
    return {};
  }
  if (!comparison.first) {
    return "All samples are equal.";
  }
  const FirstDifference& first = *comparison.first;
  const auto side = [](const Side& of, std::uint64_t line, double value) {
    return line == 0 ? std::string("has ended")
                     : fmt::format("line {} with {:.6g} {}", line, value, unit_of(of.result.input));
  };
  return fmt::format("The first samples that differ are at {:.6g} s: A {}, B {}.", first.time_s,
                     side(comparison.a(), first.line_a, first.a),
                     side(comparison.b(), first.line_b, first.b));
}

std::string compare_json(const Comparison& comparison) {
  ordered_json ratios;
  const auto add = [&](const char* name, const std::function<double(const Side&)>& value) {
    ratios[name] = json_number(ratio(value(comparison.b()), value(comparison.a())));
  };
  add("damage", [](const Side& side) { return side.result.damage.total; });
  add("equivalent_effective_tension_N",
      [](const Side& side) { return side.result.equivalent_effective_tension_N; });
  add("repeats_to_B10", [](const Side& side) { return side.result.repeats_to.b10; });
  add("hours_to_B10", [](const Side& side) { return side.hours(side.result.repeats_to.b10); });
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
    const Replayed& of = comparison.sides[i].of;
    fmt::print(out, "{}  {} with model {} ({})\n", kNames[i], of.profile, of.model_file,
               comparison.sides[i].result.model_digest);
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
    for (const std::string& warning : comparison.sides[i].result.warnings) {
      fmt::print(out, "warning of {}: {}\n", kNames[i], warning);
    }
  }
}

}  // namespace host_sim::compare
