#include "firmware/boards/linux/devices.hpp"

#include <array>
#include <utility>
#include <vector>

#include "hal/files/candump.hpp"

namespace boards::linux_controller {
namespace {

using hal::linux_os::CanFilter;

/// What a node listens to: commands (0x200 + n), and requests of the tester 0xf1 by normal fixed
/// addressing (ISO 15765-2, 0x18da nn f1).
std::array<CanFilter, 2> filters_of(protocol::Node node) {
  return {CanFilter{0x200U + node, CAN_SFF_MASK, false},
          CanFilter{0x18da'00f1U | static_cast<std::uint32_t>(node) << 8, CAN_EFF_MASK, true}};
}

}  // namespace

BoardCan::BoardCan(const CanConfig& config, protocol::Node node, const BoardClock& clock,
                   std::span<const CanFilter> also, Heard heard)
    : clock_(clock), heard_(std::move(heard)) {
  if (config.interface != kNoBus) {
    std::vector<CanFilter> filters(also.begin(), also.end());
    for (const CanFilter& own : filters_of(node)) {
      filters.push_back(own);
    }
    bus_.emplace(calls_, config.interface, filters);
  } else if (!config.log.empty()) {
    log_.emplace(config.log);
  }
}

hal::Error BoardCan::send(const hal::CanFrame& frame) {
  if (bus_) {
    return bus_->send(frame);
  }
  if (log_) {
    log_->write(hal::files::candump_line(clock_.now().us, kNoBus, frame));
    ++logged_;
  }
  return hal::Error::none;
}

std::optional<hal::CanFrame> BoardCan::receive() {
  const auto frame = bus_ ? bus_->receive() : std::nullopt;
  if (frame) {
    heard_(*frame);
  }
  return frame;
}

hal::CanStatus BoardCan::status() const {
  return bus_ ? bus_->status() : hal::CanStatus{};
}

hal::Error BoardCan::recover() {
  return bus_ ? bus_->recover() : hal::Error::none;
}

const hal::linux_os::SocketCanCounts* BoardCan::counts() const {
  return bus_ ? &bus_->counts() : nullptr;
}

void BoardCan::finish() {
  if (log_) {
    log_->commit();
  }
}

}  // namespace boards::linux_controller
