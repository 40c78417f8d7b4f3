#include "host_sim/synth/specimen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

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

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// Lives by the mode of the nominal model and by another one, at one load.
using Lives = std::array<double, 2>;

Lives lives_cycles(const LifeModel& model, const LifeLoad& load, double strength, LifeParts parts) {
  const double effective_N = effective_tension_N(model, load, parts);
  double damaging_N = effective_N;
  double factor = strength;
  double other_cycles = kForever;
  for (const auto& part : parts) {
    damaging_N = part->damaging_tension_N(damaging_N);
    factor *= part->life_factor();
    other_cycles = std::min(other_cycles, part->other_life_cycles(effective_N));
  }
  const double own_cycles =
      damaging_N > 0 ? factor * reference::ipl_life_cycles(damaging_N, model.life.ipl_scale,
                                                           model.life.ipl_exponent)
                     : kForever;
  return {own_cycles, other_cycles};
}

/// A share of one life as the share of another that leaves the same damage.
double carried_over(double share, double from_cycles, double to_cycles, double exponent) {
  if (!std::isfinite(from_cycles) || !std::isfinite(to_cycles) || exponent == 0) {
    return share;
  }
  return std::pow(share, std::pow(from_cycles / to_cycles, exponent));
}

double sum_of(LifeParts parts, double (LifePart::*of)() const) {
  double sum = 0;
  for (const auto& part : parts) {
    sum += ((*part).*of)();
  }
  return sum;
}

}  // namespace

double effective_tension_N(const LifeModel& model, const LifeLoad& load, LifeParts parts) {
  reference::MeanAmplitude output{load.output_mean_N, load.output_amplitude_N};
  for (const auto& part : parts) {
    output = part->output_N(output);
  }
  const double efficiency = reference::capstan_efficiency(
      model.friction_coefficient, load.bend_angle_deg * std::numbers::pi / 180);
  reference::MeanAmplitude input = reference::input_tension_range(output, efficiency);
  for (const auto& part : parts) {
    input = part->input_N(input, load);
  }
  double effective_N = reference::gerber_effective_tension(input, model.cable.ultimate_tension_N);
  for (const auto& part : parts) {
    effective_N = part->effective_tension_N(effective_N, input, model.cable.ultimate_tension_N);
  }
  return effective_N;
}

LifeResult run_specimen(const LifeModel& model, std::span<const LifeStep> steps, double strength,
                        double storage_days, LifeParts parts) {
  const double exponent = sum_of(parts, &LifePart::sequence_exponent);
  const double ageing_1_day = sum_of(parts, &LifePart::ageing_1_day);
  LifeResult result;
  result.days = storage_days;
  Lives last{kForever, kForever};
  std::array<double, 2> spent{};
  for (const LifeStep& step : steps) {
    const Calendar calendar{ageing_1_day, result.days, step.load.frequency_Hz};
    const Lives lives = lives_cycles(model, step.load, strength, parts);
    double left_cycles = kForever;
    for (std::size_t mode = 0; mode < lives.size(); ++mode) {
      spent[mode] = carried_over(spent[mode], last[mode], lives[mode], exponent);
      left_cycles = std::min(left_cycles, (1 - spent[mode]) * lives[mode]);
    }
    const double until_failure = std::max(1.0, std::round(calendar.cycles_for(left_cycles)));
    result.failed = until_failure <= step.cycles;
    const double cycles = std::min(until_failure, step.cycles);
    result.cycles.push_back(cycles);
    result.days += calendar.days_of(cycles);
    if (result.failed) {
      return result;
    }
    for (std::size_t mode = 0; mode < lives.size(); ++mode) {
      spent[mode] += std::isfinite(lives[mode]) ? calendar.aged_cycles(cycles) / lives[mode] : 0;
    }
    last = lives;
  }
  return result;
}

}  // namespace host_sim::synth
