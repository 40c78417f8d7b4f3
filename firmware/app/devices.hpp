#pragma once

#include "firmware/storage/store.hpp"
#include "hal/can_port.hpp"
#include "hal/clock.hpp"
#include "hal/devices.hpp"

namespace app {

/// What the application needs of a board. Everything outlives the application.
template <hal::CanPort CanT, hal::Sensor SensorT, hal::Clock ClockT, storage::Store StoreT,
          hal::DigitalOut DriveEnableT, hal::DigitalOut BrakeT, hal::DigitalOut StatusLightT,
          hal::DigitalIn EmergencyStopT, hal::Watchdog WatchdogT, hal::Entropy EntropyT,
          hal::Hold HoldT = hal::NoHold>
struct Devices {
  CanT& can;
  SensorT& sensor;
  const ClockT& clock;
  StoreT& store;
  DriveEnableT& drive_enable;      ///< asserted: the drive may move
  BrakeT& brake;                   ///< asserted: the brake holds
  StatusLightT& status_light;      ///< asserted: lit
  EmergencyStopT& emergency_stop;  ///< asserted: stop; an Error counts as asserted
  WatchdogT& watchdog;
  EntropyT& entropy;
  HoldT& hold;  ///< keeps settle() away while poll() reads

  using Can = CanT;
  using Sensor = SensorT;
  using Clock = ClockT;
  using Store = StoreT;
  using Entropy = EntropyT;
};

}  // namespace app
