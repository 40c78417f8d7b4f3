#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "host_sim/reference/turning_points.hpp"

namespace host_sim::reference::testing {

using Signal = std::vector<double>;

/// Values on a grid of the given step; a coarse grid makes many ties.
inline rc::Gen<Signal> grid_signal(int lowest, int highest, double step_N) {
  return rc::gen::container<Signal>(rc::gen::map(rc::gen::inRange(lowest, highest + 1),
                                                 [step_N](int level) { return level * step_N; }));
}

/// Swings that widen to a random outermost pair and then narrow again, with a random number of
/// equal ones on the way: the residue at its deepest.
inline rc::Gen<Signal> spiral_signal() {
  return rc::gen::map(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 4)),
                      [](const std::vector<int>& growth) {
                        Signal signal;
                        int radius = 0;
                        int sign = 1;
                        for (std::size_t i = 0; i < growth.size(); ++i) {
                          radius += i < growth.size() / 2 ? growth[i] : -growth[i];
                          signal.push_back(0.1 * sign * std::max(radius, 0) + 0.3);
                          sign = -sign;
                        }
                        return signal;
                      });
}

inline rc::Gen<Signal> any_signal() {
  return rc::gen::oneOf(grid_signal(-1000, 1000, 0.1), grid_signal(-3, 3, 1.0), spiral_signal());
}

/// The confirmed turning points and, last, the unconfirmed one.
inline Signal turning_points(const Signal& signal, double hysteresis_N = 0.0) {
  TurningPointFilter filter(hysteresis_N);
  Signal points;
  for (const double tension_N : signal) {
    if (const std::optional<double> point = filter.push(tension_N)) {
      points.push_back(*point);
    }
  }
  if (const std::optional<double> last = filter.unconfirmed()) {
    points.push_back(*last);
  }
  return points;
}

}  // namespace host_sim::reference::testing
