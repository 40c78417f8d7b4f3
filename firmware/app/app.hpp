#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "firmware/app/bus.hpp"
#include "firmware/app/config.hpp"
#include "firmware/app/devices.hpp"
#include "firmware/app/emergencies.hpp"
#include "firmware/app/intake.hpp"
#include "firmware/app/keeper.hpp"
#include "firmware/app/life_book.hpp"
#include "firmware/app/models.hpp"
#include "firmware/app/node.hpp"
#include "firmware/app/rainflow_bins.hpp"
#include "firmware/app/reporter.hpp"
#include "firmware/app/safety.hpp"
#include "firmware/app/speaker.hpp"
#include "firmware/app/status_light.hpp"
#include "firmware/protocol/uds/server.hpp"
#include "lifemodel/estimator.hpp"

namespace app {

/// The firmware of one actuator with `kTendons` tendons, the same on every board.
///
///   App app(devices, config, starting_models<1>(store, configured));
///   app.start();
///   // in the interrupt of the control loop:
///   const bool due = app.isr_sample();
///   // below it, where that is true, once for each tendon:
///   app.settle();
///   // in the idle loop, every few milliseconds at least:
///   app.poll();
///
/// isr_sample() may interrupt everything; settle() may interrupt poll() where Devices::hold keeps
/// it away from the readings. Nothing waits or allocates; each call is bounded.
template <std::size_t kTendons, class DevicesT, class LayoutT = lifemodel::DefaultLayout>
class App {
 public:
  using Devices = DevicesT;
  using Estimator = lifemodel::Estimator<kTendons, LayoutT>;

  /// How often the lives are read.
  static constexpr hal::Time kReadingPeriod = hal::milliseconds(100);

  App(const Devices& devices, const Config& config, const StartingModels<kTendons>& models)
      : devices_(devices),
        config_(config),
        parameters_(models.states),
        estimator_(estimated<typename Estimator::Model>(models.models)),
        keeper_(devices_.store),
        safety_(devices_),
        bus_(devices_.can),
        listener_(config.node),
        reporter_(book_, bins_, node_state_),
        speaker_(devices_.can, config.node),
        node_(devices_, config_, book_, keeper_, intake_, estimator_, parameters_),
        endpoint_(node_, config.node, config.key) {}
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Takes up the lives out of the store, and lets the drive go.
  void start() {
    const hal::Time now = devices_.clock.now();
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      resume(tendon);
    }
    book_.start(now);
    keeper_.start(now, book_.records());
    endpoint_.start(now);
    speaker_.start(now);
    light_.start(now);
    liveness_.start(now);
    next_reading_ = now;
    kept_state_ = book_.state();
    kept_flags_ = book_.flags();
    kept_broken_ = book_.broken();
    safety_.start();
  }

  /// One period of the control loop: reads all sensors. True where settle() is due, once for each
  /// tendon.
  bool isr_sample() { return intake_.isr_sample(devices_.sensor, estimator_); }
  /// The control loop left out `periods` periods.
  void isr_missed(std::uint32_t periods) {
    if constexpr (ExtendingSensor<typename Devices::Sensor>) {
      devices_.sensor.isr_missed();
    }
    intake_.isr_missed(periods, estimator_);
  }

  /// Counts cycles, in bounded time. True while there is more.
  bool settle() {
    return estimator_.settle([this](std::size_t tendon) { return BinCycles{&bins_[tendon]}; });
  }

  /// All that can wait: safety lines, bus, store, light and watchdog.
  void poll() {
    const hal::Time now = devices_.clock.now();
    safety_.check();
    watch_bus(now);
    listen(now);
    if (now >= next_reading_) {
      next_reading_ = now + kReadingPeriod;
      read_lives(now);
    }
    judge(now);
    keeper_.keep(now, book_.records(), state_changed());
    fill_node_state();
    speaker_.speak(now, reporter_, emergencies_, endpoint_);
    keeper_.prepare();
    show(now);
    if (safety_.obeyed() && liveness_.alive(now, intake_.periods())) {
      devices_.watchdog.feed();
    }
  }

  /// Figures of the control loop, for the timing page.
  void timing(const protocol::detail::Timing& timing) { node_state_.timing = timing; }

  /// The controller is going down: drive off, and the lives saved. Nothing may interrupt it.
  hal::Error stop() {
    safety_.stop();
    const hal::Time now = devices_.clock.now();
    read_lives(now);
    return keeper_.save(now, book_.records());
  }

