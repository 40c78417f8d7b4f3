#include "firmware/boards/linux/controller.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <latch>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "firmware/app/wired.hpp"
#include "firmware/boards/interlock.hpp"
#include "firmware/boards/linux/config.hpp"
#include "firmware/boards/linux/devices.hpp"
#include "firmware/boards/linux/sensors.hpp"
#include "firmware/storage/file_store.hpp"
#include "hal/linux/device_error.hpp"
#include "hal/linux/entropy.hpp"
#include "hal/linux/loop.hpp"
#include "hal/linux/service_manager.hpp"

namespace boards::linux_controller {
namespace {

/// Opens the store of a configuration, and warns of files that were found damaged. Throws
/// std::runtime_error with one line: path, what is wrong, what is accepted.
template <std::size_t kTendons>
storage::FileStore<kTendons> open_store(const std::filesystem::path& folder) {
  auto store = storage::FileStore<kTendons>::open(folder.string());
  if (const auto* const error = std::get_if<storage::FileError>(&store)) {
    throw std::runtime_error(to_string(*error));
  }
  auto& opened = std::get<storage::FileStore<kTendons>>(store);
  for (const storage::FileError& notice : opened.notices()) {
    std::cerr << "tendonlife_controller: WARNING: " << to_string(notice) << '\n';
  }
  return std::move(opened);
}

/// Prepares the process for a control loop in real time: a thread that is started while this is
/// incomplete runs under SCHED_FIFO.
class RealTimeSetup {
 public:
  /// Puts the calling thread under SCHED_FIFO, for the thread that it will start.
  explicit RealTimeSetup(const LoopConfig& loop) : wanted_(loop.real_time) {
    if (wanted_ != RealTime::off) {
      refused_ = hal::linux_os::schedule_fifo(loop.priority);
    }
  }

  /// Puts the calling thread back and locks the memory. Warns of what was refused; false where
  /// the configuration requires it.
  [[nodiscard]] bool complete() {
    if (wanted_ == RealTime::off) {
      return true;
    }
    hal::linux_os::schedule_normally();
    const std::string unlocked = hal::linux_os::lock_memory();
    refused_.append(refused_.empty() || unlocked.empty() ? "" : "; ").append(unlocked);
    if (!refused_.empty() && wanted_ == RealTime::prefer) {
      std::cerr << "tendonlife_controller: WARNING: no real time: " << refused_
                << "; deadlines may be missed, and are counted\n";
    }
    return refused_.empty() || wanted_ == RealTime::prefer;
  }
  /// Throws hal::linux_os::DeviceError where the configuration requires what was refused.
  void check() const {
    if (!refused_.empty() && wanted_ == RealTime::require) {
      throw hal::linux_os::DeviceError("real time", refused_,
                                       "these rights, or real_time \"prefer\" in [loop]");
    }
  }

 private:
  RealTime wanted_;
  std::string refused_;
};

/// The devices of this machine around a sensor.
template <class SensorT>
struct Hardware {
  /// So many periods in time, one after the other, let the drive go.
  static constexpr std::uint32_t kPeriodsInTime = 10;
  using Lock = Interlock<SafetyLines, kPeriodsInTime>;

  /// Throws hal::linux_os::DeviceError, or hal::files::OutputError.
  Hardware(const Setup& setup, SensorT& samples)
      : sensor(samples),
        clock(setup.virtual_clock),
        can(setup.config.can, setup.config.node, clock, others_of(setup.config),
            [this](const hal::CanFrame& frame) { hear(frame); }),
        lines(setup.config.gpio),
        status_light(setup.config.gpio, &GpioConfig::status_light),
        watchdog(setup.config.gpio, manager) {}
  Hardware(const Hardware&) = delete;
  Hardware& operator=(const Hardware&) = delete;

  SensorT& sensor;
  BoardClock clock;
  BoardCan can;
  SafetyLines lines;
  Lock interlock{lines};
  Lock::Drive drive_enable{interlock};
  Lock::Brake brake{interlock};
  Lock::Stop emergency_stop{interlock};
  OptionalOutput status_light;
  hal::linux_os::ServiceManager manager;
  Watchdog watchdog;
  hal::linux_os::KernelEntropy entropy;
  SettleTurn hold;

 private:
  static std::vector<hal::linux_os::CanFilter> others_of(const Config& config) {
    return config.can.interface == kNoBus ? std::vector<hal::linux_os::CanFilter>{}
                                          : filters_of(config);
  }

