#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/app/config.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/protocol/authority/gate.hpp"
#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "firmware/protocol/isotp/link.hpp"
#include "hal/qemu_mps2/virtual_devices.hpp"
#include "hal/slcan/line.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/support/bytes.hpp"
#include "tests/target/model/block.hpp"
#include "tests/target/model/paper_model.hpp"
#include "tests/target/signals.hpp"

namespace firmware_test {

using Bytes = std::vector<std::byte>;

inline Bytes bytes(std::initializer_list<unsigned> values) {
  Bytes result(values.size());
  std::ranges::transform(values, result.begin(),
                         [](unsigned value) { return static_cast<std::byte>(value); });
  return result;
}

/// A host at the serial line: commands, and a diagnostic client that knows the key of the node.
class Tester {
 public:
  using Request = std::function<Bytes(const Tester&)>;

  Tester(protocol::Node node, const app::Key& key)
      : node_(node),
        key_(key),
        link_(protocol::isotp::Address::to_node(node)),
        commands_(protocol::e2e::stream_of<protocol::Command>(node)) {}

  /// Asks once the request before has been answered, or after a second without an answer.
  void ask(Request request) { requests_.push_back(std::move(request)); }
  void ask(const Bytes& request) {
    ask([request](const Tester&) { return request; });
  }
  /// Starts a routine with a fresh nonce. `flip` is laid over the first byte of the proof.
  void ask_with_authority(std::uint16_t routine, const Bytes& arguments, unsigned flip = 0,
                          const Bytes& transferred = {}) {
    ask(bytes({0x22, 0x02, 0x41}));
    ask(bytes({0x22, 0x02, 0x40}));
    ask([=](const Tester& self) { return self.authorised(routine, arguments, flip, transferred); });
  }
  /// Transfers a block in parts, and has it loaded.
  void load(std::uint8_t tendon, const Bytes& block) {
    constexpr std::size_t kMost = 126;
    const auto size = static_cast<unsigned>(block.size());
    ask(bytes({0x34, 0x00, 0x21, tendon, size >> 8, size & 0xff}));
    unsigned part = 0;
    for (std::size_t at = 0; at < block.size(); at += kMost) {
      Bytes request = bytes({0x36, ++part});
      const auto some = std::span(block).subspan(at, std::min(kMost, block.size() - at));
      request.insert(request.end(), some.begin(), some.end());
      ask(request);
    }
    ask(bytes({0x37}));
    ask_with_authority(0x0203, bytes({tendon}), 0, block);
  }
  /// A command frame as the node accepts it.
  std::string command(const protocol::Command& command) {
    hal::CanFrame frame = protocol::encode(node_, command);
    commands_.protect(frame);
    return text(frame);
  }

  /// Hears what the node has said, and gives the lines that it types now.
  std::vector<std::string> turn(hal::Time now, std::string_view heard) {
    for (const char c : heard) {
      if (c == '\a') {
        continue;
      }
      if (reader_.take(static_cast<std::byte>(c)) == hal::slcan::LineReader::Event::line) {
        if (const auto line = hal::slcan::parse_frame(reader_.line())) {
          link_.on_frame(line->frame, now);
        }
      }
    }
    take_answer(now);
    ask_next(now);
    std::vector<std::string> lines;
    if (const auto frame = link_.next_frame(now)) {
      lines.push_back(text(*frame));
    }
    return lines;
  }

 private:
  static std::string text(const hal::CanFrame& frame) {
    return std::string(hal::slcan::format({frame, false}).view());
  }

  void take_answer(hal::Time now) {
    const auto answer = link_.received();
    if (answer.empty()) {
      return;
    }
    if (answer.size() == 19 && answer[0] == std::byte{0x62} && answer[2] == std::byte{0x41}) {
      std::ranges::copy(answer.subspan(3), nonce_.begin());
    }
    if (answer.size() == 7 && answer[0] == std::byte{0x62} && answer[2] == std::byte{0x40}) {
      counter_ = lifemodel::ByteReader(answer.subspan(3)).u32();
    }
    link_.clear();
    free_at_ = now;
  }

  void ask_next(hal::Time now) {
    if (requests_.empty() || link_.sending() || now < free_at_) {
      return;
    }
    const Bytes request = requests_.front()(*this);
    requests_.pop_front();
    if (link_.send(request) == hal::Error::none) {
      free_at_ = now + hal::seconds(1);
    }
  }