  [[nodiscard]] const LifeBook<kTendons>& lives() const { return book_; }
  [[nodiscard]] const NodeState& node_state() const { return node_state_; }
  /// For a sensor whose samples are converted on the board.
  lifemodel::Flags& input_flags(std::size_t tendon) { return estimator_.input_flags(tendon); }

 private:
  using Code = protocol::EmergencyCode;

  void resume(std::size_t tendon) {
    const ParameterState& state = parameters_[tendon];
    std::optional<lifemodel::LifeDistribution> life;
    Outlook outlook;
    if (counts(tendon)) {
      life = estimator_.parameters(tendon).life;
      intake_.watch(tendon, estimator_.parameters(tendon));
      outlook = Outlook::of(estimator_.parameters(tendon));
    } else {
      intake_.leave_out(tendon);
    }
    book_.resume(tendon, devices_.store.load(tendon), devices_.store.past_lost(),
                 state.configuration, life, outlook);
    log_refusal(devices_.store, tendon, state, book_.records()[tendon].epoch);
    if constexpr (ExtendingSensor<typename Devices::Sensor>) {
      devices_.sensor.start_at(tendon, book_.records()[tendon].epoch_cycles);
    }
    node_state_.configuration =
        combined_configuration(node_state_.configuration, state.configuration);
  }

  /// Whether a tendon has parameters to be counted with.
  [[nodiscard]] bool counts(std::size_t tendon) const {
    return parameters_[tendon].source != ParameterSource::none;
  }
  /// Whether each tendon has those that it was given last.
  [[nodiscard]] bool parameters_ok() const {
    for (const ParameterState& state : parameters_) {
      if (state.source == ParameterSource::none || state.refusal.fault != ParameterFault::none) {
        return false;
      }
    }
    return true;
  }

  void watch_bus(hal::Time now) {
    switch (bus_.look(now)) {
      case BusWatch<typename Devices::Can>::Turn::none:
        return;
      case BusWatch<typename Devices::Can>::Turn::went_off:
        emergencies_.set(Code::bus, true);
        return;
      case BusWatch<typename Devices::Can>::Turn::came_back:
        // What was on its way when the bus went off may be lost.
        emergencies_.report_again();
        emergencies_.set(Code::bus, false);
        return;
    }
  }

  void listen(hal::Time now) {
    for (std::uint32_t i = 0; i < kFramesAPoll; ++i) {
      const auto frame = devices_.can.receive();
      if (!frame) {
        break;
      }
      if (const auto command = listener_.take(*frame)) {
        obey(now, *command);
      } else {
        endpoint_.on_frame(*frame, now);
      }
    }
    endpoint_.poll(now);
  }

  void obey(hal::Time now, const protocol::Command& command) {
    switch (command.code) {
      case protocol::CommandCode::identify:
        return light_.identify(now, command.argument);
      case protocol::CommandCode::select_page:
        return speaker_.select_page(command.argument);
      case protocol::CommandCode::burst:
        return speaker_.burst(command.argument);
    }
  }

