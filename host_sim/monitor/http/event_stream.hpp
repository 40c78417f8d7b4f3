#pragma once

#include <cstdint>
#include <string>

#include "host_sim/monitor/http/hub.hpp"

namespace host_sim::monitor {

/// The server-sent events of one reader (HTML Living Standard, 9.2): `whole` with a view, then
/// `change` with {"patch": merge patch, "events": ..}, comments where nothing comes.
class EventStream {
 public:
  explicit EventStream(Hub& hub);
  EventStream(const EventStream&) = delete;
  EventStream& operator=(const EventStream&) = delete;
  ~EventStream();

  /// The next piece of the stream; empty where the hub is closed. Waits no longer than until a
  /// comment is due.
  std::string next();

 private:
  Hub& hub_;
  std::uint64_t version_ = 0;
  bool started_ = false;
};

}  // namespace host_sim::monitor
