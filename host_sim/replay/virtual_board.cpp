#include "host_sim/replay/virtual_board.hpp"

#include <array>
#include <type_traits>
#include <utility>

#include "firmware/app/app.hpp"
#include "firmware/app/extended_sensor.hpp"
#include "firmware/storage/flash_store.hpp"
#include "hal/devices.hpp"
#include "hal/fake/can_port.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/devices.hpp"
#include "hal/fake/flash.hpp"
#include "lifemodel/extension/life.hpp"

namespace host_sim {

using hal::files::InputKind;

namespace {

namespace fake = hal::fake;

constexpr hal::Time kPollPeriod = hal::milliseconds(1);
/// By then the lives have been read once more.
constexpr hal::Time kReading = hal::milliseconds(101);
/// By then they are reported, unless the bus budget is a long way behind.
constexpr hal::Time kTelling = hal::seconds(2);

}  // namespace

namespace {

/// The sensor of a nominal model.
template <class SampleT>
class Plain {
 public:
  using Sample = SampleT;
  using Sensor = fake::Sensor<Sample>;

  Plain(const fake::Clock& clock, const lifemodel::ExtendedParameters&) : sensor_(clock) {}
  fake::Sensor<Sample>& given() { return sensor_; }
  Sensor& seen() { return sensor_; }
  void start_at(std::uint32_t) {}

 private:
  fake::Sensor<Sample> sensor_;
};

/// The sensor of an extended one.
template <class SampleT>
class Extending {
 public:
  using Sample = SampleT;
  using Sensor = app::ExtendedSensor<fake::Sensor<Sample>, 1>;

  Extending(const fake::Clock& clock, const lifemodel::ExtendedParameters& parameters)
      : models_{parameters}, given_(clock), seen_(given_, models_) {}
  Extending(const Extending&) = delete;
  Extending& operator=(const Extending&) = delete;
  fake::Sensor<Sample>& given() { return given_; }
  Sensor& seen() { return seen_; }
  void start_at(std::uint32_t cycle) { seen_.start_at(0, cycle); }

 private:
  typename Sensor::Models models_;
  fake::Sensor<Sample> given_;
  Sensor seen_;
};

using Nominal = lifemodel::DefaultLayout;
using Extended = lifemodel::extension::ExtendedLife<Nominal>;

/// The one model, which is known to be evaluated.
app::StartingModels<1> starting(const lifemodel::ExtendedParameters& parameters) {
  app::StartingModels<1> models;
  models.models[0] = parameters;
  models.states[0] = {.source = app::ParameterSource::configured,
                      .configuration = app::configuration_of(parameters)};
  return models;
}

}  // namespace

class VirtualBoard::Firmware {
 public:
  Firmware() = default;
  Firmware(const Firmware&) = delete;
  Firmware& operator=(const Firmware&) = delete;
  virtual ~Firmware() = default;

  virtual void take(hal::Time time, std::uint32_t missing, const BoardSample& sample,
                    lifemodel::Flags flags) = 0;
  virtual lifemodel::Damage finish() = 0;
};

template <class Sensing, class Layout>
class VirtualBoard::FirmwareFor final : public VirtualBoard::Firmware {
 public:
  FirmwareFor(const lifemodel::ExtendedParameters& parameters, std::uint32_t start_cycle,
              protocol::Node node, Listener listener)
      : tap_{std::move(listener), protocol::id_of<protocol::LifeStatus>(node)},
        sensing_(clock_, parameters),
        app_({can_, sensing_.seen(), clock_, store_, drive_enable_, brake_, status_light_,
              emergency_stop_, watchdog_, entropy_, hold_},
             {.node = node}, starting(parameters)) {
    app_.start();
    sensing_.start_at(start_cycle);
  }

  void take(hal::Time time, std::uint32_t missing, const BoardSample& sample,
            lifemodel::Flags flags) override {
    pass_until(time);
    if (missing != 0) {
      app_.isr_missed(missing);
    }
    lifemodel::Flags& raised = app_.input_flags(0);
    raised = raised | flags;
    sensing_.given().give(0, std::get<typename Sensing::Sample>(sample));
    app_.isr_sample();
    while (app_.settle()) {
    }
    if (next_poll_ <= time) {
      poll();
    }
  }

