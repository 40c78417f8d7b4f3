#pragma once

#include <concepts>
#include <cstddef>

#include "hal/result.hpp"
#include "lifemodel/quantity/units.hpp"

namespace hal {

/// Gives what a tendon is loaded with: motor current, or, with a load cell, input tension.
///
/// isr_read() gives the newest sample in constant time, from the interrupt of the control loop.
/// missing: no new sample since the last call; failed: the sensor reports a fault or a value that
/// it cannot measure.
template <class T>
concept Sensor = requires(T& sensor, std::size_t tendon) {
  typename T::Sample;
  { sensor.isr_read(tendon) } -> std::same_as<Result<typename T::Sample>>;
};

template <class T>
concept CurrentSensor = Sensor<T> && std::same_as<typename T::Sample, lifemodel::MotorCurrent>;

}  // namespace hal
