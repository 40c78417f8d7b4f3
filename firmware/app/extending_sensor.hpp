#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "lifemodel/state/flags.hpp"

namespace app {

/// What the application tells a sensor that extends the model, and asks of it.
template <class T>
concept ExtendingSensor = requires(T& sensor, std::size_t tendon) {
  sensor.isr_missed();
  sensor.start_at(tendon, std::uint64_t{});
  { sensor.isr_flags(tendon) } -> std::same_as<lifemodel::Flags>;
};

}  // namespace app
