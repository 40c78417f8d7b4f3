#pragma once

#include <vector>

#include "host_sim/diagnose/tension/hypothesis.hpp"

namespace host_sim::diagnose {

/// The parts of a hypothesis that are larger than what noise of the tensions could imitate. Noise
/// bends whatever goes with a tension by as much as its variance, and what is known of that
/// variance is rough: a part counts where its root mean square in ln T, beside gain and friction,
/// is kTimesVariance times the variances of both ends or more.
std::vector<Component> beyond_noise(const Evidence& evidence, const std::vector<Component>& parts);
inline constexpr double kTimesVariance = 4;

}  // namespace host_sim::diagnose
