#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hal/can_frame.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/faults.hpp"

namespace hal::fake {

class CanPort;

/// A frame on the bus: when, and by which of the ports that take part, counted from 0.
struct CanEvent {
  Time time{};
  std::size_t sender = 0;
  CanFrame frame;

  friend bool operator==(const CanEvent&, const CanEvent&) = default;
};

/// What a bus can do to a frame on its way to the others. A real bus loses frames to a receiver
/// that is late, and corrupts them past its CRC once in a long while.
enum class CanMishap : std::uint8_t {
  lost,        ///< nobody gets it
  duplicated,  ///< everybody gets it twice
  delayed,     ///< by `CanBus::delay`, so that frames after it overtake it
  corrupted,   ///< one data bit is the other way round, or an id bit where there are no data
};

/// A bus with several ports. For hosts.
class CanBus {
 public:
  explicit CanBus(const Clock& clock, std::uint64_t seed = 1)
      : mishaps(seed), clock_(clock), random_(seed) {}
  CanBus(const CanBus&) = delete;
  CanBus& operator=(const CanBus&) = delete;

  /// All that was sent, before any mishap.
  [[nodiscard]] const std::vector<CanEvent>& sent() const { return sent_; }
  void forget() { sent_.clear(); }
  [[nodiscard]] const Clock& clock() const { return clock_; }

  Faults<CanMishap> mishaps;
  Time delay = milliseconds(50);

 private:
  friend CanPort;
  std::size_t join(CanPort& port) {
    ports_.push_back(&port);
    return ports_.size() - 1;
  }
  void take(std::size_t sender, const CanFrame& frame);
  void deliver_delayed();
  void deliver(const CanEvent& event);
  [[nodiscard]] CanFrame corrupted(CanFrame frame);

  const Clock& clock_;
  Random random_;
  std::vector<CanPort*> ports_;
  std::vector<CanEvent> sent_;
  std::vector<CanEvent> delayed_;
};

}  // namespace hal::fake
