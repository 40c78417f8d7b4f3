#include "host_sim/report/replay/captions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

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

namespace host_sim::captions {

std::string origin(const ReplayReport& report) {
  return fmt::format("{} over {}, input: {}. Model: {}, digest {}.",
                     counted_text(report.samples, "sample"), duration_text(report.duration_s),
                     report.input_kind, report.model_name, report.model_digest);
}

std::string tension(const ReplayReport& report) {
  const Envelope& envelope = report.tension;
  if (envelope.time_s.empty()) {
    return "The profile holds no sample.";
  }
  std::string text = fmt::format(
      "From {} to {}.",
      quantity_text(*std::min_element(envelope.low_N.begin(), envelope.low_N.end()), "N", 4),
      quantity_text(*std::max_element(envelope.high_N.begin(), envelope.high_N.end()), "N", 4));
  if (envelope.samples_per_bucket > 1) {
    text += fmt::format(" The band reaches from the lowest to the highest of every {} samples.",
                        count_text(envelope.samples_per_bucket));
  }
  if (report.gaps > 0) {
    text += fmt::format(" {}, in which {} missing{}.", counted_text(report.gaps, "gap"),
                        report.missing_samples == 1
                            ? std::string("1 sample is")
                            : counted_text(report.missing_samples, "sample") + " are",
                        envelope.gaps.empty() ? "" : ", left open");
  }
  const TurningPoints& turning = report.turning_points;
  if (turning.total > turning.points.size()) {
    text += fmt::format(
        " {} of {} turning points are drawn: the lowest and the highest of each run of neighbours.",
        count_text(turning.points.size()), count_text(turning.total));
  } else {
    text += fmt::format(" {} at a hysteresis of {}.", counted_text(turning.total, "turning point"),
                        quantity_text(report.hysteresis_N, "N"));
  }
  return text;
}

std::string range_mean(const ReplayReport& report) {
  if (report.range_mean.count.empty()) {
    return "Every counted cycle by its range and its mean.";
  }
  return fmt::format(
      "Every counted cycle by its range and its mean: {} and {} still open (counting 0.5 each). "
      "Classes are {} of range by {} of mean; damage is worked out from the "
      "exact turning points, not from the classes.",
      counted_text(report.cycles.closed, "closed cycle"),
      counted_text(report.cycles.open_half, "half cycle"),
      quantity_text(report.range_mean.range_step_N, "N"),
      quantity_text(report.range_mean.mean_step_N, "N"));
}

std::string trajectory(const ReplayReport& report) {
  return fmt::format(
      "The damage read at each moment, open cycles included as half cycles. It ends at {}.",
      number_text(report.damage.total));
}

std::string life(const ReplayReport& report) {
  return fmt::format(
      "Share of wires broken after so many repeats: a Weibull distribution of shape {}, whose "
      "characteristic life (63.2\u00a0% broken) is reached at damage 1.",
      number_text(report.weibull_shape));
}

std::string reference(const ReplayReport& report) {
  return fmt::format(
      "The fixed-point estimator against exact counting in double precision, side by side on the "
      "same samples. Relative error of the total: {}.",
      number_text(report.relative_error));
}

std::string constants(const ReplayReport& report) {
  return fmt::format("As read from {}, digest {}.", report.model_name, report.model_digest);
}

std::string footer(const ReplayReport& report) {
  return fmt::format("Made by host_sim {}.", report.program_version);
}

}  // namespace host_sim::captions
