#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <utility>

#include "firmware/app/wired.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/storage/flash_store.hpp"
#include "hal/qemu_mps2/memory_flash.hpp"
#include "hal/qemu_mps2/virtual_devices.hpp"
#include "hal/slcan/port.hpp"
#include "lifemodel/extension/needs.hpp"

namespace boards::qemu_mps2 {

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
template <hal::ByteStream Stream, hal::Clock Clock, hal::qemu_mps2::Backing Backing, hal::Hold Hold,
          class SensorT>
struct MachineDevices {
  using Flash = hal::qemu_mps2::MemoryFlash<kFlashPages, Backing>;
  using Store = storage::FlashStore<Flash, kTendons>;
  using Line = hal::qemu_mps2::OutputLine;

  MachineDevices(Stream& stream, const Clock& time, Backing& backing, Hold& held,
                 const Settings& settings)
      : flash(backing),
        store(flash),
        can(stream, settings.channel),
        clock(time),
        hold(held),
        entropy(settings.seed) {}
  MachineDevices(const MachineDevices&) = delete;
  MachineDevices& operator=(const MachineDevices&) = delete;

  Flash flash;
  Store store;
  hal::slcan::Port<Stream> can;
  SensorT sensor;
  const Clock& clock;
  Hold& hold;
  Line drive_enable;
  Line brake;
  Line status_light;
  hal::qemu_mps2::InputLine emergency_stop;
  hal::qemu_mps2::CountingWatchdog watchdog;
  hal::qemu_mps2::SeededEntropy entropy;
};

/// The application on its devices.
template <hal::ByteStream Stream, hal::Clock Clock, hal::qemu_mps2::Backing Backing,
          hal::Hold Hold = hal::NoHold, class SensorT = PlayedCurrent>
class Machine : public MachineDevices<Stream, Clock, Backing, Hold, SensorT> {
  using Base = MachineDevices<Stream, Clock, Backing, Hold, SensorT>;
  using Wired = app::Wired<kTendons, Base, typename Base::Store>;

 public:
  using App = typename Wired::App;

  Machine(Stream& stream, const Clock& time, Backing& backing, Hold& held, const Settings& settings)
      : Base(stream, time, backing, held, settings),
        wired_(*this, this->store, settings.config, settings.models, evaluates()) {}

 private:
  static std::array<app::Evaluates, kTendons> evaluates() {
    std::array<app::Evaluates, kTendons> all;
    all.fill({true, lifemodel::extension::Input::motor_current, SensorT::kMeasured});
    return all;
  }

  Wired wired_;

 public:
  App& app = wired_.app();
};

}  // namespace boards::qemu_mps2