  void hear(const hal::CanFrame& frame) {
    if constexpr (requires { sensor.take(frame, clock.now()); }) {
      sensor.take(frame, clock.now());
    }
  }
};

/// The application on this machine.
///
/// Two threads. The control loop, at real-time priority, reads the sensors and the emergency stop
/// and settles; it never waits for the other. The rest, at ordinary priority, may wait for a disk.
template <std::size_t kTendons, class SensorT, template <class, std::size_t> class SensingT>
class Controller {
 public:
  /// Throws std::runtime_error, its what() one line: hal::linux_os::DeviceError where a device
  /// cannot be used, hal::files::InputError or OutputError where a file cannot.
  Controller(const Setup& setup, SensorT& sensor)
      : setup_(setup),
        hardware_(setup, sensor),
        store_(open_store<kTendons>(setup.config.store)),
        wired_(hardware_, store_, setup.node, first<std::optional>(setup.models),
               first<std::type_identity_t>(setup.evaluates)) {}

  /// Runs until `stop` is set or the profile is at its end.
  Report run(const std::atomic<bool>& stop) {
    warn_of_parameters();
    hardware_.interlock.isr_apply(false);
    wired_.app().start();
    if (setup_.virtual_clock) {
      run_virtually(stop);
    } else {
      run_in_real_time(stop);
    }
    const hal::Error locked = hardware_.interlock.lock();
    report_the_end();
    Report report = report_of(wired_.app().stop());
    if (report.saved == hal::Error::none) {
      report.saved = locked;
    }
    hardware_.can.finish();
    return report;
  }

 private:
  using Store = storage::FileStore<kTendons>;

  static constexpr hal::Time kPollPeriod = hal::milliseconds(1);
  static constexpr hal::Time kTimingPeriod = hal::milliseconds(100);
  /// So long every frame of the last state needs to leave.
  static constexpr hal::Time kReporting = hal::milliseconds(250);

  /// Those of the tendons that there are.
  template <template <class> class Held, class Value>
  static std::array<Held<Value>, kTendons> first(const std::vector<Value>& values) {
    std::array<Held<Value>, kTendons> result;
    std::copy_n(values.begin(), kTendons, result.begin());
    return result;
  }

  void warn_of_parameters() const {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      const app::ParameterState& state = wired_.models().states[tendon];
      if (state.refusal.fault != app::ParameterFault::none) {
        std::cerr << "tendonlife_controller: WARNING: the parameters that were loaded for tendon "
                  << tendon << " are refused: " << to_string(state.refusal.fault)
                  << "; it counts with those of the configuration\n";
      }
    }
  }

  [[nodiscard]] bool at_end() const {
    if constexpr (requires { hardware_.sensor.at_end(); }) {
      return hardware_.sensor.at_end();
    }
    return false;
  }

