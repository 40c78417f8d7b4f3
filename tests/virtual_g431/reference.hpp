#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "firmware/app/wired.hpp"
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
  /// `rest` is what the amplifiers gave while the zeros were measured.
  explicit Reference(const PhaseCounts& rest,
                     const lifemodel::ExtendedParameters& model = compiled_in())
      : wired_(board_, store_, {.node = 5}, {model},
               {app::Evaluates{
                   true, lifemodel::extension::Input::motor_current, {true, true, true, true}}}) {
    for (std::uint32_t i = 0; i < hal::stm32g4::PhaseCurrent::kRestSamples; ++i) {
      current_.take_rest(rest);
    }
    (void)current_.finish_rest();
    app_.start();
  }

  /// One period of the control loop, and what runs below it.
  void period(const PhaseCounts& counts) {
    board_.clock.advance({100});
    if (const auto sample = current_.isr_amplitude(counts)) {
      board_.sensor.give(0, *sample);
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
  struct Fakes {
    hal::fake::Clock clock;
    hal::fake::CanBus bus{clock};
    hal::fake::CanPort can{bus};
    hal::fake::Sensor<lifemodel::MotorCurrent> sensor{clock};
    hal::fake::DigitalOut drive_enable{clock}, brake{clock}, status_light{clock};
    hal::fake::DigitalIn emergency_stop{clock};
    hal::fake::Watchdog watchdog{clock, hal::milliseconds(500)};
    hal::fake::Entropy entropy{clock, 1};
    hal::NoHold hold;
  };
  using Wired = app::Wired<1, Fakes, app::RamStore>;

  Fakes board_;
  app::RamStore store_{board_.clock};
  hal::stm32g4::PhaseCurrent current_;
  Wired wired_;
  Wired::App& app_ = wired_.app();
};

}  // namespace virtual_g431
