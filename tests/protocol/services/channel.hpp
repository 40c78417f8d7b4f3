#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "hal/can_frame.hpp"

namespace protocol::testing {

/// What becomes of a frame.
enum class Fate : std::uint8_t { arrives, lost, twice, overtaken };

/// A direction of a bus that loses, repeats and reorders by a script; what is behind its end
/// arrives.
class Channel {
 public:
  explicit Channel(std::vector<Fate> script = {}) : script_(std::move(script)) {}

  void put(const hal::CanFrame& frame) {
    const Fate fate = at_ < script_.size() ? script_[at_++] : Fate::arrives;
    lost_ += fate == Fate::lost ? 1u : 0u;
    if (fate == Fate::overtaken && !held_) {
      held_ = frame;
      return;
    }
    for (int i = 0; i < (fate == Fate::lost ? 0 : fate == Fate::twice ? 2 : 1); ++i) {
      frames_.push_back(frame);
    }
    release();
  }
  /// Lets out the frame that waits to be overtaken.
  void release() {
    if (held_) {
      frames_.push_back(*held_);
      held_.reset();
    }
  }
  std::optional<hal::CanFrame> take() {
    if (frames_.empty()) {
      return std::nullopt;
    }
    const hal::CanFrame frame = frames_.front();
    frames_.pop_front();
    return frame;
  }
  [[nodiscard]] std::size_t lost() const { return lost_; }

 private:
  std::vector<Fate> script_;
  std::size_t at_ = 0;
  std::size_t lost_ = 0;
  std::optional<hal::CanFrame> held_;
  std::deque<hal::CanFrame> frames_;
};

}  // namespace protocol::testing
