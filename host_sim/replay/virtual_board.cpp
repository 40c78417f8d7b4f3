#include "host_sim/replay/virtual_board.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <variant>

#include "firmware/app/wired.hpp"
#include "firmware/storage/flash_store.hpp"
#include "hal/devices.hpp"
#include "hal/fake/can_port.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/devices.hpp"
#include "hal/fake/flash.hpp"
#include "lifemodel/extension/needs.hpp"
#include "lifemodel/extension/sample.hpp"

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

/// Devices that do what they are told, and a sensor of one kind of samples.
template <class CanT, class SampleT>
struct FakeDevices {
  template <class Tap>
  explicit FakeDevices(Tap& tap) : can(clock, tap) {}

  fake::Clock clock;
  CanT can;
  fake::Sensor<SampleT> sensor{clock};
  fake::DigitalOut drive_enable{clock};
  fake::DigitalOut brake{clock};
  fake::DigitalOut status_light{clock};
  fake::DigitalIn emergency_stop{clock};
  fake::Watchdog watchdog{clock, hal::milliseconds(500)};
  fake::Entropy entropy{clock, 1};
  hal::NoHold hold;
};

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

template <class SampleT, template <class, std::size_t> class SensingT>
class VirtualBoard::FirmwareFor final : public VirtualBoard::Firmware {
 public:
  /// The model is known to be evaluated.
  FirmwareFor(lifemodel::extension::Input input, const lifemodel::ExtendedParameters& parameters,
              std::uint32_t start_cycle, protocol::Node node, Listener listener)
      : tap_{std::move(listener), protocol::id_of<protocol::LifeStatus>(node)},
        wired_(board_, store_, {.node = node}, {parameters},
               {app::Evaluates{true, input, {true, true, true, true}}}) {
    app_.start();
    if constexpr (requires { wired_.sensor().start_at(0, start_cycle); }) {
      wired_.sensor().start_at(0, start_cycle);
    }
  }

  void take(hal::Time time, std::uint32_t missing, const BoardSample& sample,
            lifemodel::Flags flags) override {
    pass_until(time);
    if (missing != 0) {
      app_.isr_missed(missing);
    }
    lifemodel::Flags& raised = app_.input_flags(0);
    raised = raised | flags;
    board_.sensor.give(0, std::get<SampleT>(sample));
    app_.isr_sample();
    while (app_.settle()) {
    }
    if (next_poll_ <= time) {
      poll();
    }
  }

  lifemodel::Damage finish() override {
    pass_until(board_.clock.now() + kReading);
    const std::uint64_t reported = tap_.statuses;
    for (const hal::Time end = board_.clock.now() + kTelling;
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
  using Board = FakeDevices<Can, SampleT>;
  using Store = storage::FlashStore<fake::Flash<>, 1>;
  using Wired = app::Wired<1, Board, Store, SensingT>;

  /// What falls on `time` itself is left for after the sample.
  void pass_until(hal::Time time) {
    while (next_poll_ < time) {
      board_.clock.advance_to(next_poll_);
      poll();
    }
    board_.clock.advance_to(time);
  }

  void poll() {
    app_.poll();
    next_poll_ = next_poll_ + kPollPeriod;
  }

  Tap tap_;
  Board board_{tap_};
  fake::Flash<> flash_;
  Store store_{flash_};
  Wired wired_;
  typename Wired::App& app_ = wired_.app();
  hal::Time next_poll_{};
};

VirtualBoard::VirtualBoard(InputKind kind, const lifemodel::ExtendedParameters& parameters,
                           std::uint32_t start_cycle, protocol::Node node, Listener listener) {
  using lifemodel::extension::Input;
  const auto run = [&]<class Sample, template <class, std::size_t> class Sensing>(Input input) {
    firmware_ = std::make_unique<FirmwareFor<Sample, Sensing>>(input, parameters, start_cycle, node,
                                                               std::move(listener));
  };
  const bool extended = parameters.extension.effects != 0;
  using app::ExtendedSensing;
  using app::Moving;
  using app::NominalSensing;
  using lifemodel::Tension;
  using lifemodel::extension::DriveSample;
  using lifemodel::extension::SheathSample;
  switch (kind) {
    case InputKind::kInputTension:
      extended ? run.template operator()<Moving<Tension>, ExtendedSensing>(Input::input_tension)
               : run.template operator()<Moving<Tension>, NominalSensing>(Input::input_tension);
      return;
    case InputKind::kMotorCurrent:
      extended ? run.template operator()<DriveSample, ExtendedSensing>(Input::motor_current)
               : run.template operator()<Moving<lifemodel::MotorCurrent>, NominalSensing>(
                     Input::motor_current);
      return;
    case InputKind::kOutputTension:
      extended ? run.template operator()<SheathSample, ExtendedSensing>(Input::output_tension)
               : run.template operator()<app::OutputTension, NominalSensing>(Input::output_tension);
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