  [[nodiscard]] Bytes authorised(std::uint16_t routine, const Bytes& arguments, unsigned flip,
                                 const Bytes& transferred) const {
    auto proof =
        protocol::authority::mac(key_, node_, {routine, arguments, transferred, counter_}, nonce_);
    proof[0] ^= static_cast<std::byte>(flip);
    const unsigned number = routine;
    const Bytes head = bytes({0x31, 0x01, number >> 8, number & 0xff});
    Bytes request(head.size() + arguments.size() + 4 + proof.size());
    auto out = std::ranges::copy(head, request.begin()).out;
    out = std::ranges::copy(arguments, out).out;
    for (int shift = 0; shift < 32; shift += 8) {
      *out++ = static_cast<std::byte>(counter_ >> shift);
    }
    std::ranges::copy(proof, out);
    return request;
  }

  protocol::Node node_;
  app::Key key_;
  protocol::isotp::Link<128> link_;
  protocol::e2e::Protector commands_;
  hal::slcan::LineReader reader_;
  std::deque<Request> requests_;
  hal::Time free_at_{};
  protocol::authority::Nonce nonce_{};
  std::uint32_t counter_ = 0;
};

using boards::qemu_mps2::Event;
using boards::qemu_mps2::EventKind;

/// What the host does at a moment: lines it types, and requests it hands to the tester.
struct Deed {
  std::uint32_t at_ms;
  std::function<std::vector<Event>(Tester&)> act;
};

struct Scenario {
  const char* name;
  std::uint32_t sample_period_us;
  std::uint32_t duration_ms;
  /// Raw motor current of a tendon.
  std::function<std::int32_t(double time_s, std::size_t tendon)> current;
  std::vector<Deed> deeds;
};

/// The paper's drive: 20.592 N for each ampere, in steps of 2^-24 A.
inline std::int32_t raw_current(double tension_N) {
  return static_cast<std::int32_t>(std::lround(tension_N / 20.592 * (1 << 24)));
}

inline double sine(double time_s, double frequency_Hz) {
  return std::sin(2 * std::numbers::pi * frequency_Hz * time_s);
}

inline Event event_of(EventKind kind, std::uint32_t word) {
  Event event;
  event.kind = kind;
  lifemodel::ByteWriter(event.payload).u32(word);
  return event;
}

inline Event line_of(std::string_view text) {
  Event event;
  event.kind = EventKind::line;
  std::ranges::copy(std::as_bytes(std::span(text)), event.payload.begin());
  return event;
}

inline Deed happens(std::uint32_t at_ms, EventKind kind, std::uint32_t word) {
  return {at_ms, [=](Tester&) { return std::vector{event_of(kind, word)}; }};
}
inline Deed types(std::uint32_t at_ms, const char* text) {
  return {at_ms, [=](Tester&) { return std::vector{line_of(text)}; }};
}
inline Deed commands(std::uint32_t at_ms, protocol::CommandCode code, std::uint8_t argument) {
  return {at_ms, [=](Tester& tester) {
            return std::vector{line_of(tester.command({code, argument}))};
          }};
}
inline Deed asks(std::uint32_t at_ms, std::function<void(Tester&)> what) {
  return {at_ms, [=](Tester& tester) {
            what(tester);
            return std::vector<Event>{};
          }};
}

/// 38.5 N +- 10 N at 2 Hz on one tendon, half of that on the other; long enough for a save.
inline Scenario sine_scenario() {
  return {"sine",
          1'000,
          63'000,
          [](double time_s, std::size_t tendon) {
            const double tension_N = 38.5 + 10 * sine(time_s, 2);
            return raw_current(tendon == 0 ? tension_N : tension_N / 2);
          },
          {}};
}

/// Uniform, 0 .. 100 N.
inline Scenario noise_scenario() {
  auto random = std::make_shared<target::Random>(20);
  return {"noise",
          1'000,
          15'000,
          [random](double, std::size_t) { return raw_current(random->below(1'000'000) * 1e-4); },
          {}};
}

/// Everything that can be missing: samples, the sensor, periods of the loop, the host; and the
/// emergency stop.
inline Scenario gaps_scenario() {
  auto random = std::make_shared<target::Random>(21);
  return {"gaps",
          1'000,
          20'000,
          [random](double time_s, std::size_t tendon) {
            const bool missing = random->below(100) < 2;
            return missing ? hal::qemu_mps2::kNoSample
                           : raw_current(40 + (tendon == 0 ? 20 : 5) * sine(time_s, 5));
          },
          {happens(2'000, EventKind::sensor_failed, 1), happens(2'500, EventKind::sensor_failed, 0),
           happens(4'000, EventKind::missed, 250), happens(5'000, EventKind::emergency_stop, 1),
           happens(7'000, EventKind::emergency_stop, 0), happens(8'000, EventKind::stalled, 1),
           happens(14'000, EventKind::stalled, 0), happens(15'000, EventKind::missed, 1)}};
}

/// Far beyond what the wire bears, until it is worn.
inline Scenario overload_scenario() {
  return {"overload",
          1'000,
          30'000,
          [](double time_s, std::size_t tendon) {
            const double amplitude_N = time_s < 25 ? 75 : 100;
            return raw_current(tendon == 0 ? amplitude_N * (1 + sine(time_s, 20)) : 20);
          },
          {}};
}

/// Commands, and what a host should not write.
inline Scenario commands_scenario() {
  using protocol::CommandCode;
  return {
      "commands",
      1'000,
      12'000,
      [](double time_s, std::size_t tendon) {
        return raw_current(30 + (tendon == 0 ? 5 : 25) * sine(time_s, 3));
      },
      {commands(1'000, CommandCode::identify, 3), commands(2'000, CommandCode::select_page, 2),
       commands(3'000, CommandCode::burst, 9), types(4'000, "t2058FF00000000000000\r"),
       types(4'200, "hello\r"), types(4'400, "r2058\rT18DA05F10\r"),
       types(4'600, "t2058000000000000000000000000\r"), types(4'800, "t2058000000000000000"),
       types(5'000, "t20580000000000000000\r\r\nV\rF\r"), types(6'000, "C\r"), types(7'000, "O\r"),
       types(8'000, "T18DA05F180210220000000000\r"), types(8'100, "T18DA05F1810FF000000000000\r"),
       types(8'300, "T18DA05F1823E8000000000000\r"), commands(9'000, CommandCode::burst, 255)}};
}

/// An extended model, as a block.
inline Bytes block_of(const lifemodel::ExtendedParameters& model) {
  const lifemodel::ExtendedBlock block(model);
  return {block.bytes().begin(), block.bytes().end()};
}

/// All of the extended model of the paper that needs nothing but the motor current, and a
/// correction.
inline lifemodel::ExtendedParameters model_of_current() {
  using lifemodel::extension::Effect;
  lifemodel::ExtendedParameters model = target::extended_paper_model();
  model.extension.effects = 0;
  for (const Effect effect :
       {Effect::current_offset, Effect::input_lag, Effect::mean_stress, Effect::bending_fatigue,
        Effect::endurance_limit, Effect::empirical}) {
    model.extension.add(effect);
  }
  return model;
}

/// Opens an epoch and loads parameters under authority, an extended model among them, with refusals
/// in between: one needs the temperature of the winding.
inline Scenario epoch_scenario() {
  return {"epoch",
          1'000,
          40'000,
          [](double time_s, std::size_t tendon) {
            const bool busy = time_s < 5 || (time_s >= 24 && time_s < 28);
            return raw_current(50 + (tendon == 0 ? 40 : 10) * (busy ? sine(time_s, 4) : 0));
          },
          {asks(1'000,
                [](Tester& tester) {
                  tester.ask(bytes({0x3E, 0x00}));
                  tester.ask(bytes({0x22, 0x02, 0x00}));
                  tester.ask(bytes({0x22, 0xF1, 0x95}));
                  tester.ask(bytes({0x19, 0x02}));
                }),
           asks(8'000,
                [](Tester& tester) {
                  tester.ask_with_authority(0x0201, bytes({0}), 0x01);
                  tester.ask_with_authority(0x0201, bytes({0}));
                  tester.ask(bytes({0x22, 0x02, 0x00}));
                }),
           asks(14'000,
                [](Tester& tester) {
                  Bytes arguments(1 + target::kPaperBlock.size(), std::byte{1});
                  std::ranges::copy(target::kPaperBlock, arguments.begin() + 1);
                  tester.ask_with_authority(0x0202, arguments);
                  tester.ask(bytes({0x22, 0x10, 0x00}));
                  tester.ask(bytes({0x22, 0x02, 0x42}));
                }),
           asks(18'000,
                [](Tester& tester) {
                  lifemodel::ExtendedParameters warm = model_of_current();
                  warm.extension.effects = 0;
                  warm.extension.add(lifemodel::extension::Effect::torque_gain);
                  tester.load(0, block_of(warm));
                  tester.ask(bytes({0x22, 0x02, 0x60}));
                  tester.load(1, block_of(model_of_current()));
                }),
           asks(32'000, [](Tester& tester) { tester.ask_with_authority(0x0201, bytes({7})); })}};
}

/// After a restart on the flash of the one before, at 10 kHz.
inline Scenario restart_scenario() {
  return {"restart",
          100,
          4'000,
          [](double time_s, std::size_t tendon) {
            return raw_current(45 + (tendon == 0 ? 30 : 8) * sine(time_s, 50));
          },
          {asks(1'000, [](Tester& tester) {
            tester.ask(bytes({0x22, 0x02, 0x00}));
            tester.ask(bytes({0x22, 0x02, 0x61}));
          })}};
}

inline std::vector<Scenario> scenarios() {
  return {sine_scenario(),     noise_scenario(), gaps_scenario(),   overload_scenario(),
          commands_scenario(), epoch_scenario(), restart_scenario()};
}

}  // namespace firmware_test
