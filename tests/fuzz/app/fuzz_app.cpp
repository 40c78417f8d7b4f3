#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>

#include "firmware/app/app.hpp"
#include "firmware/protocol/isotp/link.hpp"
#include "firmware/storage/flash_store.hpp"
#include "hal/fake/can_port.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/devices.hpp"
#include "hal/fake/flash.hpp"
#include "tests/app/wire.hpp"

namespace app::fuzz {
namespace {

/// The bytes of one input, one after another; zeros past the end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  [[nodiscard]] bool empty() const { return left_.empty(); }
  std::uint8_t byte() {
    if (left_.empty()) {
      return 0;
    }
    const std::uint8_t first = left_.front();
    left_ = left_.subspan(1);
    return first;
  }
  std::uint32_t word() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) {
      value = value << 8 | byte();
    }
    return value;
  }
  void fill(std::span<std::byte> out) {
    for (std::byte& one : out) {
      one = std::byte{byte()};
    }
  }

 private:
  std::span<const std::uint8_t> left_;
};

/// Ends the process, which the fuzzer reports with its input, unless `holds`.
void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

constexpr protocol::Node kNode = 5;

/// A node at work, and somebody on its bus without the key. Whatever is said there, the node stays
/// alive, its life is that of its samples, and nothing that needs authority happens.
class Node {
 public:
  Node()
      : parameters_(paper_parameters()),
        beside_({parameters_}),
        app_({can_, sensor_, clock_, store_, drive_enable_, brake_, light_, stop_, watchdog_,
              entropy_, hold_},
             config(),
             starting_models<1>(store_, {lifemodel::ExtendedParameters{parameters_, {}}})) {
    app_.start();
    configuration_ = app_.lives().records()[0].configuration;
  }

  void hear(const hal::CanFrame& frame) { (void)stranger_.send(frame); }
  /// The same with the counter and CRC of a command that is meant.
  void hear_command(const protocol::Command& command) {
    hal::CanFrame frame = protocol::encode(kNode, command);
    protector_.protect(frame);
    hear(frame);
  }
  /// A request by all the rules of ISO-TP.
  void hear_request(std::span<const std::byte> request) { (void)tester_.send(request); }

  void pass_ms(std::uint32_t time_ms, std::int32_t tension_raw) {
    for (std::uint32_t i = 0; i < time_ms; ++i) {
      clock_.advance(hal::milliseconds(1));
      if (const auto frame = tester_.next_frame(clock_.now())) {
        hear(*frame);
      }
      const auto tension = lifemodel::Tension::from_raw(i % 2 == 0 ? tension_raw : tension_raw / 2);
      sensor_.give(0, tension);
      beside_.push(0, tension);
      app_.isr_sample();
      while (app_.settle()) {
      }
      while (beside_.settle()) {
      }
      app_.poll();
      while (const auto frame = stranger_.receive()) {
        tester_.on_frame(*frame, clock_.now());
      }
      tester_.clear();
      bus_.forget();
      check();
    }
  }

  /// Saves, and starts again from what was saved.
  void finish() {
    require(app_.stop() == hal::Error::none);
    const lifemodel::Damage damage = beside_.reading(0).total;
    require(app_.lives().damage(0) == damage);
    Store again(flash_);
    const auto record = again.load(0);
    require(record && record->lifetime_damage == damage && record->epoch_damage == damage);
    require(record->epoch == 0 && record->configuration == configuration_);
    require(!again.past_lost() && !again.load_parameters(0));
  }

 private:
  using Can = hal::fake::CanPort;
  using Sensor = hal::fake::Sensor<lifemodel::Tension>;
  using Flash = hal::fake::Flash<>;
  using Store = storage::FlashStore<Flash, 1>;
  using Devices = app::Devices<Can, Sensor, hal::fake::Clock, Store, hal::fake::DigitalOut,
                               hal::fake::DigitalOut, hal::fake::DigitalOut, hal::fake::DigitalIn,
                               hal::fake::Watchdog, hal::fake::Entropy, hal::NoHold>;

