#pragma once

#include "hal/can_port.hpp"
#include "hal/fake/clock.hpp"

namespace hal::fake {

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
