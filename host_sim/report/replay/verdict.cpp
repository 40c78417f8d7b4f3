#include "host_sim/report/replay/verdict.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "host_sim/report/page/number_text.hpp"

namespace host_sim {
namespace {

constexpr double kSmallestPercent = 1e-3;
constexpr double kLargestPercent = 10;

std::string share_of_life(double damage) {
  if (damage >= kLargestPercent) {
    return fmt::format("{} times the wire's life", number_text(damage));
  }
  if (damage >= kSmallestPercent) {
    return fmt::format("{} of the wire's life", percent_text(damage));
  }
  return fmt::format("{} of the wire's life", number_text(damage));
}

/// Whole repeats in full while they can be counted, rounded beyond that.
std::string times(double repeats) {
  constexpr double kCountable = 1e6;
  const double whole = std::floor(repeats);
  if (whole == 1) {
    return "once";
  }
  if (whole < kCountable) {
    return count_text(static_cast<std::uint64_t>(whole)) + " times";
  }
  return number_text(repeats) + " times";
}

}  // namespace

std::string verdict(const ReplayReport& report) {
  const std::string subject =
      fmt::format("This profile, {} long,", duration_text(report.duration_s));
  const double damage = report.damage.total;
  const bool has_cycles = report.cycles.closed + report.cycles.open_half > 0;

  if (!std::isfinite(damage)) {
    return subject + " uses an amount of the wire's life that could not be worked out.";
  }
  if (!has_cycles) {
    return subject + " holds no load cycle and uses none of the wire's life.";
  }
  if (damage <= 0) {
    return subject + " uses too little of the wire's life to measure.";
  }
  const std::string use = fmt::format("{} uses {}", subject, share_of_life(damage));
  if (report.repeats_to.B10 >= 1) {
    return fmt::format("{}; it can be repeated {} until 10\u00a0% of wires have broken (B10).", use,
                       times(report.repeats_to.B10));
  }
  return fmt::format("{}; only {} of wires survive one pass.", use,
                     percent_text(report.survival_probability));
}

}  // namespace host_sim
