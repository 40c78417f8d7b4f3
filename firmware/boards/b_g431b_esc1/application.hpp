#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <utility>

#include "firmware/app/app.hpp"
#include "firmware/app/config.hpp"
#include "firmware/app/devices.hpp"
#include "firmware/app/models.hpp"
#include "firmware/app/sensing.hpp"
#include "firmware/boards/b_g431b_esc1/hardware.hpp"
#include "firmware/storage/flash_store.hpp"
#include "lifemodel/extension/needs.hpp"

namespace board {

/// The motor of the board pulls one tendon.
inline constexpr std::size_t kTendons = 1;

using Store = storage::FlashStore<Hardware::Memory, kTendons, kStoreLayout>;
/// Motor current and nothing besides, evaluated by extended models too.
using Sensing = app::ExtendedSensing<decltype(Hardware::sensor), kTendons>;
inline constexpr app::Evaluates kEvaluates{
    .extensions = true, .input = lifemodel::extension::Input::motor_current, .measured = {}};
using Devices = app::Devices<decltype(Hardware::can), Sensing::Sensor, decltype(Hardware::clock),
                             Store, Hardware::Lock::Drive, Hardware::Lock::Brake,
                             decltype(Hardware::status_light), Hardware::Lock::Stop,
                             decltype(Hardware::watchdog), decltype(Hardware::entropy), SettleHold>;

using App = app::App<kTendons, Devices, Sensing::Layout>;

/// The application on the devices of the board.
class Application {
 public:
  Application(Hardware& hardware, const app::Config& config,
              const app::ConfiguredModels<kTendons>& configured)
      : store_(hardware.store_memory),
        models_(app::starting_models<kTendons>(store_, configured, {kEvaluates})),
        sensing_(hardware.sensor, models_.models),
        app_(Devices{hardware.can, sensing_.sensor(), hardware.clock, store_, hardware.drive_enable,
                     hardware.brake, hardware.status_light, hardware.emergency_stop,
                     hardware.watchdog, hardware.entropy, hardware.hold},
             config, models_) {}

  App& app() { return app_; }

 private:
  Store store_;
  app::StartingModels<kTendons> models_;
  Sensing sensing_;
  App app_;
};

/// Makes the one there is, with the parameters that came with the firmware where none were loaded.
App& make_application(Hardware& hardware, const app::Config& config);

/// Room for an object that interrupts reach and main() makes, so that nothing is made before main()
/// and nothing is ever destroyed.
template <class T>
class Room {
 public:
  template <class... Arguments>
  T& make(Arguments&&... arguments) {
    return *new (room_.data()) T(std::forward<Arguments>(arguments)...);
  }
  /// @pre make() was called
  [[nodiscard]] T& get() { return *std::launder(reinterpret_cast<T*>(room_.data())); }

 private:
  alignas(T) std::array<std::byte, sizeof(T)> room_;
};

extern Room<Hardware> hardware_room;
extern Room<Application> application_room;

inline Hardware& hardware() {
  return hardware_room.get();
}
inline Application& application() {
  return application_room.get();
}

}  // namespace board
