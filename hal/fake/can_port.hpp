#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "hal/can_frame.hpp"
#include "hal/can_port.hpp"
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

/// What a controller can do instead of sending.
enum class SendFault : std::uint8_t {
  full,     ///< no room for the frame
  passive,  ///< the frame leaves after so many errors that the controller is error passive
  off,      ///< the controller goes off the bus
};

/// A controller on a CanBus, with error counters as ISO 11898-1 has them (fault confinement).
class CanPort {
 public:
  /// The bus outlives the port; ports stay until it ends.
  explicit CanPort(CanBus& bus) : bus_(bus), number_(bus.join(*this)) {}
  CanPort(const CanPort&) = delete;
  CanPort& operator=(const CanPort&) = delete;

  Error send(const CanFrame& frame) {
    take_part_again();
    if (is_off_) {
      return Error::off;
    }
    const auto fault = faults.next(bus_.clock().now());
    if (fault == SendFault::off) {
      go_off();
      return Error::off;
    }
    if (fault == SendFault::full) {
      return Error::full;
    }
    if (fault == SendFault::passive) {
      transmit_errors_ = kPassive;
    } else if (transmit_errors_ != 0) {
      --transmit_errors_;
    }
    bus_.take(number_, frame);
    return Error::none;
  }

  std::optional<CanFrame> receive() {
    bus_.deliver_delayed();
    if (queue_.empty()) {
      return std::nullopt;
    }
    const CanFrame frame = queue_.front();
    queue_.pop_front();
    return frame;
  }

  CanStatus status() {
    take_part_again();
    return {state(), static_cast<std::uint8_t>(is_off_ ? 255 : transmit_errors_), 0, bus_offs_,
            lost_};
  }

  Error recover() {
    take_part_again();
    if (is_off_ && !back_at_) {
      back_at_ = bus_.clock().now() + recovery;
    }
    return Error::none;
  }

  /// As after 32 failed transmissions.
  void go_off() {
    if (!is_off_) {
      is_off_ = true;
      ++bus_offs_;
    }
    back_at_.reset();
  }

  Faults<SendFault> faults;
  /// From recover() until the controller takes part again; ISO 11898-1 has 128 times 11 bits.
  Time recovery = microseconds(1'408);
  /// What passes; without it everything.
  std::function<bool(const CanFrame&)> filter;
  std::size_t room = 64;  ///< received frames that wait at most

 private:
  friend CanBus;
  static constexpr std::uint16_t kWarning = 96;
  static constexpr std::uint16_t kPassive = 128;

  void hear(const CanFrame& frame) {
    take_part_again();
    if (is_off_ || (filter && !filter(frame))) {
      return;
    }
    if (queue_.size() == room) {
      ++lost_;
      return;
    }
    queue_.push_back(frame);
  }

  void take_part_again() {
    if (back_at_ && *back_at_ <= bus_.clock().now()) {
      back_at_.reset();
      is_off_ = false;
      transmit_errors_ = 0;
    }
  }

  [[nodiscard]] CanState state() const {
    return is_off_                        ? CanState::off
           : transmit_errors_ >= kPassive ? CanState::passive
           : transmit_errors_ >= kWarning ? CanState::warning
                                          : CanState::active;
  }

  CanBus& bus_;
  std::size_t number_;
  std::deque<CanFrame> queue_;
  bool is_off_ = false;
  std::optional<Time> back_at_;
  std::uint16_t transmit_errors_ = 0;
  std::uint32_t bus_offs_ = 0;
  std::uint32_t lost_ = 0;
};

inline void CanBus::take(std::size_t sender, const CanFrame& frame) {
  deliver_delayed();
  CanEvent event{clock_.now(), sender, frame};
  sent_.push_back(event);
  const auto mishap = mishaps.next(clock_.now());
  if (mishap == CanMishap::lost) {
    return;
  }
  if (mishap == CanMishap::delayed) {
    event.time = event.time + delay;
    delayed_.push_back(event);
    return;
  }
  if (mishap == CanMishap::corrupted) {
    event.frame = corrupted(frame);
  }
  deliver(event);
  if (mishap == CanMishap::duplicated) {
    deliver(event);
  }
}

inline void CanBus::deliver_delayed() {
  while (!delayed_.empty() && delayed_.front().time <= clock_.now()) {
    const CanEvent event = delayed_.front();
    delayed_.erase(delayed_.begin());
    deliver(event);
  }
}

inline void CanBus::deliver(const CanEvent& event) {
  for (CanPort* port : ports_) {
    if (port->number_ != event.sender) {
      port->hear(event.frame);
    }
  }
}

inline CanFrame CanBus::corrupted(CanFrame frame) {
  if (frame.length == 0) {
    frame.id ^= 1u << random_.below(frame.extended ? 29 : 11);
    return frame;
  }
  const std::uint32_t bit = random_.below(8u * frame.length);
  frame.data[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
  return frame;
}

static_assert(hal::CanPort<CanPort>);

/// A controller on a bus where nobody else talks. Each frame is handed to
/// `listener(Time, const CanFrame&)` as it leaves.
template <class Listener>
class CanListener {
 public:
  CanListener(const Clock& clock, Listener& listener) : clock_(clock), listener_(listener) {}

  Error send(const CanFrame& frame) {
    listener_(clock_.now(), frame);
    return Error::none;
  }
  std::optional<CanFrame> receive() { return std::nullopt; }
  CanStatus status() { return {}; }
  Error recover() { return Error::none; }

 private:
  const Clock& clock_;
  Listener& listener_;
};

}  // namespace hal::fake
