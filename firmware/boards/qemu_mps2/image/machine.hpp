#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <utility>

#include "firmware/app/app.hpp"
#include "firmware/app/models.hpp"
#include "firmware/app/sensing.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/storage/flash_store.hpp"
#include "hal/qemu_mps2/memory_flash.hpp"
#include "hal/qemu_mps2/virtual_devices.hpp"
#include "hal/slcan/port.hpp"
#include "lifemodel/extension/needs.hpp"

namespace firmware::qemu_mps2 {

/// Makes the one T of the program, in room of its own and not on the stack. It is never destroyed.
/// @pre called once for each T
template <class T, class... Arguments>
T& make_once(Arguments&&... arguments) {
  alignas(T) static std::array<std::byte, sizeof(T)> room;
  return *new (room.data()) T(std::forward<Arguments>(arguments)...);
}

inline constexpr std::uint32_t kFlashPages = 20;
inline constexpr std::uint32_t kFlashBytes = kFlashPages * 2'048;

struct Settings {
  app::Config config;
  app::ConfiguredModels<kTendons> models;  ///< where the store has none
  std::uint32_t seed = 1;                  ///< of the entropy
  hal::slcan::Channel channel = hal::slcan::Channel::closed;
};

/// Motor currents, and nothing besides.
struct PlayedCurrent : hal::qemu_mps2::PlayedSensor<kTendons> {
  static constexpr lifemodel::extension::Measured kMeasured{};
};

/// The devices of a machine around whatever sensor it has. The same on the board and, with other
/// lines and files below it, on the host.
template <hal::ByteStream Stream, hal::qemu_mps2::Backing Backing, class SensorT>
class MachineDevices {
 public:
  using Flash = hal::qemu_mps2::MemoryFlash<kFlashPages, Backing>;
  using Store = storage::FlashStore<Flash, kTendons>;
  using Can = hal::slcan::Port<Stream>;
  using Sensor = SensorT;
  using Line = hal::qemu_mps2::OutputLine;

  MachineDevices(Stream& stream, Backing& backing, const Settings& settings)
      : flash(backing), store(flash), can(stream, settings.channel), entropy(settings.seed) {}
  MachineDevices(const MachineDevices&) = delete;
  MachineDevices& operator=(const MachineDevices&) = delete;

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

 protected:
  /// What the application gets, with what it reads in place of the sensor.
  template <class Read, class Clock, class Hold>
  using Devices =
      app::Devices<Can, Read, Clock, Store, Line, Line, Line, hal::qemu_mps2::InputLine,
                   hal::qemu_mps2::CountingWatchdog, hal::qemu_mps2::SeededEntropy, Hold>;

  template <class Read, class Clock, class Hold>
  Devices<Read, Clock, Hold> devices(Read& read, const Clock& clock, Hold& hold) {
    return {can,   read,           clock,    store,   drive_enable, brake,
            light, emergency_stop, watchdog, entropy, hold};
  }
};

/// The application on its devices, which evaluates the extensions that its sensor allows.
template <hal::ByteStream Stream, hal::Clock Clock, hal::qemu_mps2::Backing Backing,
          hal::Hold Hold = hal::NoHold, class SensorT = PlayedCurrent>
class Machine : public MachineDevices<Stream, Backing, SensorT> {
  using Base = MachineDevices<Stream, Backing, SensorT>;

 public:
  using Sensing = app::ExtendedSensing<SensorT, kTendons>;
  using App =
      app::App<kTendons, typename Base::template Devices<typename Sensing::Sensor, Clock, Hold>,
               typename Sensing::Layout>;

  Machine(Stream& stream, const Clock& clock, Backing& backing, Hold& hold,
          const Settings& settings)
      : Base(stream, backing, settings),
        models_(app::starting_models<kTendons>(this->store, settings.models, evaluates())),
        sensing_(this->sensor, models_.models),
        app(this->devices(sensing_.sensor(), clock, hold), settings.config, models_) {}

 private:
  static std::array<app::Evaluates, kTendons> evaluates() {
    std::array<app::Evaluates, kTendons> all;
    all.fill({true, lifemodel::extension::Input::motor_current, SensorT::kMeasured});
    return all;
  }

  app::StartingModels<kTendons> models_;
  Sensing sensing_;

 public:
  App app;
};

}  // namespace firmware::qemu_mps2
