#include "host_sim/reference/reference.hpp"

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "host_sim/reference/cycle_damage.hpp"

namespace host_sim::reference {
namespace {

void require(bool in_range, const char* name, const char* accepted) {
  if (!in_range) {
    throw std::invalid_argument(std::string(name) + " must be finite and " + accepted);
  }
}

bool is_positive(double value) {
  return std::isfinite(value) && value > 0.0;
}

const Constants& checked(const Constants& constants) {
  require(is_positive(constants.ultimate_tension_N), "ultimate_tension_N", "positive");
  require(std::isfinite(constants.hysteresis_N) && constants.hysteresis_N >= 0.0, "hysteresis_N",
          "not negative");
  require(is_positive(constants.ipl_scale), "ipl_scale", "positive");
  require(is_positive(constants.ipl_exponent), "ipl_exponent", "positive");
  require(is_positive(constants.weibull_shape), "weibull_shape", "positive");
  return constants;
}

}  // namespace

Reference::Reference(const Constants& constants, EffectiveTension effective)
    : constants_(checked(constants)),
      effective_(std::move(effective)),
      filter_(constants.hysteresis_N) {}

void Reference::refuse_sample() {
  throw std::invalid_argument("input tension is not finite");
}

void Reference::add(Closed& closed, const Cycle& cycle) const {
  closed.damage.add(cycle_damage(cycle, constants_, effective_));
  ++closed.cycles;
  closed.overloads += is_overload(cycle, constants_) ? 1U : 0U;
}

void Reference::count(double turning_point_N) {
  rainflow_.push(turning_point_N, [this](const Cycle& cycle) { add(closed_, cycle); });
}

Reading Reference::reading() const {
  Closed closed = closed_;
  FourPointRainflow rainflow = rainflow_;
  if (const std::optional<double> extremum_N = filter_.unconfirmed()) {
    rainflow.push(*extremum_N, [&](const Cycle& cycle) { add(closed, cycle); });
  }

  CompensatedSum open;
  std::uint64_t half_cycles = 0;
  std::uint64_t overloads = 0;
  const auto count_half = [&](const Cycle& half) {
    open.add(cycle_damage(half, constants_, effective_) / 2.0);
    ++half_cycles;
    overloads += is_overload(half, constants_) ? 1U : 0U;
  };
  const std::span<const double> residue_N = rainflow.residue();
  for (std::size_t i = 1; i < residue_N.size(); ++i) {
    count_half({residue_N[i - 1], residue_N[i]});
  }
  if (const Cycle up{0.0, peak_N_}; residue_N.empty() && is_overload(up, constants_)) {
    count_half(up);
  }

  return {.damage = {.closed = closed.damage.value(),
                     .open = open.value(),
                     .total = closed.damage.value() + open.value()},
          .closed_cycles = closed.cycles,
          .open_half_cycles = half_cycles,
          .peak_tension_N = peak_N_,
          .overload_cycles = closed.overloads,
          .overload_half_cycles = overloads};
}

}  // namespace host_sim::reference
