#pragma once

#include <cstddef>
#include <type_traits>

#include "firmware/app/extended_sensor.hpp"
#include "firmware/app/intake.hpp"
#include "lifemodel/extension/life.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/tendon.hpp"

namespace app {

/// How a board evaluates the models of its tendons: the sensor that its application reads, and the
/// layout of its estimator. This one evaluates no extensions.
template <class SensorT, std::size_t kTendons>
class NominalSensing {
 public:
  using Sensor = SensorT;
  using Layout = lifemodel::DefaultLayout;

  /// Both outlive this object.
  NominalSensing(SensorT& sensor, const ExtendedModels<kTendons>&) : sensor_(sensor) {}

  Sensor& sensor() { return sensor_; }

 private:
  SensorT& sensor_;
};

/// The same with extensions, of samples that have what these are written in terms of. On an input
/// tension only those of the life act.
template <class SensorT, std::size_t kTendons>
class ExtendedSensing {
  static constexpr bool kAsItIs =
      std::is_same_v<typename SensorT::Sample, lifemodel::Tension> ||
      std::is_same_v<typename SensorT::Sample, Moving<lifemodel::Tension>>;
  using Held = std::conditional_t<kAsItIs, SensorT&, ExtendedSensor<SensorT, kTendons>>;

 public:
  using Sensor = std::remove_reference_t<Held>;
  using Layout = lifemodel::extension::ExtendedLife<lifemodel::DefaultLayout>;

  /// Both outlive this object.
  ExtendedSensing(SensorT& sensor, const ExtendedModels<kTendons>& models)
      : held_(make(sensor, models)) {}
  ExtendedSensing(const ExtendedSensing&) = delete;
  ExtendedSensing& operator=(const ExtendedSensing&) = delete;

  Sensor& sensor() { return held_; }

 private:
  static Held make(SensorT& sensor, const ExtendedModels<kTendons>& models) {
    if constexpr (kAsItIs) {
      return sensor;
    } else {
      return Held(sensor, models);
    }
  }

  Held held_;
};

}  // namespace app
