#include "host_sim/calibrate/output/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace host_sim::calibrate {
namespace {

constexpr double kWholeBelow = 1e6;
constexpr double kTenthsBelow = 100;

std::string special(double value) {
  return std::isnan(value) ? "-" : "no limit";
}

}  // namespace

std::string figure(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : special(value);
}

std::string figure(const statistics::Interval& interval) {
  return fmt::format("{} .. {}", figure(interval.low), figure(interval.high));
}

std::string cycles_text(double cycles) {
  if (!std::isfinite(cycles)) {
    return special(cycles);
  }
  if (cycles < kTenthsBelow || cycles >= kWholeBelow) {
    return fmt::format("{:.4g}", cycles);
  }
  return fmt::format("{:.0f}", cycles);
}

std::string cycles_text(const statistics::Interval& interval_cycles) {
  return fmt::format("{} .. {}", cycles_text(interval_cycles.low),
                     cycles_text(interval_cycles.high));
}

std::string p_text(double p) {
  if (!std::isfinite(p)) {
    return "-";
  }
  return p >= 0.001 || p == 0 ? fmt::format("{:.3f}", p) : fmt::format("{:.0e}", p);
}

}  // namespace host_sim::calibrate
