#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "firmware/app/config.hpp"
#include "firmware/protocol/authority/gate.hpp"
#include "firmware/protocol/isotp/link.hpp"
#include "lifemodel/support/bytes.hpp"
#include "tests/virtual_g431/image.hpp"

namespace virtual_g431 {

using Bytes = std::vector<std::byte>;
inline Bytes bytes(std::initializer_list<unsigned> values) {
  Bytes result;
  for (const unsigned value : values) {
    result.push_back(static_cast<std::byte>(value));
  }
  return result;
}

/// Asks the board by ISO-TP over its bus, while its time goes on.
class Tester {
 public:
  explicit Tester(Board& board, protocol::Node node = kNode) : board_(board), node_(node) {}

  /// The answer; empty where none comes within 2 s.
  Bytes ask(const Bytes& request) {
    link_.clear();
    seen_ = board_.can.heard.size();
    if (link_.send(request) != hal::Error::none) {
      return {};
    }
    for (int i = 0; i < 2'000 && link_.received().empty(); ++i) {
      if (const auto frame = link_.next_frame(now())) {
        board_.can.send(*frame);
      }
      board_.run(kMillisecond);
      for (; seen_ < board_.can.heard.size(); ++seen_) {
        link_.on_frame(board_.can.heard[seen_].frame, now());
      }
    }
    const auto answer = link_.received();
    return {answer.begin(), answer.end()};
  }
  /// Sends a request and does not wait for its answer.
  void send(const Bytes& request) {
    link_.clear();
    seen_ = board_.can.heard.size();
    (void)link_.send(request);
    while (link_.sending()) {
      if (const auto frame = link_.next_frame(now())) {
        board_.can.send(*frame);
      }
      board_.run(kMillisecond / 10);
      for (; seen_ < board_.can.heard.size(); ++seen_) {
        link_.on_frame(board_.can.heard[seen_].frame, now());
      }
    }
  }
  Bytes read(unsigned identifier) { return ask(bytes({0x22, identifier >> 8, identifier & 0xFF})); }

  /// RoutineControl with a fresh nonce; `flip` makes the code wrong.
  Bytes start(std::uint16_t routine, const Bytes& arguments, const app::Key& key, unsigned flip = 0,
              const Bytes& transferred = {}) {
    last_ = prove(routine, arguments, key, flip, transferred);
    return last_.empty() ? Bytes{} : ask(last_);
  }
  /// Its request; empty where the board gives no nonce.
  Bytes prove(std::uint16_t routine, const Bytes& arguments, const app::Key& key, unsigned flip,
              const Bytes& transferred) {
    const Bytes nonce = read(0x0241);
    const Bytes counter = read(0x0240);
    if (nonce.size() != 19 || counter.size() != 7) {
      return {};
    }
    std::copy(nonce.begin() + 3, nonce.end(), nonce_.begin());
    counter_ = lifemodel::ByteReader(std::span(counter).subspan(3)).u32();
    return proven(routine, arguments, key, flip, transferred);
  }
  /// Transfers a block of tendon 0 in parts. False where one of them is not taken.
  bool transfer(const Bytes& block) {
    constexpr std::size_t kMost = 126;
    const auto size = static_cast<unsigned>(block.size());
    bool taken = ask(bytes({0x34, 0x00, 0x21, 0, size >> 8, size & 0xFF})) ==
                 bytes({0x74, 0x20, 0x00, 0x91});
    unsigned part = 0;
    for (std::size_t at = 0; taken && at < block.size(); at += kMost) {
      Bytes request = bytes({0x36, ++part});
      const auto some = std::span(block).subspan(at, std::min(kMost, block.size() - at));
      request.insert(request.end(), some.begin(), some.end());
      taken = ask(request) == bytes({0x76, part});
    }
    return taken && ask(bytes({0x37})) == bytes({0x77});
  }
  /// The same, and has it loaded; the answer.
  Bytes load(const Bytes& block, const app::Key& key) {
    return transfer(block) ? start(0x0203, bytes({0}), key, 0, block) : Bytes{};
  }
  /// The request before once more, nonce and all.
  Bytes repeat() { return ask(last_); }

 private:
  [[nodiscard]] hal::Time now() const { return {board_.agenda.now() / kMicrosecond}; }

  [[nodiscard]] Bytes proven(std::uint16_t routine, const Bytes& arguments, const app::Key& key,
                             unsigned flip, const Bytes& transferred) const {
    auto proof =
        protocol::authority::mac(key, node_, {routine, arguments, transferred, counter_}, nonce_);
    proof[0] ^= static_cast<std::byte>(flip);
    Bytes request = bytes({0x31, 0x01, unsigned{routine} >> 8, unsigned{routine} & 0xFF});
    request.insert(request.end(), arguments.begin(), arguments.end());
    for (int shift = 0; shift < 32; shift += 8) {
      request.push_back(static_cast<std::byte>(counter_ >> shift));
    }
    request.insert(request.end(), proof.begin(), proof.end());
    return request;
  }

  Board& board_;
  protocol::Node node_;
  protocol::isotp::Link<256> link_{protocol::isotp::Address::to_node(node_)};
  std::size_t seen_ = 0;
  protocol::authority::Nonce nonce_{};
  std::uint32_t counter_ = 0;
  Bytes last_;
};

/// The key of node_page in CMakeLists.txt.
inline constexpr app::Key kKey = [] {
  app::Key key{};
  for (unsigned i = 0; i < key.size(); ++i) {
    key[i] = static_cast<std::byte>(0x11 * i);
  }
  return key;
}();

/// That the life which the diagnosis reads, the damage at its offset 16, is this in all 128 bits.
inline void expect_damage(Board& board, const lifemodel::Damage& expected) {
  const Bytes life = Tester(board).read(0x0200);
  ASSERT_EQ(life.size(), 3u + 61u);
  const auto exact = std::span(life).subspan(3 + 16);
  lifemodel::ByteReader in(exact);
  for (const std::uint32_t word : expected.words()) {
    EXPECT_EQ(in.u32(), word);
  }
}

}  // namespace virtual_g431