  static Config config() {
    Config config{.node = kNode};
    config.key.fill(std::byte{0x5a});
    return config;
  }

  void check() {
    const storage::LifeRecord& life = app_.lives().records()[0];
    require(life.lifetime_damage >= last_.lifetime_damage);
    require(life.epoch_damage == life.lifetime_damage && life.epoch == 0);
    require(life.epoch_cycles >= last_.epoch_cycles);
    require(life.configuration == configuration_);
    last_ = life;
    require(store_.sequence() >= sequence_);
    sequence_ = store_.sequence();
    require(app_.node_state().refused >= refused_);
    refused_ = app_.node_state().refused;
    require(app_.node_state().storage_ok && app_.node_state().trusted);
    require(drive_enable_.asserted() && !brake_.asserted() && !watchdog_.bitten());
  }

  hal::fake::Clock clock_;
  hal::fake::CanBus bus_{clock_};
  Can can_{bus_};
  Can stranger_{bus_};
  Sensor sensor_{clock_};
  Flash flash_;
  Store store_{flash_};
  hal::fake::DigitalOut drive_enable_{clock_};
  hal::fake::DigitalOut brake_{clock_};
  hal::fake::DigitalOut light_{clock_};
  hal::fake::DigitalIn stop_{clock_};
  hal::fake::Watchdog watchdog_{clock_, hal::milliseconds(100)};
  hal::fake::Entropy entropy_{clock_, 1};
  hal::NoHold hold_;
  lifemodel::Parameters parameters_;
  lifemodel::Estimator<1> beside_;
  app::App<1, Devices> app_;

  protocol::e2e::Protector protector_{protocol::e2e::stream_of<protocol::Command>(kNode)};
  protocol::isotp::Link<protocol::uds::kMostMessageBytes> tester_{
      protocol::isotp::Address::to_node(kNode)};
  storage::LifeRecord last_;
  std::uint32_t configuration_ = 0;
  std::uint32_t sequence_ = 0;
  std::uint32_t refused_ = 0;
};

hal::CanFrame frame(Input& in, std::uint32_t id, bool extended) {
  hal::CanFrame result{.id = id, .extended = extended, .length = 0, .data = {}};
  result.length = static_cast<std::uint8_t>(std::min(int{in.byte()}, 8));
  in.fill(std::span(result.data).first(result.length));
  return result;
}

/// One thing that happens on the bus, as the first byte says, or some time that passes.
void happen(Input& in, Node& node, std::uint32_t& left_ms) {
  switch (in.byte() % 6) {
    case 0:
      return node.hear(frame(in, 0x200u + kNode, false));
    case 1:
      return node.hear(frame(in, 0x18da'00f1u + (std::uint32_t{kNode} << 8), true));
    case 2: {
      const bool extended = in.byte() % 2 != 0;
      const std::uint32_t id = in.word() & (extended ? 0x1fff'ffffu : 0x7ffu);
      return node.hear(frame(in, id, extended));
    }
    case 3: {
      const auto code = static_cast<protocol::CommandCode>(in.byte());
      return node.hear_command({code, in.byte()});
    }
    case 4: {
      std::array<std::byte, protocol::uds::kMostMessageBytes> request{};
      const std::size_t size = 1 + in.byte() % request.size();
      in.fill(std::span(request).first(size));
      return node.hear_request(std::span(request).first(size));
    }
    default: {
      const std::uint32_t time_ms = std::min(1u + in.byte(), left_ms);
      left_ms -= time_ms;
      return node.pass_ms(time_ms, static_cast<std::int32_t>(in.byte()) << 22);
    }
  }
}

}  // namespace
}  // namespace app::fuzz

/// A node hears what the input says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::uint32_t left_ms = 3'000;
  app::fuzz::Input in(data, size);
  const auto node = std::make_unique<app::fuzz::Node>();
  while (!in.empty() && left_ms != 0) {
    app::fuzz::happen(in, *node, left_ms);
  }
  node->pass_ms(10, 0);
  node->finish();
  return 0;
}
