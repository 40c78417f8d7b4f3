#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "firmware/app/config.hpp"
#include "firmware/boards/linux/config.hpp"
#include "firmware/boards/linux/report.hpp"
#include "lifemodel/block/parameters.hpp"

namespace board {

/// All that a run needs, checked.
struct Setup {
  Config config;
  app::Config node;
  std::vector<lifemodel::Parameters> parameters;  ///< one a tendon
  bool virtual_clock = false;
};

/// Reads what a configuration names. Throws hal::files::InputError, also where the sensor needs a
/// drive that the parameters do not have.
Setup read_setup(const Config& config, bool virtual_clock);

/// Runs until `stop` is set or the profile is at its end. Throws what Controller throws.
Report run(const Setup& setup, const std::atomic<bool>& stop);

/// The same for a number of tendons.
template <std::size_t kTendons>
Report run_tendons(const Setup& setup, const std::atomic<bool>& stop);

extern template Report run_tendons<1>(const Setup&, const std::atomic<bool>&);
extern template Report run_tendons<2>(const Setup&, const std::atomic<bool>&);
extern template Report run_tendons<3>(const Setup&, const std::atomic<bool>&);
extern template Report run_tendons<4>(const Setup&, const std::atomic<bool>&);

}  // namespace board
