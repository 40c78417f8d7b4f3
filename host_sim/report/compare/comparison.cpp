#include "host_sim/report/compare/comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

namespace host_sim::compare {

double ratio(double b, double a) {
  return a == b ? 1 : b / a;
}

std::vector<Quantity> quantities_of(const Comparison& comparison) {
  const auto both = [&comparison](std::string name, std::string unit,
                                  const std::function<double(const Side&)>& value) {
    return Quantity{
        std::move(name), std::move(unit), {value(comparison.a()), value(comparison.b())}};
  };
  return {
      both("Life used", "", [](const Side& side) { return side.report.damage.total; }),
      both("Repeats to B10", "", [](const Side& side) { return side.report.repeats_to.B10; }),
      both("Repeats to B50", "", [](const Side& side) { return side.report.repeats_to.B50; }),
      both("Hours to B10", "h",
           [](const Side& side) { return side.hours(side.report.repeats_to.B10); }),
      both("Hours to B50", "h",
           [](const Side& side) { return side.hours(side.report.repeats_to.B50); }),
      both("Equivalent effective tension", "N",
           [](const Side& side) { return side.report.equivalent_effective_tension_N; }),
      both("Highest tension", "N", [](const Side& side) { return side.peak_tension_N(); }),
      both("Full cycles", "",
           [](const Side& side) { return static_cast<double>(side.report.cycles.closed); }),
      both("Half cycles", "",
           [](const Side& side) { return static_cast<double>(side.report.cycles.open_half); }),
      both("Length", "s", [](const Side& side) { return side.report.duration_s; }),
      both("Missing samples", "",
           [](const Side& side) { return static_cast<double>(side.report.missing_samples); }),
  };
}

std::string sentence_of(const Comparison& comparison) {
  const auto hours = [](const Side& side) { return side.hours(side.report.repeats_to.B10); };
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
      lives, comparison.a().report.equivalent_effective_tension_N,
      comparison.b().report.equivalent_effective_tension_N);
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
                     : fmt::format("line {} with {:.6g} {}", line, value, of.unit);
  };
  return fmt::format("The first samples that differ are at {:.6g} s: A {}, B {}.", first.time_s,
                     side(comparison.a(), first.line_a, first.a),
                     side(comparison.b(), first.line_b, first.b));
}

}  // namespace host_sim::compare
