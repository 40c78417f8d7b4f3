#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "host_sim/reference/compensated_sum.hpp"
#include "host_sim/reference/constants.hpp"
#include "host_sim/reference/cycle.hpp"
#include "host_sim/reference/cycle_damage.hpp"
#include "host_sim/reference/four_point_rainflow.hpp"
#include "host_sim/reference/turning_points.hpp"

namespace host_sim::reference {

/// Damage as a fraction of the characteristic life alpha.
struct Damage {
  double closed;
  double open;
  double total;
};

/// What a signal has done so far, counted over its turning points and its unconfirmed last
/// extremum: the closed cycles of the four-point count, and its residue as half cycles. Together
/// they are the cycles and half cycles of ASTM E1049-85 clause 5.4.4. A signal that reaches the
/// ultimate tension before its first turning point has its way there from zero as a half cycle.
struct Reading {
  Damage damage;
  std::uint64_t closed_cycles;
  std::uint64_t open_half_cycles;
  double peak_tension_N;               ///< largest magnitude of any sample; 0 before the first
  std::uint64_t overload_cycles;       ///< closed cycles that reached the ultimate tension
  std::uint64_t overload_half_cycles;  ///< the same of the open half cycles
};

/// The double-precision life model of one tendon: turning points, rainflow, Gerber, inverse power
/// law, Miner. The independent reference of the estimator that runs on the target.
class Reference {
 public:
  /// @param effective in place of Gerber's, where the life law is extended
  /// @throws std::invalid_argument naming the constant that is out of the range of Constants
  explicit Reference(const Constants& constants, EffectiveTension effective = {});

  /// Takes the next sample of the input tension, counted as it is where negative.
  /// @throws std::invalid_argument if it is not finite; the count is then as before the call
  void push(double input_tension_N) {
    if (!std::isfinite(input_tension_N)) {
      refuse_sample();
    }
    peak_N_ = std::max(peak_N_, std::abs(input_tension_N));
    if (const std::optional<double> turning_point_N = filter_.push(input_tension_N)) {
      count(*turning_point_N);
    }
  }

  /// The reading at this instant; O(residue). Taking it changes nothing. It never falls as samples
  /// come in.
  Reading reading() const;

 private:
  struct Closed {
    CompensatedSum damage;
    std::uint64_t cycles = 0;
    std::uint64_t overloads = 0;
  };

  [[noreturn]] static void refuse_sample();
  void count(double turning_point_N);
  void add(Closed& closed, const Cycle& cycle) const;

  Constants constants_;
  EffectiveTension effective_;
  TurningPointFilter filter_;
  FourPointRainflow rainflow_;
  Closed closed_;
  double peak_N_ = 0.0;
};

}  // namespace host_sim::reference
