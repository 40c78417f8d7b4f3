#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "host_sim/monitor/fleet/damage_watch.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"
#include "host_sim/monitor/fleet/stream_watch.hpp"
#include "host_sim/monitor/fleet/wire_lives.hpp"

namespace host_sim::monitor {

/// Follows one node from its frames, and keeps its view.
class NodeWatch {
 public:
  /// `view` outlives the watch.
  explicit NodeWatch(NodeView& view);

  /// A frame of the kind with this number in schema::kFrames. @pre it is of this node
  void take(std::size_t kind, const hal::CanFrame& frame, std::int64_t time_ns);
  /// Whether it has vanished, for a bus that is heard: silence of one that is not shows nothing of
  /// the node. `heard_from_ns`: since when the bus can be heard.
  void look_for_silence(std::int64_t now_ns, std::int64_t heard_from_ns);
  /// Marks what is too old.
  void mark_stale(std::int64_t now_ns);

  [[nodiscard]] bool known() const { return known_; }

 private:
  void take_heartbeat(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& stream);
  void take_status(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& stream);
  void take_storage(const protocol::detail::Storage& storage);
  void take_tendon(const protocol::detail::TendonDamage& tendon, std::int64_t time_ns);
  void follow_wires(const hal::CanFrame& frame, std::int64_t time_ns);
  void look_for_a_second_speaker(std::int64_t time_ns);
  void take_of_two(std::size_t kind, const hal::CanFrame& frame, std::int64_t time_ns);
  void break_runs(std::size_t kind);
  void take_detail(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& stream);
  void take_emergency(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& stream);
  void show_damage(std::int64_t time_ns);
  void is_alive(std::int64_t time_ns);
  void was_damaged(std::int64_t time_ns, const StreamView& stream);
  void note(EventKind kind, std::int64_t time_ns, std::string text);

  NodeView& view_;
  std::vector<StreamWatch> streams_;
  DamageWatch damage_;
  std::map<std::uint8_t, DamageWatch> tendons_;
  WireLives wires_;
  DamageCurve curve_;
  bool known_ = false;
  int heartbeats_ = 0;
  std::optional<std::int64_t> last_damaged_ns_;
};

}  // namespace host_sim::monitor
