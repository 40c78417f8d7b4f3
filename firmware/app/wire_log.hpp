#pragma once

#include <cstdint>

#include "firmware/storage/wire_history.hpp"
#include "lifemodel/support/saturating.hpp"
#include "lifemodel/watch/wire_watch.hpp"

namespace app {

/// The history of the wire of one tendon over restarts: what was stored, and what the watch has
/// seen since. A wire that broke stays broken until a new one is put in, and is not slack besides.
class WireLog {
 public:
  void resume(const storage::WireHistory& past) { history_ = past; }

  /// Takes in a reading of a watch that was begun with the start.
  void take(const lifemodel::WatchReading& now, std::uint32_t sample_period_us) {
    history_.peak = now.peak > history_.peak ? now.peak : history_.peak;
    add(history_.above_50, now.above[0] - before_.above[0]);
    add(history_.above_70, now.above[1] - before_.above[1]);
    add(history_.above_90, now.above[2] - before_.above[2]);
    below_minimum_us_ +=
        std::uint64_t{now.below_minimum - before_.below_minimum} * sample_period_us;
    // Readings are a fraction of a second apart.
    for (; below_minimum_us_ >= kSecond_us; below_minimum_us_ -= kSecond_us) {
      add(history_.below_minimum_s, 1);
    }
    if (!history_.broken) {
      add(history_.slack_events, now.slack_events - before_.slack_events);
    }
    history_.broken = history_.broken || now.broken;
    before_ = now;
  }
  /// It was counted for so long.
  void operate(std::uint64_t us) {
    operated_us_ += us;
    // As above.
    for (; operated_us_ >= kSecond_us; operated_us_ -= kSecond_us) {
      add(history_.operated_s, 1);
    }
  }
  /// A new wire was put in with the last reading.
  void begin() {
    history_ = {};
    below_minimum_us_ = 0;
    operated_us_ = 0;
    before_.slack = false;
  }

  [[nodiscard]] const storage::WireHistory& history() const { return history_; }
  /// Now.
  [[nodiscard]] bool slack() const { return before_.slack && !history_.broken; }

 private:
  static constexpr std::uint32_t kSecond_us = 1'000'000;

  static void add(std::uint32_t& count, std::uint32_t more) {
    count = lifemodel::saturating_add(count, more);
  }

  storage::WireHistory history_;
  lifemodel::WatchReading before_;
  std::uint64_t below_minimum_us_ = 0;  ///< of a second that is not full
  std::uint64_t operated_us_ = 0;       ///< the same
};

}  // namespace app
