#pragma once

#include <cstdint>

#include "firmware/protocol/authority/gate.hpp"
#include "tests/lifemodel/support.hpp"
#include "tests/protocol/services/bytes.hpp"

namespace protocol::testing {

inline const authority::Key kKey = hex_array<authority::Key>("000102030405060708090a0b0c0d0e0f");
inline constexpr Node kNode = 5;

/// What is signed, and what is then sent with it.
struct Order {
  std::uint16_t routine = 0x0201;
  Bytes arguments = hex("00");
  Bytes transferred{};
  std::uint32_t counter = 0;
  authority::Nonce nonce{};
  Node node = kNode;
  authority::Key key = kKey;
};

inline Bytes little_endian(std::uint32_t value) {
  Bytes result;
  for (int shift = 0; shift < 32; shift += 8) {
    result.push_back(static_cast<std::byte>(value >> shift));
  }
  return result;
}

inline authority::Mac code_of(const Order& order) {
  return authority::mac(order.key, order.node,
                        {.routine = order.routine,
                         .arguments = order.arguments,
                         .transferred = order.transferred,
                         .storage_counter = order.counter},
                        order.nonce);
}

/// The request that starts a routine.
inline Bytes start_request(const Order& order, std::uint8_t sub_function = 0x01) {
  return Bytes{std::byte{0x31}, std::byte{sub_function}, static_cast<std::byte>(order.routine >> 8),
               static_cast<std::byte>(order.routine)} +
         order.arguments + little_endian(order.counter) + to_bytes(code_of(order));
}

/// The paper's parameters as a block.
inline Bytes paper_block() {
  return to_bytes(
      lifemodel::encode(lifemodel_test::parameters_of(lifemodel_test::paper_constants())));
}

}  // namespace protocol::testing
