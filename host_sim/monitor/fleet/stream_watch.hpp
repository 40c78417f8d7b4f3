#pragma once

#include <cstdint>
#include <optional>

#include "firmware/protocol/e2e.hpp"
#include "firmware/protocol/schema/frame.hpp"
#include "hal/can_frame.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// Follows the frames of one kind of one node: checks them end to end and counts what became of
/// them. A stream without protection has its length checked alone.
class StreamWatch {
 public:
  StreamWatch(const protocol::schema::Frame& frame, protocol::Node node);

  /// What the frame is worth. Precondition: it has the identifier of the stream.
  protocol::e2e::Status take(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& view);

  /// The node has begun anew, and its counters with it.
  void begin_anew();

 private:
  protocol::e2e::Status check(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& view);
  void count_interval(std::int64_t time_ns, StreamView& view);

  const protocol::schema::Frame& frame_;
  std::optional<protocol::e2e::Stream> stream_;
  std::optional<protocol::e2e::Checker> checker_;
  std::optional<std::int64_t> last_ns_;  ///< of the last genuine frame
};

/// What frames of the stream are called in a view that is empty as yet.
StreamView empty_stream_view(const protocol::schema::Frame& frame);

}  // namespace host_sim::monitor
