#include "host_sim/report/replay/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

#include "host_sim/report/page/number_text.hpp"
#include "host_sim/report/page/table.hpp"

namespace host_sim::tables {
namespace {

constexpr int kTableDigits = 6;

std::string span_text(double start, double step) {
  return fmt::format("{} to {}", number_text(start, 4), number_text(start + step, 4));
}

std::string relative_difference(double ours, double reference) {
  if (reference == 0) {
    return ours == 0 ? "0" : "not defined";
  }
  return number_text((ours - reference) / reference);
}

}  // namespace

std::string key_numbers(const ReplayReport& report) {
  Table table("Key numbers", {"Quantity", "Value"});
  const auto number = [&table](std::string_view name, double value, std::string_view unit = "") {
    table.row(name, {quantity_text(value, unit, kTableDigits)});
  };
  table.row("Samples", {count_text(report.samples)});
  number("Duration", report.duration_s, "s");
  table.row("Closed cycles", {count_text(report.cycles.closed)});
  table.row("Open half cycles", {count_text(report.cycles.open_half)});
  number("Damage of closed cycles", report.damage.closed);
  number("Damage of open half cycles", report.damage.open);
  number("Damage in total", report.damage.total);
  number("Relative error against the reference", report.relative_error);
  number("Equivalent effective tension", report.equivalent_effective_tension_N, "N");
  number("Probability of surviving one pass", report.survival_probability);
  number("Repeats until 10 % have broken (B10)", report.repeats_to.B10);
  number("Repeats until 50 % have broken (B50)", report.repeats_to.B50);
  number("Mean life in repeats", report.repeats_to.mean);
  number("Repeats until 90 % have broken (B90)", report.repeats_to.B90);
  return table.html();
}

std::string worst_classes(const RangeMeanMatrix& matrix) {
  constexpr std::size_t kShown = 10;
  std::vector<std::size_t> classes(matrix.count.size());
  std::iota(classes.begin(), classes.end(), std::size_t{0});
  std::erase_if(classes, [&matrix](std::size_t i) { return !(matrix.count[i] > 0); });
  const auto shown = static_cast<std::ptrdiff_t>(std::min(kShown, classes.size()));
  std::partial_sort(
      classes.begin(), classes.begin() + shown, classes.end(),
      [&matrix](std::size_t a, std::size_t b) {
        return matrix.damage[a] != matrix.damage[b] ? matrix.damage[a] > matrix.damage[b] : a < b;
      });
  const double total = std::accumulate(matrix.damage.begin(), matrix.damage.end(), 0.0);

  Table table("Classes that do the most damage",
              {"Range, N", "Mean, N", "Cycles", "Damage", "Share of the damage"});
  for (auto it = classes.begin(); it != classes.begin() + shown; ++it) {
    const std::size_t range_class = *it / matrix.means;
    const auto range = static_cast<double>(range_class);
    const auto mean = static_cast<double>(*it % matrix.means);
    table.row(span_text(range * matrix.range_step_N, matrix.range_step_N),
              {span_text(matrix.mean_min_N + mean * matrix.mean_step_N, matrix.mean_step_N),
               number_text(matrix.count[*it], kTableDigits), number_text(matrix.damage[*it]),
               total > 0 ? percent_text(matrix.damage[*it] / total) : std::string("none")});
  }
  return table.html();
}

std::string reference(const ReplayReport& report) {
  Table table("Damage against the reference",
              {"Damage", "Estimator", "Reference", "Relative difference"});
  const auto row = [&table](std::string_view name, double ours, double exact) {
    table.row(name, {number_text(ours, kTableDigits), number_text(exact, kTableDigits),
                     relative_difference(ours, exact)});
  };
  row("Closed cycles", report.damage.closed, report.reference_damage.closed);
  row("Open half cycles", report.damage.open, report.reference_damage.open);
  row("Total", report.damage.total, report.reference_damage.total);
  return table.html();
}

std::string constants(const ReplayReport& report) {
  Table table("Constants of the model", {"Constant", "Value"});
  for (const ModelConstant& constant : report.model_constants) {
    table.row(constant.name, {quantity_text(constant.value, constant.unit, kTableDigits)});
  }
  return table.html();
}

}  // namespace host_sim::tables
