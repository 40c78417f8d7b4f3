#pragma once

#include <array>
#include <cstddef>

#include "firmware/app/app.hpp"
#include "firmware/app/extended_models.hpp"
#include "firmware/app/extended_sensor.hpp"
#include "firmware/boards/qemu_mps2/extended/swinging_drive.hpp"
#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "lifemodel/extension/life.hpp"

namespace firmware::qemu_mps2 {

/// As Machine, with an extended model and a drive that gives what it is evaluated at.
template <hal::ByteStream Stream, hal::Clock Clock, hal::qemu_mps2::Backing Backing>
class ExtendedMachine {
 public:
  using Flash = hal::qemu_mps2::MemoryFlash<kFlashPages, Backing>;
  using Store = storage::FlashStore<Flash, kTendons>;
  using Can = hal::slcan::Port<Stream>;
  using Sensor = SwingingDrive<kTendons>;
  using Extended = app::ExtendedSensor<Sensor, kTendons>;
  using Layout = lifemodel::extension::ExtendedLife<lifemodel::DefaultLayout>;
  using Line = hal::qemu_mps2::OutputLine;
  using Devices =
      app::Devices<Can, Extended, Clock, Store, Line, Line, Line, hal::qemu_mps2::InputLine,
                   hal::qemu_mps2::CountingWatchdog, hal::qemu_mps2::SeededEntropy>;
  using App = app::App<kTendons, Devices, Layout>;

  ExtendedMachine(Stream& stream, const Clock& clock, Backing& backing, const Settings& settings,
                  const lifemodel::ExtendedParameters& configured)
      : flash(backing),
        store(flash),
        can(stream, settings.channel),
        entropy(settings.seed),
        parameters_(app::stored_parameters<kTendons>(store, settings.parameters)),
        models_(app::extended_models<kTendons>(parameters_, configured)),
        extended_(sensor, models_),
        app(Devices{can, extended_, clock, store, drive_enable, brake, light, emergency_stop,
                    watchdog, entropy, hold_},
            settings.config, parameters_, lives(models_)) {}
  ExtendedMachine(const ExtendedMachine&) = delete;
  ExtendedMachine& operator=(const ExtendedMachine&) = delete;

  Flash flash;
  Store store;
  Can can;
  Sensor sensor;
  Line drive_enable;
  Line brake;
  Line light;
  hal::qemu_mps2::InputLine emergency_stop;
  hal::qemu_mps2::CountingWatchdog watchdog;
  hal::qemu_mps2::SeededEntropy entropy;

 private:
  using Models = typename Extended::Models;

  static std::array<lifemodel::extension::LifeParameters, kTendons> lives(const Models& models) {
    std::array<lifemodel::extension::LifeParameters, kTendons> lives{};
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      lives[tendon] =
          lifemodel::extension::life_parameters(models[tendon].nominal, models[tendon].extension);
    }
    return lives;
  }

  app::ParameterSet<kTendons> parameters_;
  Models models_;
  Extended extended_;
  hal::NoHold hold_;

 public:
  App app;
};

}  // namespace firmware::qemu_mps2
