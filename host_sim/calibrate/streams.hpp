#pragma once

#include <cstddef>
#include <cstdint>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"

namespace host_sim::calibrate {

/// What random numbers are drawn for; each use has streams of its own.
enum class Purpose : std::uint64_t {
  goodness_of_fit = 1,
  quantile_band,
  level_bias,
  common_shape,
  common_bias = 6,
  campaigns,
  adequacy,
  validation,
  next_specimen,
};

/// Stream of the `index`-th use of a purpose.
inline std::uint64_t stream_of(Purpose purpose, std::size_t index = 0) {
  constexpr unsigned kIndexBits = 32;
  return static_cast<std::uint64_t>(purpose) << kIndexBits | index;
}

inline statistics::BootstrapOptions bootstrap(const CalibrateOptions& options, Purpose purpose,
                                              std::size_t index = 0) {
  return {options.seed, stream_of(purpose, index), options.bootstraps, options.threads};
}

}  // namespace host_sim::calibrate
