#pragma once

namespace host_sim::synth {

/// Cycles at one frequency from one day on, while damage for each cycle grows by exp(rate t).
struct Calendar {
  double rate_1_day = 0;
  double first_day = 0;
  double frequency_Hz = 1;

  [[nodiscard]] double days_of(double cycles) const;

  /// How many cycles of day 0 do the same damage: the integral of exp(rate t) over the cycles.
  [[nodiscard]] double aged_cycles(double cycles) const;

  /// The inverse of aged_cycles().
  [[nodiscard]] double cycles_for(double aged_cycles) const;
};

}  // namespace host_sim::synth
