#pragma once

#include <cstdint>

#include "lifemodel/support/shared_word.hpp"

namespace lifemodel {

/// Lets a reader on another core notice that several words changed while it read them. The writer
/// never waits. With one core it costs nothing: a writer that interrupts has finished when the
/// reader goes on.
class TurnLock {
 public:
  /// Writer: before and after a change of several words.
  void begin() {
    if constexpr (kSeveralCores) {
      turns_.set_relaxed(turns_.own() + 1);
      fence(std::memory_order_release);
    }
  }
  void end() {
    if constexpr (kSeveralCores) {
      turns_.release(turns_.own() + 1);
    }
  }

  /// Reader: what to compare with after reading; odd while a change is under way.
  [[nodiscard]] std::uint32_t start() const { return kSeveralCores ? turns_.acquire() : 0; }
  /// Reader: whether what was read since start() belongs together.
  [[nodiscard]] bool unchanged(std::uint32_t started) const {
    fence(std::memory_order_acquire);
    return !kSeveralCores || (started % 2 == 0 && turns_.relaxed() == started);
  }

 private:
  SharedWord<std::uint32_t> turns_;
};

}  // namespace lifemodel