  lifemodel::Damage finish() override {
    pass_until(clock_.now() + kReading);
    const std::uint64_t reported = tap_.statuses;
    for (const hal::Time end = clock_.now() + kTelling;
         tap_.statuses == reported && next_poll_ < end;) {
      pass_until(next_poll_ + kPollPeriod);
    }
    static_cast<void>(app_.stop());
    return app_.lives().damage(0);
  }

 private:
  struct Tap {
    Listener listener;
    std::uint32_t status_id;
    std::uint64_t statuses = 0;

    void operator()(hal::Time time, const hal::CanFrame& frame) {
      statuses += frame.id == status_id ? 1 : 0;
      listener(time, frame);
    }
  };

  using Can = fake::CanListener<Tap>;
  using Sensor = typename Sensing::Sensor;
  using Store = storage::FlashStore<fake::Flash<>, 1>;
  using Devices =
      app::Devices<Can, Sensor, fake::Clock, Store, fake::DigitalOut, fake::DigitalOut,
                   fake::DigitalOut, fake::DigitalIn, fake::Watchdog, fake::Entropy, hal::NoHold>;

  /// What falls on `time` itself is left for after the sample.
  void pass_until(hal::Time time) {
    while (next_poll_ < time) {
      clock_.advance_to(next_poll_);
      poll();
    }
    clock_.advance_to(time);
  }

  void poll() {
    app_.poll();
    next_poll_ = next_poll_ + kPollPeriod;
  }

  Tap tap_;
  fake::Clock clock_;
  Can can_{clock_, tap_};
  Sensing sensing_;
  fake::Flash<> flash_;
  Store store_{flash_};
  fake::DigitalOut drive_enable_{clock_};
  fake::DigitalOut brake_{clock_};
  fake::DigitalOut status_light_{clock_};
  fake::DigitalIn emergency_stop_{clock_};
  fake::Watchdog watchdog_{clock_, hal::milliseconds(500)};
  fake::Entropy entropy_{clock_, 1};
  hal::NoHold hold_;
  app::App<1, Devices, Layout> app_;
  hal::Time next_poll_{};
};

VirtualBoard::VirtualBoard(InputKind kind, const lifemodel::ExtendedParameters& parameters,
                           std::uint32_t start_cycle, protocol::Node node, Listener listener) {
  const auto run = [&]<class Sensing, class Layout>() {
    firmware_ = std::make_unique<FirmwareFor<Sensing, Layout>>(parameters, start_cycle, node,
                                                               std::move(listener));
  };
  const bool extended = parameters.extension.effects != 0;
  switch (kind) {
    case InputKind::kInputTension:
      extended ? run.template operator()<Plain<lifemodel::Tension>, Extended>()
               : run.template operator()<Plain<lifemodel::Tension>, Nominal>();
      return;
    case InputKind::kMotorCurrent:
      extended ? run.template operator()<Extending<lifemodel::extension::DriveSample>, Extended>()
               : run.template operator()<Plain<lifemodel::MotorCurrent>, Nominal>();
      return;
    case InputKind::kOutputTension:
      extended ? run.template operator()<Extending<lifemodel::extension::SheathSample>, Extended>()
               : run.template operator()<Plain<app::OutputTension>, Nominal>();
      return;
  }
}

VirtualBoard::VirtualBoard(VirtualBoard&&) noexcept = default;
VirtualBoard& VirtualBoard::operator=(VirtualBoard&&) noexcept = default;
VirtualBoard::~VirtualBoard() = default;

void VirtualBoard::take(hal::Time time, std::uint32_t missing, const BoardSample& sample,
                        lifemodel::Flags flags) {
  firmware_->take(time, missing, sample, flags);
}

lifemodel::Damage VirtualBoard::finish() {
  return firmware_->finish();
}

}  // namespace host_sim
