#include "host_sim/monitor/http/event_stream.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::chrono::seconds kHeartbeat{2};

}  // namespace

EventStream::EventStream(Hub& hub) : hub_(hub) {
  hub_.join();
}

EventStream::~EventStream() {
  hub_.leave();
}

std::string EventStream::next() {
  if (!started_) {
    started_ = true;
    return "retry: 1000\n\n";
  }
  const Hub::Message message = hub_.next(version_, kHeartbeat);
  if (hub_.closed()) {
    return {};
  }
  if (!message.json) {
    return ": still here\n\n";
  }
  version_ = message.version;
  std::string text = message.whole ? "event: whole\ndata: " : "event: change\ndata: ";
  return text + *message.json + "\n\n";
}

}  // namespace host_sim::monitor
