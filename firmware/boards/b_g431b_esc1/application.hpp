#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <utility>

#include "firmware/app/wired.hpp"
#include "firmware/boards/b_g431b_esc1/hardware.hpp"
#include "firmware/storage/flash_store.hpp"
#include "lifemodel/extension/needs.hpp"

namespace boards::b_g431b_esc1 {

/// The motor of the board pulls one tendon.
inline constexpr std::size_t kTendons = 1;

using Store = storage::FlashStore<Hardware::Memory, kTendons, kStoreLayout>;
/// Motor current and nothing besides, evaluated by extended models too.
inline constexpr app::Evaluates kEvaluates{
    .extensions = true, .input = lifemodel::extension::Input::motor_current, .measured = {}};
using Wired = app::Wired<kTendons, Hardware, Store>;
using App = Wired::App;

/// The application on the devices of the board.
class Application {
 public:
  Application(Hardware& hardware, const app::Config& config,
              const app::ConfiguredModels<kTendons>& configured)
      : store_(hardware.store_memory), wired_(hardware, store_, config, configured, {kEvaluates}) {}

  App& app() { return wired_.app(); }

 private:
  Store store_;
  Wired wired_;
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

}  // namespace boards::b_g431b_esc1
