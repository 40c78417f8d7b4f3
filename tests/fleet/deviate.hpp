#pragma once

#include <cmath>
#include <numbers>

#include "host_sim/statistics/random.hpp"

/// A standard normal deviate, by Box and Muller.
inline double deviate(host_sim::statistics::Random& random) {
  return std::sqrt(-2 * std::log(random.uniform())) *
         std::cos(2 * std::numbers::pi * random.uniform());
}
