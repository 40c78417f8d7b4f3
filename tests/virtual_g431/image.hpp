#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/messages.hpp"
#include "tests/virtual_g431/board/board.hpp"

namespace virtual_g431 {

inline constexpr protocol::Node kNode = 5;

inline std::vector<std::uint8_t> bytes_of(const char* path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The flash as the firmware's README says to make it: the image and the page of node 5.
class Image : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto image = bytes_of(G431_IMAGE);
    if (image.empty() && std::getenv("CI") == nullptr) {
      GTEST_SKIP() << "no image: cmake --preset stm32g431 && cmake --build --preset stm32g431";
    }
    ASSERT_FALSE(image.empty()) << G431_IMAGE << " is missing";
    contents.flash(0, image);
    contents.flash(kNodePageOffset, bytes_of(G431_NODE_PAGE));
  }

  FlashContents contents;
};

/// All messages of a kind that a board of node 5 has sent.
template <class Message>
std::vector<Message> sent(const Board& board, protocol::Node node = kNode) {
  std::vector<Message> result;
  for (const CanController::Heard& heard : board.can.heard) {
    if (heard.frame.id == protocol::id_of(protocol::schema::Layout<Message>::kFrame, node)) {
      if (const auto message = protocol::decode<Message>(heard.frame)) {
        result.push_back(*message);
      }
    }
  }
  return result;
}

/// Whether the board of node 5 has reported an event.
inline bool reported(const Board& board, protocol::EmergencyCode code) {
  const auto emergencies = sent<protocol::Emergency>(board);
  return std::ranges::find(emergencies, code, &protocol::Emergency::code) != emergencies.end();
}

}  // namespace virtual_g431
