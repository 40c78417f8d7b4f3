#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/app/config.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/protocol/authority/command.hpp"
#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "firmware/protocol/isotp/link.hpp"
#include "hal/slcan/line.hpp"
#include "lifemodel/support/bytes.hpp"

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
  void ask_with_authority(std::uint16_t routine, const Bytes& arguments, unsigned flip = 0) {
    ask(bytes({0x22, 0x02, 0x41}));
    ask(bytes({0x22, 0x02, 0x40}));
    ask([=](const Tester& self) { return self.authorised(routine, arguments, flip); });
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

  [[nodiscard]] Bytes authorised(std::uint16_t routine, const Bytes& arguments,
                                 unsigned flip) const {
    auto proof = protocol::authority::mac(key_, node_, {routine, arguments, counter_}, nonce_);
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

}  // namespace firmware_test
