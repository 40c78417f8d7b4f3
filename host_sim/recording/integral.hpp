#pragma once

#include <span>
#include <vector>

namespace host_sim::recording {

/// The integral of a rate over time by trapezoids, from 0 at the first sample on.
std::vector<double> integral(std::span<const double> time_s, std::span<const double> rate);

}  // namespace host_sim::recording
