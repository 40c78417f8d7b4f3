#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "firmware/app/app.hpp"
#include "firmware/app/config.hpp"
#include "firmware/app/devices.hpp"
#include "firmware/app/models.hpp"
#include "firmware/app/sensing.hpp"

namespace app {

/// The application on the devices of a board, with the models that it starts with and the sensor
/// that evaluates them.
///
/// BoardT has the devices by the names of Devices, but for the store, as members or references.
template <std::size_t kTendons, class BoardT, storage::Store StoreT,
          template <class, std::size_t> class SensingT = ExtendedSensing>
class Wired {
  template <class Member>
  using Device = std::remove_cvref_t<Member>;

 public:
  using Sensing = SensingT<Device<decltype(BoardT::sensor)>, kTendons>;
  using Devices =
      app::Devices<Device<decltype(BoardT::can)>, typename Sensing::Sensor,
                   Device<decltype(BoardT::clock)>, StoreT, Device<decltype(BoardT::drive_enable)>,
                   Device<decltype(BoardT::brake)>, Device<decltype(BoardT::status_light)>,
                   Device<decltype(BoardT::emergency_stop)>, Device<decltype(BoardT::watchdog)>,
                   Device<decltype(BoardT::entropy)>, Device<decltype(BoardT::hold)>>;
  using App = app::App<kTendons, Devices, typename Sensing::Layout>;

  /// Board and store outlive this object.
  Wired(BoardT& board, StoreT& store, const Config& config,
        const ConfiguredModels<kTendons>& configured,
        const std::array<Evaluates, kTendons>& evaluates)
      : models_(starting_models<kTendons>(store, configured, evaluates)),
        sensing_(board.sensor, models_.models),
        app_(Devices{board.can, sensing_.sensor(), board.clock, store, board.drive_enable,
                     board.brake, board.status_light, board.emergency_stop, board.watchdog,
                     board.entropy, board.hold},
             config, models_) {}
  Wired(const Wired&) = delete;
  Wired& operator=(const Wired&) = delete;

  App& app() { return app_; }
  [[nodiscard]] const App& app() const { return app_; }
  [[nodiscard]] const StartingModels<kTendons>& models() const { return models_; }
  typename Sensing::Sensor& sensor() { return sensing_.sensor(); }

 private:
  StartingModels<kTendons> models_;
  Sensing sensing_;
  App app_;
};

}  // namespace app
