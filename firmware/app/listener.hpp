#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "firmware/protocol/messages.hpp"
#include "hal/can_frame.hpp"

namespace app {

/// Takes commands: those that are whole, new and known. All others are counted and change nothing.
class Listener {
 public:
  explicit Listener(protocol::Node node)
      : checker_(protocol::e2e::stream_of<protocol::Command>(node)) {}

  /// The command in a frame. Nothing where the frame is another, or is refused.
  std::optional<protocol::Command> take(const hal::CanFrame& frame) {
    const protocol::e2e::Status status = checker_.check(frame);
    if (status == protocol::e2e::Status::other_frame) {
      return std::nullopt;
    }
    const auto command = protocol::decode<protocol::Command>(frame);
    if (!protocol::e2e::is_usable(status) || !command) {
      refused_ += refused_ != std::numeric_limits<std::uint32_t>::max() ? 1u : 0u;
      return std::nullopt;
    }
    return *command;
  }

  /// Stops at its highest value.
  [[nodiscard]] std::uint32_t refused() const { return refused_; }

 private:
  protocol::e2e::Checker checker_;
  std::uint32_t refused_ = 0;
};

}  // namespace app
