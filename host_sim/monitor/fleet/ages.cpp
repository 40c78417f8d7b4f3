#include "host_sim/monitor/fleet/ages.hpp"

#include <optional>

#include "firmware/protocol/messages.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::int64_t kPage_ns =
    limit_ns(protocol::schema::kLifeDetailFrame) * protocol::detail::kPages;

class Marker {
 public:
  Marker(std::int64_t now_ns, bool vanished) : now_ns_(now_ns), vanished_(vanished) {}

  template <class Value>
  void mark(Timed<Value>& timed, std::int64_t most_ns) const {
    timed.stale = vanished_ || now_ns_ - timed.time_ns > most_ns;
  }
  template <class Value>
  void mark(std::optional<Timed<Value>>& timed, std::int64_t most_ns) const {
    if (timed) {
      mark(*timed, most_ns);
    }
  }
  template <class Key, class Value>
  void mark_turns(std::map<Key, Timed<Value>>& timed) const {
    const std::int64_t most_ns = kPage_ns * static_cast<std::int64_t>(timed.size());
    for (auto& [key, value] : timed) {
      mark(value, most_ns);
    }
  }

 private:
  std::int64_t now_ns_;
  bool vanished_;
};

}  // namespace

void mark_stale(NodeView& view, std::int64_t now_ns) {
  const Marker marker(now_ns, view.vanished);
  marker.mark(view.heartbeat, limit_ns(protocol::schema::kHeartbeatFrame));
  marker.mark(view.status, limit_ns(protocol::schema::kLifeStatusFrame));
  marker.mark(view.identity, kPage_ns);
  marker.mark(view.cycles, kPage_ns);
  marker.mark(view.rate, kPage_ns);
  marker.mark(view.remaining, kPage_ns);
  marker.mark(view.storage, kPage_ns);
  marker.mark(view.timing, kPage_ns);
  marker.mark(view.bus, kPage_ns);
  marker.mark_turns(view.tendons);
  marker.mark_turns(view.bins);
  if (view.emergency) {
    view.emergency->stale = view.vanished;
  }
}

}  // namespace host_sim::monitor
