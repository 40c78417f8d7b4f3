#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/boards/qemu_mps2/image/format.hpp"
#include "firmware/boards/qemu_mps2/image/source.hpp"
#include "hal/clock.hpp"
#include "lifemodel/support/bytes.hpp"

namespace firmware::qemu_mps2 {

/// Reads the events of a recording one after another. Without a source there are none.
template <Source SourceT>
class Script {
 public:
  explicit Script(SourceT* source) : source_(source), ended_(source == nullptr) {}

  /// The next event whose time has come.
  std::optional<Event> due(hal::Time now) {
    if (!next_ && !ended_) {
      read();
    }
    if (!next_ || hal::milliseconds(next_->at_ms) > now) {
      return std::nullopt;
    }
    const std::optional<Event> event = next_;
    next_.reset();
    return event;
  }

 private:
  void read() {
    std::array<std::byte, Event::kBytes> bytes{};
    ended_ = source_->read(bytes) != bytes.size();
    if (ended_) {
      return;
    }
    lifemodel::ByteReader in(bytes);
    Event event;
    event.at_ms = in.u32();
    event.kind = static_cast<EventKind>(in.u32());
    std::ranges::copy(std::span(bytes).last(Event::kPayloadBytes), event.payload.begin());
    next_ = event;
  }

  SourceT* source_;
  std::optional<Event> next_;
  bool ended_;
};

}  // namespace firmware::qemu_mps2
