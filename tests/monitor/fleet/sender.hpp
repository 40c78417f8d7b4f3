#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "host_sim/monitor/bus/seen_frame.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor::test {

inline constexpr std::int64_t kMs = 1'000'000;
inline constexpr std::int64_t kS = 1'000'000'000;

inline SeenFrame seen(std::int64_t time_ns, const hal::CanFrame& frame) {
  SeenFrame out;
  out.time_ns = time_ns;
  out.frame = frame;
  return out;
}

/// The texts of the events of a kind, oldest first.
inline std::vector<std::string> event_texts(const NodeView& node, EventKind kind) {
  std::vector<std::string> texts;
  for (const Event& event : node.events) {
    if (event.kind == kind) {
      texts.push_back(event.text);
    }
  }
  return texts;
}

/// A node whose frames are genuine.
class Sender {
 public:
  explicit Sender(protocol::Node node)
      : node_(node),
        status_(protocol::e2e::stream_of<protocol::LifeStatus>(node)),
        detail_(protocol::e2e::stream_of<protocol::detail::Identity>(node)),
        emergency_(protocol::e2e::stream_of<protocol::Emergency>(node)) {}

  [[nodiscard]] SeenFrame heartbeat(
      std::int64_t time_ns, protocol::NmtState state = protocol::NmtState::operational) const {
    return seen(time_ns, protocol::encode(node_, protocol::Heartbeat{state}));
  }
  SeenFrame status(std::int64_t time_ns, const protocol::LifeStatus& status) {
    return protect(time_ns, status, status_);
  }
  SeenFrame damage(std::int64_t time_ns, std::uint32_t damage_ppb) {
    return status(time_ns, {.state = protocol::LifeState::normal, .damage_ppb = damage_ppb});
  }
  template <class Page>
  SeenFrame page(std::int64_t time_ns, const Page& page) {
    return protect(time_ns, page, detail_);
  }
  SeenFrame emergency(std::int64_t time_ns, const protocol::Emergency& emergency) {
    return protect(time_ns, emergency, emergency_);
  }

 private:
  template <class Message>
  SeenFrame protect(std::int64_t time_ns, const Message& message,
                    protocol::e2e::Protector& protector) const {
    hal::CanFrame frame = protocol::encode(node_, message);
    protector.protect(frame);
    return seen(time_ns, frame);
  }

  protocol::Node node_;
  protocol::e2e::Protector status_;
  protocol::e2e::Protector detail_;
  protocol::e2e::Protector emergency_;
};

}  // namespace host_sim::monitor::test
