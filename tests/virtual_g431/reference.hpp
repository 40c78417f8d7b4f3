#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "firmware/app/app.hpp"
#include "firmware/app/sensing.hpp"
#include "hal/fake/can_port.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/devices.hpp"
#include "hal/stm32g4/current_sensor.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "tests/app/ram_store.hpp"
#include "tests/virtual_g431/board/analog.hpp"

namespace virtual_g431 {

#include "firmware/boards/b_g431b_esc1/parameter_block.inc"

/// The application on the host, over fakes: what the image must count for the same counts.
class Reference {
 public:
  using Sensor = hal::fake::Sensor<lifemodel::MotorCurrent>;
  using Sensing = app::ExtendedSensing<Sensor, 1>;
  using Devices =
      app::Devices<hal::fake::CanPort, Sensing::Sensor, hal::fake::Clock, app::RamStore,
                   hal::fake::DigitalOut, hal::fake::DigitalOut, hal::fake::DigitalOut,
                   hal::fake::DigitalIn, hal::fake::Watchdog, hal::fake::Entropy, hal::NoHold>;

  /// `rest` is what the amplifiers gave while the zeros were measured.
  explicit Reference(const PhaseCounts& rest,
                     const lifemodel::ExtendedParameters& model = compiled_in())
      : models_(starting(model)) {
    for (std::uint32_t i = 0; i < hal::stm32g4::PhaseCurrent::kRestSamples; ++i) {
      current_.take_rest(rest);
    }
    (void)current_.finish_rest();
    app_.start();
  }

  /// One period of the control loop, and what runs below it.
  void period(const PhaseCounts& counts) {
    clock_.advance({100});
    if (const auto sample = current_.isr_amplitude(counts)) {
      sensor_.give(0, *sample);
    }
    app_.isr_sample();
    while (app_.settle()) {
    }
    app_.poll();
  }

  [[nodiscard]] lifemodel::Damage damage() const { return app_.lives().records()[0].epoch_damage; }
  [[nodiscard]] std::uint32_t damage_ppb() const { return damage().parts_per_billion(); }

  /// What came with the firmware.
  static lifemodel::ExtendedParameters compiled_in() {
    return *lifemodel::decode_extended(std::as_bytes(std::span(tendonlife_parameter_block)));
  }

 private:
  static app::StartingModels<1> starting(const lifemodel::ExtendedParameters& model) {
    app::StartingModels<1> models;
    models.models[0] = model;
    models.states[0].source = app::ParameterSource::configured;
    return models;
  }

  hal::fake::Clock clock_;
  hal::fake::CanBus bus_{clock_};
  hal::fake::CanPort can_{bus_};
  Sensor sensor_{clock_};
  app::RamStore store_{clock_};
  hal::fake::DigitalOut drive_enable_{clock_}, brake_{clock_}, light_{clock_};
  hal::fake::DigitalIn stop_{clock_};
  hal::fake::Watchdog watchdog_{clock_, hal::milliseconds(500)};
  hal::fake::Entropy entropy_{clock_, 1};
  hal::NoHold hold_;
  hal::stm32g4::PhaseCurrent current_;
  app::StartingModels<1> models_;
  Sensing sensing_{sensor_, models_.models};
  app::App<1, Devices, Sensing::Layout> app_{
      Devices{can_, sensing_.sensor(), clock_, store_, drive_enable_, brake_, light_, stop_,
              watchdog_, entropy_, hold_},
      {.node = 5},
      models_};
};

}  // namespace virtual_g431
