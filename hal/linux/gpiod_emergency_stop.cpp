#include "hal/linux/gpiod_emergency_stop.hpp"

#include <algorithm>
#include <exception>

#include "hal/digital.hpp"

namespace hal::linux_os {

static_assert(DigitalIn<GpioEmergencyStop>);

GpioEdges::GpioEdges(const std::string& chip, const LineSpec& line,
                     std::chrono::microseconds debounce)
    : request_(request_lines(chip, std::span(&line, 1),
                             ::gpiod::line_settings()
                                 .set_direction(::gpiod::line::direction::INPUT)
                                 .set_edge_detection(::gpiod::line::edge::BOTH)
                                 .set_event_clock(::gpiod::line::clock::MONOTONIC)
                                 .set_debounce_period(debounce),
                             offsets_)),
      buffer_(kBufferEdges) {}

Result<std::size_t> GpioEdges::read(std::span<Edge> out) {
  try {
    if (!request_.wait_edge_events(std::chrono::nanoseconds(0))) {
      return std::size_t{0};
    }
    const std::size_t count =
        request_.read_edge_events(buffer_, std::min(out.size(), buffer_.capacity()));
    for (std::size_t i = 0; i < count; ++i) {
      const ::gpiod::edge_event& event = buffer_.get_event(static_cast<unsigned>(i));
      out[i] = {event.type() == ::gpiod::edge_event::event_type::RISING_EDGE,
                static_cast<std::uint32_t>(event.global_seqno()),
                static_cast<std::uint32_t>(event.line_seqno()), event.timestamp_ns().ns()};
    }
    return count;
  } catch (const std::exception&) {
    return Error::failed;
  }
}

Result<bool> GpioEdges::level() {
  try {
    return request_.get_value(offsets_.front()) == ::gpiod::line::value::ACTIVE;
  } catch (const std::exception&) {
    return Error::failed;
  }
}

}  // namespace hal::linux_os
