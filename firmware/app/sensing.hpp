#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "firmware/app/extended_sensor.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/extension/life.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/tendon.hpp"

namespace app {

/// How a board evaluates the models of its tendons: the sensor that its application reads, and the
/// layout and models of its estimator. This one leaves extensions out.
template <class SensorT, std::size_t kTendons>
class NominalSensing {
 public:
  using Sensor = SensorT;
  using Layout = lifemodel::DefaultLayout;

  /// Both outlive this object.
  NominalSensing(SensorT& sensor, const ExtendedModels<kTendons>& models)
      : sensor_(sensor), models_(models) {}

  Sensor& sensor() { return sensor_; }
  [[nodiscard]] std::array<lifemodel::Parameters, kTendons> models() const {
    std::array<lifemodel::Parameters, kTendons> nominal{};
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      nominal[tendon] = models_[tendon].nominal;
    }
    return nominal;
  }

 private:
  SensorT& sensor_;
  const ExtendedModels<kTendons>& models_;
};

/// The same with extensions, of samples that have what these are written in terms of. On an input
/// tension only those of the life act.
template <class SensorT, std::size_t kTendons>
class ExtendedSensing {
  static constexpr bool kAsItIs = std::is_same_v<typename SensorT::Sample, lifemodel::Tension>;
  using Held = std::conditional_t<kAsItIs, SensorT&, ExtendedSensor<SensorT, kTendons>>;

 public:
  using Sensor = std::remove_reference_t<Held>;
  using Layout = lifemodel::extension::ExtendedLife<lifemodel::DefaultLayout>;

  /// Both outlive this object.
  ExtendedSensing(SensorT& sensor, const ExtendedModels<kTendons>& models)
      : held_(make(sensor, models)), models_(models) {}
  ExtendedSensing(const ExtendedSensing&) = delete;
  ExtendedSensing& operator=(const ExtendedSensing&) = delete;

  Sensor& sensor() { return held_; }
  [[nodiscard]] auto models() const { return life_models<kTendons>(models_); }

 private:
  static Held make(SensorT& sensor, const ExtendedModels<kTendons>& models) {
    if constexpr (kAsItIs) {
      return sensor;
    } else {
      return Held(sensor, models);
    }
  }

  Held held_;
  const ExtendedModels<kTendons>& models_;
};

}  // namespace app