  // One period of the control loop. False at the end of a profile.
  bool isr_period(std::uint32_t missed) {
    hardware_.interlock.isr_apply(missed == 0);
    if (missed != 0) {
      wired_.app().isr_missed(missed);
    }
    if (wired_.app().isr_sample()) {
      hardware_.hold.isr_settle(kTendons, [this] { return wired_.app().settle(); });
    }
    periods_.store(periods_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    return !at_end();
  }

  void run_virtually(const std::atomic<bool>& stop) {
    const hal::Time period = hal::microseconds(setup_.config.loop.period_us);
    hal::Time sample{};
    for (bool more = true; more && !stop;) {
      sample = sample + period;
      poll_until(sample, false);
      hardware_.clock.advance_to(sample);
      more = isr_period(0);
      poll_until(sample, true);
    }
  }

  // Polls that are due before `time`, and the one at it where `included`.
  void poll_until(hal::Time time, bool included) {
    while (next_poll_ < time || (included && next_poll_ == time)) {
      hardware_.clock.advance_to(next_poll_);
      wired_.app().poll();
      next_poll_ = next_poll_ + kPollPeriod;
    }
    hardware_.clock.advance_to(time);
  }

  void run_in_real_time(const std::atomic<bool>& stop) {
    std::atomic<bool> end{false};
    std::latch go{1};
    RealTimeSetup real_time(setup_.config.loop);
    std::thread loop([&] {
      go.wait();
      hal::linux_os::WaitingClock clock;
      hal::linux_os::run_periodic(clock, std::int64_t{setup_.config.loop.period_us} * 1'000,
                                  jitter_, end,
                                  [this](std::uint32_t missed) { return isr_period(missed); });
      end = true;
    });
    const bool ready = real_time.complete();
    end = !ready;
    go.count_down();
    if (ready) {
      hardware_.manager.ready("controlling");
    }
    while (!end && !stop) {
      poll_once();
    }
    end = true;
    loop.join();
    hardware_.manager.stopping();
    real_time.check();
  }

  void poll_once() {
    const hal::Time now = hardware_.clock.now();
    if (now >= next_timing_) {
      next_timing_ = now + kTimingPeriod;
      wired_.app().timing(timing());
    }
    if constexpr (requires { hardware_.sensor.poll(now); }) {
      hardware_.sensor.poll(now);
    }
    wired_.app().poll();
    std::this_thread::sleep_for(std::chrono::microseconds(kPollPeriod.us));
  }

  [[nodiscard]] protocol::detail::Timing timing() const {
    const auto stopped = [](std::uint64_t value) {
      return static_cast<std::uint16_t>(value < 0xffff ? value : 0xffff);
    };
    return {stopped(jitter_.worst_us()), stopped(jitter_.quantile_us(990)),
            stopped(jitter_.missed())};
  }

  // At the end of a profile the bus still hears of its last life.
  void report_the_end() {
    if (!at_end()) {
      return;
    }
    const hal::Time last = hardware_.clock.now() + kReporting;
    if (setup_.virtual_clock) {
      poll_until(last, true);
      return;
    }
    while (hardware_.clock.now() < last) {
      poll_once();
    }
  }

  Report report_of(hal::Error saved) const {
    const auto& records = wired_.app().lives().records();
    Report report;
    report.node = setup_.config.node;
    report.periods = periods_;
    report.missed_deadlines = jitter_.missed();
    report.p99_jitter_us = jitter_.quantile_us(990);
    report.worst_jitter_us = jitter_.worst_us();
    report.lives.assign(records.begin(), records.end());
    report.saved = saved;
    report.sequence = store_.sequence();
    if (store_.problem()) {
      report.store_problem = to_string(*store_.problem());
    }
    report.worst_unsaved_ppb = wired_.app().node_state().worst_unsaved_ppb;
    report.bus = hardware_.can.status();
    if (const auto* const counts = hardware_.can.counts()) {
      report.counts = *counts;
    }
    return report;
  }

  const Setup& setup_;
  Hardware<SensorT> hardware_;
  Store store_;
  app::Wired<kTendons, Hardware<SensorT>, Store, SensingT> wired_;
  hal::linux_os::Jitter jitter_;
  std::atomic<std::uint64_t> periods_{0};
  hal::Time next_poll_ = kPollPeriod;
  hal::Time next_timing_{};
};

template <std::size_t kTendons>
Report run_tendons(const Setup& setup, const std::atomic<bool>& stop) {
  using lifemodel::extension::Input;
  const auto nominal = [&](auto&& sensor) {
    return Controller<kTendons, std::remove_reference_t<decltype(sensor)>, app::NominalSensing>(
               setup, sensor)
        .run(stop);
  };
  const auto extended = [&](auto&& sensor) {
    return Controller<kTendons, std::remove_reference_t<decltype(sensor)>, app::ExtendedSensing>(
               setup, sensor)
        .run(stop);
  };
  const bool played = setup.config.sensor.kind == SensorKind::profile;
  switch (input_of(setup.config)) {
    case Input::motor_current:
      return played ? extended(profile_sensor<lifemodel::extension::DriveSample>(setup))
                    : extended(DriveSensor(setup));
    case Input::input_tension:
      return extended(profile_sensor<lifemodel::Tension>(setup));
    case Input::output_tension:
      break;
  }
  return setup.extended() ? extended(profile_sensor<lifemodel::extension::SheathSample>(setup))
                          : nominal(profile_sensor<app::OutputTension>(setup));
}

}  // namespace

Report run(const Setup& setup, const std::atomic<bool>& stop) {
  switch (setup.config.tendons.size()) {
    case 1:
      return run_tendons<1>(setup, stop);
    case 2:
      return run_tendons<2>(setup, stop);
    case 3:
      return run_tendons<3>(setup, stop);
    default:
      return run_tendons<4>(setup, stop);
  }
}

}  // namespace boards::linux_controller
