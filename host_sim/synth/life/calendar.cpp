#include "host_sim/synth/life/calendar.hpp"

#include <cmath>

namespace host_sim::synth {
namespace {

constexpr double kSecondsPerDay = 86400;

}  // namespace

double Calendar::days_of(double cycles) const {
  return cycles / (frequency_Hz * kSecondsPerDay);
}

double Calendar::aged_cycles(double cycles) const {
  const double rate_1_cycle = rate_1_day * days_of(1);
  const double at_first = std::exp(rate_1_day * first_day);
  return rate_1_cycle > 0 ? at_first * std::expm1(rate_1_cycle * cycles) / rate_1_cycle
                          : at_first * cycles;
}

double Calendar::cycles_for(double aged_cycles) const {
  if (!std::isfinite(aged_cycles)) {
    return aged_cycles;
  }
  const double rate_1_cycle = rate_1_day * days_of(1);
  const double at_first = std::exp(rate_1_day * first_day);
  return rate_1_cycle > 0 ? std::log1p(rate_1_cycle * aged_cycles / at_first) / rate_1_cycle
                          : aged_cycles / at_first;
}

}  // namespace host_sim::synth
