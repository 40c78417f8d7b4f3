#include "host_sim/replay/virtual_board.hpp"

#include <utility>

#include "firmware/app/app.hpp"
#include "firmware/storage/flash_store.hpp"
#include "hal/fake/can_listener.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/digital.hpp"
#include "hal/fake/entropy.hpp"
#include "hal/fake/flash.hpp"
#include "hal/fake/sensor.hpp"
#include "hal/fake/watchdog.hpp"
#include "hal/hold.hpp"

namespace host_sim {
namespace {

namespace fake = hal::fake;

constexpr hal::Time kPollPeriod = hal::milliseconds(1);
/// By then the lives have been read once more.
constexpr hal::Time kReading = hal::milliseconds(101);
/// By then they have been told, unless the bus budget is a long way behind.
constexpr hal::Time kTelling = hal::seconds(2);

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

template <class Sample>
class VirtualBoard::FirmwareFor final : public VirtualBoard::Firmware {
 public:
  FirmwareFor(const lifemodel::Parameters& parameters, protocol::Node node, Listener listener)
      : tap_{std::move(listener), protocol::id_of<protocol::LifeStatus>(node)},
        app_({can_, sensor_, clock_, store_, drive_enable_, brake_, status_light_, emergency_stop_,
              watchdog_, entropy_, hold_},
             {.node = node}, {parameters}) {
    app_.start();
  }

  void take(hal::Time time, std::uint32_t missing, const BoardSample& sample,
            lifemodel::Flags flags) override {
    pass_until(time);
    if (missing != 0) {
      app_.isr_missed(missing);
    }
    lifemodel::Flags& raised = app_.input_flags(0);
    raised = raised | flags;
    sensor_.give(0, std::get<Sample>(sample));
    app_.isr_sample();
    while (app_.settle()) {
    }
    if (next_poll_ <= time) {
      poll();
    }
  }

  lifemodel::Damage finish() override {
    pass_until(clock_.now() + kReading);
    const std::uint64_t told = tap_.statuses;
    for (const hal::Time end = clock_.now() + kTelling;
         tap_.statuses == told && next_poll_ < end;) {
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
  using Sensor = fake::Sensor<Sample>;
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
  Sensor sensor_{clock_};
  fake::Flash<> flash_;
  Store store_{flash_};
  fake::DigitalOut drive_enable_{clock_};
  fake::DigitalOut brake_{clock_};
  fake::DigitalOut status_light_{clock_};
  fake::DigitalIn emergency_stop_{clock_};
  fake::Watchdog watchdog_{clock_, hal::milliseconds(500)};
  fake::Entropy entropy_{clock_, 1};
  hal::NoHold hold_;
  app::App<1, Devices> app_;
  hal::Time next_poll_{};
};

VirtualBoard::VirtualBoard(InputKind kind, const lifemodel::Parameters& parameters,
                           protocol::Node node, Listener listener) {
  switch (kind) {
    case InputKind::kInputTension:
      firmware_ =
          std::make_unique<FirmwareFor<lifemodel::Tension>>(parameters, node, std::move(listener));
      return;
    case InputKind::kMotorCurrent:
      firmware_ = std::make_unique<FirmwareFor<lifemodel::MotorCurrent>>(parameters, node,
                                                                         std::move(listener));
      return;
    case InputKind::kOutputTension:
      firmware_ =
          std::make_unique<FirmwareFor<app::OutputTension>>(parameters, node, std::move(listener));
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
