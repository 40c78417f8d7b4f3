#pragma once

#include <cstdint>

namespace boards::b_g431b_esc1 {

inline constexpr std::uint32_t kLoop_Hz = 10'000;
inline constexpr std::uint32_t kLoopPeriod_us = 1'000'000 / kLoop_Hz;
/// Debouncing of the emergency stop: 2 ms.
inline constexpr std::uint32_t kStopSamples = 2 * kLoop_Hz / 1000;
/// So many periods in time, one after the other, let the drive go: 10 ms, in which a broken wire of
/// the stop is seen.
inline constexpr std::uint32_t kPeriodsInTime = 10 * kLoop_Hz / 1000;
static_assert(kPeriodsInTime > kStopSamples);

/// One period of the control loop, on devices with the members of Hardware. True where settling is
/// due.
template <class Devices, class App>
bool isr_period(Devices& devices, App& app) {
  const std::uint32_t now_us = devices.clock.isr_tick();
  devices.sensor.isr_latch();
  const std::uint32_t missed = devices.timing.isr_period(now_us, kLoopPeriod_us);
  devices.lines.emergency_stop.isr_sample();
  devices.interlock.isr_apply(devices.timing.isr_in_time());
  devices.can.isr_receive();
  if (missed != 0) {
    app.isr_missed(missed);
  }
  return app.isr_sample();
}

}  // namespace boards::b_g431b_esc1