  void read_lives(hal::Time now) {
    bool window_over = false;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      if (!counts(tendon)) {
        continue;
      }
      const bool new_wire = intake_.forgetting(tendon);
      lifemodel::WatchReading watched = intake_.watched(tendon);
      RainflowBins& bins = bins_[tendon];
      devices_.hold.hold();
      bins.begin_reading();
      lifemodel::Reading reading =
          estimator_.reading(tendon, BinReadCycles{&bins, true}, BinReadCycles{&bins, false});
      devices_.hold.release();
      if (new_wire) {
        // The next reading has those that count.
        reading.flags = {};
        watched.peak = 0;
        watched.window_peak = 0;
        watched.broken = false;
        watched.slack = false;
      }
      const storage::WireHistory before = book_.records()[tendon].history;
      window_over = book_.take(now, tendon, reading, watched,
                               estimator_.parameters(tendon).sample_period_us) ||
                    window_over;
      log_wire(tendon, before);
    }
    if (window_over) {
      intake_.begin_window();
    }
  }

  /// A line in the log for a wire that broke since `before`, and for the first time that it hangs
  /// loose.
  void log_wire(std::size_t tendon, const storage::WireHistory& before) {
    const storage::LifeRecord& record = book_.records()[tendon];
    const auto log = [&](storage::Event event) {
      constexpr std::uint64_t kHighest = std::numeric_limits<std::uint32_t>::max();
      (void)devices_.store.append(
          {.sequence = devices_.store.sequence(),
           .event = event,
           .tendon = static_cast<std::uint8_t>(tendon),
           .epoch = record.epoch,
           .detail = static_cast<std::uint32_t>(std::min(record.epoch_cycles, kHighest))});
    };
    if (before.slack_events == 0 && record.history.slack_events != 0) {
      log(storage::Event::tendon_slack);
    }
    if (!before.broken && record.history.broken) {
      log(storage::Event::tendon_broken);
    }
  }

  void judge(hal::Time now) {
    const protocol::LifeState state = book_.state();
    emergencies_.set(Code::life_inspect, state >= protocol::LifeState::inspect);
    emergencies_.set(Code::life_replace, state >= protocol::LifeState::replace);
    emergencies_.set(Code::life_worn, state >= protocol::LifeState::worn);
    emergencies_.set(Code::tendon_broken, book_.broken() != 0);
    emergencies_.set(Code::tendon_slack, book_.slack() != 0);
    emergencies_.set(Code::overload, book_.flags().has(lifemodel::Flag::overload));
    emergencies_.set(Code::emergency_stop, safety_.pulled());
    emergencies_.set(Code::record_damaged, !book_.whole());
    emergencies_.set(Code::sensor, !intake_.sensor_ok());
    emergencies_.set(Code::storage, !keeper_.ok());
    emergencies_.set(Code::deadline, liveness_.late(now, intake_.missed()));
    emergencies_.set(Code::parameters, !parameters_ok());
    emergencies_.set(Code::settings, !config_.whole);
    emergencies_.set(Code::authority, endpoint_.server().gate().locked(now));
  }

  /// True once after each change of what a restart has to know at once.
  bool state_changed() {
    const protocol::LifeState state = book_.state();
    const lifemodel::Flags flags = book_.flags();
    const std::uint32_t broken = book_.broken();
    const bool changed = state != kept_state_ || flags != kept_flags_ || broken != kept_broken_;
    kept_state_ = state;
    kept_flags_ = flags;
    kept_broken_ = broken;
    return changed;
  }

  void fill_node_state() {
    node_state_.trusted = book_.whole();
    node_state_.sensor_ok = intake_.sensor_ok();
    node_state_.storage_ok = keeper_.ok();
    node_state_.locked = safety_.locked();
    node_state_.sequence = devices_.store.sequence();
    node_state_.unsaved_ppb = keeper_.unsaved_ppb();
    node_state_.worst_unsaved_ppb = keeper_.worst_unsaved_ppb();
    node_state_.bus = bus_.status();
    node_state_.dropped = speaker_.dropped();
    node_state_.refused = refused();
  }

  /// Frames and commands; stops.
  [[nodiscard]] std::uint16_t refused() const {
    const std::uint64_t sum = std::uint64_t{listener_.refused()} + endpoint_.counts().malformed +
                              endpoint_.server().counts().refused;
    constexpr std::uint64_t kHighest = std::numeric_limits<std::uint16_t>::max();
    return static_cast<std::uint16_t>(sum < kHighest ? sum : kHighest);
  }

  void show(hal::Time now) {
    const bool at_fault = safety_.locked() || emergencies_.active(Code::tendon_broken) ||
                          emergencies_.active(Code::sensor) || emergencies_.active(Code::storage) ||
                          emergencies_.active(Code::parameters) ||
                          emergencies_.active(Code::record_damaged);
    const bool lit = light_.lit(now, book_.state(), at_fault);
    if (lit != lit_) {
      lit_ = lit;
      (void)devices_.status_light.set(lit);
    }
  }

  static constexpr std::uint32_t kFramesAPoll = 8;

  Devices devices_;
  Config config_;
  std::array<ParameterState, kTendons> parameters_;
  Estimator estimator_;
  typename Reporter<kTendons>::Bins bins_{};
  Intake<kTendons, LayoutT> intake_;
  LifeBook<kTendons> book_;
  NodeState node_state_;
  Emergencies emergencies_;
  Keeper<kTendons, typename Devices::Store> keeper_;
  Safety<Devices> safety_;
  BusWatch<typename Devices::Can> bus_;
  Listener listener_;
  Reporter<kTendons> reporter_;
  Speaker<typename Devices::Can> speaker_;
  Node<kTendons, Devices, LayoutT> node_;
  protocol::uds::Endpoint<Node<kTendons, Devices, LayoutT>> endpoint_;
  StatusLight light_;
  Liveness liveness_;
  hal::Time next_reading_{};
  protocol::LifeState kept_state_ = protocol::LifeState::unknown;
  lifemodel::Flags kept_flags_;
  std::uint32_t kept_broken_ = 0;
  bool lit_ = false;
};

}  // namespace app
