#pragma once

#include "firmware/boards/linux/controller.hpp"

namespace board {

/// Each number of tendons is compiled in a file of its own: it takes a while.
template <std::size_t kTendons>
Report run_tendons(const Setup& setup, const std::atomic<bool>& stop) {
  const auto with = [&](auto sensor) {
    return Controller<kTendons, decltype(sensor)>(setup, sensor).run(stop);
  };
  if (measures_current(setup.config)) {
    return with(CurrentSensor(setup));
  }
  if (profile_kind(setup.config) == hal::files::InputKind::kInputTension) {
    return with(profile_sensor<lifemodel::Tension>(setup));
  }
  return with(profile_sensor<app::OutputTension>(setup));
}

}  // namespace board
