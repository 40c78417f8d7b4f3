#include "host_sim/monitor/fleet/fleet.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "firmware/protocol/codec.hpp"
#include "host_sim/monitor/fleet/bus_load.hpp"
#include "host_sim/monitor/fleet/node_watch.hpp"

namespace host_sim::monitor {
namespace {

using protocol::schema::kFrames;

/// Nodes that have fallen silent are looked for so often while frames come.
constexpr std::int64_t kLookAgain_ns = 50'000'000;

/// A frame of the plan.
struct PlannedFrame {
  std::size_t number = 0;  ///< in schema::kFrames
  protocol::Node node = 0;
};

std::optional<PlannedFrame> planned_frame(const hal::CanFrame& frame) {
  for (std::size_t number = 0; number < kFrames.size(); ++number) {
    if (const auto node = protocol::node_of(*kFrames[number], frame)) {
      return PlannedFrame{number, *node};
    }
  }
  return std::nullopt;
}

bool is_data(const SeenFrame& seen) {
  return !seen.error && !seen.flexible_data_rate && !seen.remote_request;
}

}  // namespace

struct Fleet::Impl {
  explicit Impl(double bit_rate_bit_s) : load(bit_rate_bit_s) {
    view.bit_rate_bit_s = bit_rate_bit_s;
  }

  void take_error(const BusError& error) {
    ++view.error_frames;
    view.receive_overflows += error.receive_overflow ? 1u : 0u;
    view.bus_off = (view.bus_off && !error.restarted) || error.bus_off;
  }

  NodeWatch& watch_of(protocol::Node node) {
    if (const auto found = watches.find(node); found != watches.end()) {
      return found->second;
    }
    NodeView& node_view = unknown[node];
    node_view.node = node;
    return watches.try_emplace(node, node_view).first->second;
  }

  void take_data(const SeenFrame& seen) {
    const auto planned = planned_frame(seen.frame);
    if (!planned) {
      ++view.foreign_frames;
      return;
    }
    NodeWatch& watch = watch_of(planned->node);
    watch.take(planned->number, seen.frame, seen.time_ns);
    if (watch.known() && unknown.contains(planned->node)) {
      view.nodes.insert(unknown.extract(planned->node));  // keeps its place in memory
    } else if (!watch.known()) {
      ++view.foreign_frames;
    }
  }

  void look_for_silence() {
    looked_ns = view.now_ns;
    if (view.source_lost) {
      return;
    }
    for (auto& [node, watch] : watches) {
      watch.look_for_silence(view.now_ns, heard_from_ns);
    }
  }

  void advance(std::int64_t now_ns) {
    view.now_ns = std::max(view.now_ns, now_ns);
    if (!looked_ns || view.now_ns - *looked_ns >= kLookAgain_ns) {
      look_for_silence();
    }
  }

  void show_load() {
    load.advance(view.now_ns);
    view.bus_load_percent = load.percent();
    view.frames_per_s = load.frames_per_s();
  }

  FleetView view;
  std::map<protocol::Node, NodeView> unknown;
  std::map<protocol::Node, NodeWatch> watches;
  BusLoad load;
  std::optional<std::int64_t> looked_ns;
  std::int64_t heard_from_ns = std::numeric_limits<std::int64_t>::min();
};

Fleet::Fleet(double bit_rate_bit_s) : impl_(std::make_unique<Impl>(bit_rate_bit_s)) {}

Fleet::~Fleet() = default;

void Fleet::see(const SeenFrame& seen) {
  impl_->advance(seen.time_ns);
  impl_->view.receive_overflows += seen.lost_before;
  if (seen.error) {
    impl_->take_error(*seen.error);
  } else {
    ++impl_->view.frames;
    impl_->load.add(impl_->view.now_ns, bits_on_bus(seen));
    if (is_data(seen)) {
      impl_->take_data(seen);
    } else {
      ++impl_->view.foreign_frames;
    }
  }
  impl_->show_load();
}

void Fleet::tick(std::int64_t now_ns) {
  impl_->view.now_ns = std::max(impl_->view.now_ns, now_ns);
  impl_->look_for_silence();
  for (auto& [node, watch] : impl_->watches) {
    watch.mark_stale(impl_->view.now_ns);
  }
  impl_->show_load();
}

void Fleet::source_is(FrameSource::State state, const std::string& description) {
  const bool lost = state == FrameSource::State::lost;
  if (impl_->view.source_lost && !lost) {
    impl_->heard_from_ns = impl_->view.now_ns;
    impl_->view.bus_off = false;  // an interface that comes up begins anew
  }
  impl_->view.source_lost = lost;
  impl_->view.source_ended = state == FrameSource::State::ended;
  impl_->view.source = description;
}

const FleetView& Fleet::view() const {
  return impl_->view;
}

}  // namespace host_sim::monitor
