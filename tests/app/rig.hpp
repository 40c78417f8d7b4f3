#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "firmware/app/app.hpp"
#include "hal/fake/can_port.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/devices.hpp"
#include "lifemodel/pack/pack.hpp"
#include "ram_store.hpp"
#include "wire.hpp"

namespace app {

inline constexpr protocol::Node kNode = 5;

/// The application over fakes at 1 kHz, with a listener on its bus. Everything but the application
/// itself outlives a restart.
template <std::size_t kTendons = 1, class SampleT = lifemodel::Tension>
class Rig {
 public:
  using Sensor = hal::fake::Sensor<SampleT, kTendons>;
  using Devices =
      app::Devices<hal::fake::CanPort, Sensor, hal::fake::Clock, RamStore, hal::fake::DigitalOut,
                   hal::fake::DigitalOut, hal::fake::DigitalOut, hal::fake::DigitalIn,
                   hal::fake::Watchdog, hal::fake::Entropy, hal::NoHold>;
  using App = app::App<kTendons, Devices>;

  explicit Rig(double ipl_scale = 1.53e5) {
    models.fill(lifemodel::ExtendedParameters{paper_parameters(ipl_scale), {}});
  }

  void start() {
    app = std::make_unique<App>(Devices{can, sensor, clock, store, drive_enable, brake, light, stop,
                                        watchdog, entropy, hold},
                                config, starting_models<kTendons>(store, models, evaluates));
    app->start();
  }

  /// One period of 1 ms with these tensions.
  void step(double tension_N) { step(SampleT{lifemodel::pack::tension(tension_N, 177.4)}); }
  void step(const SampleT& sample) {
    clock.advance(hal::milliseconds(1));
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      sensor.give(tendon, sample);
    }
    app->isr_sample();
    while (app->settle()) {
    }
    app->poll();
  }
  /// Cycles of 20 ms between these tensions.
  void run(std::uint32_t milliseconds, double low_N = 10, double high_N = 60) {
    for (std::uint32_t i = 0; i < milliseconds; ++i) {
      step(i / 10 % 2 == 0 ? low_N : high_N);
    }
  }
  /// Periods with an idle tendon.
  void idle(std::uint32_t milliseconds) { run(milliseconds, 10, 10); }

  /// All messages of a kind that have left.
  template <class Message>
  [[nodiscard]] std::vector<Message> sent() const {
    std::vector<Message> result;
    for (const hal::fake::CanEvent& event : bus.sent()) {
      if (event.sender == 0) {
        if (const auto message = protocol::decode<Message>(event.frame)) {
          result.push_back(*message);
        }
      }
    }
    return result;
  }

  hal::fake::Clock clock;
  hal::fake::CanBus bus{clock};
  hal::fake::CanPort can{bus};
  hal::fake::CanPort tester{bus};
  Sensor sensor{clock};
  RamStore store{clock};
  hal::fake::DigitalOut drive_enable{clock};
  hal::fake::DigitalOut brake{clock};
  hal::fake::DigitalOut light{clock};
  hal::fake::DigitalIn stop{clock};
  hal::fake::Watchdog watchdog{clock, hal::milliseconds(500)};
  hal::fake::Entropy entropy{clock, 1};
  hal::NoHold hold;
  Config config{.node = kNode};
  ConfiguredModels<kTendons> models;
  std::array<Evaluates, kTendons> evaluates{};
  std::unique_ptr<App> app;
};

}  // namespace app
