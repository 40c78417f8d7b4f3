#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "tests/monitor/fleet/sender.hpp"

namespace host_sim::monitor::test {

/// A node whose life is made up: its damage grows steadily, and it tells all that a controller
/// tells.
class MadeNode {
 public:
  using Take = std::function<void(const SeenFrame&)>;

  explicit MadeNode(protocol::Node node);

  /// All frames of the 100 ms from `time_ns` on.
  void run(std::int64_t time_ns, const Take& take);

  bool silent = false;
  bool corrupt = false;  ///< a bit of each frame is turned over on the way
  protocol::EmergencyCode emergency = protocol::EmergencyCode::none;
  double damage = 0;  ///< of the worst tendon

 private:
  void send(SeenFrame frame, const Take& take) const;
  void send_page(std::int64_t time_ns, const Take& take);
  [[nodiscard]] std::uint32_t ppb(double share) const;
  [[nodiscard]] std::uint16_t left_dh(double end) const;
  [[nodiscard]] protocol::LifeState state_at(double share) const;

  protocol::Node node_;
  Sender sender_;
  double rate_per_h_;
  std::uint32_t steps_ = 0;
  std::uint32_t pages_ = 0;
  protocol::EmergencyCode told_ = protocol::EmergencyCode::none;
};

/// A bus of nodes 1 to `nodes`.
class MadeBus {
 public:
  explicit MadeBus(int nodes);

  /// 100 ms of all nodes, in order of time.
  void run(std::int64_t time_ns, const MadeNode::Take& take);
  MadeNode& node(int number) { return nodes_.at(static_cast<protocol::Node>(number)); }

 private:
  std::map<protocol::Node, MadeNode> nodes_;
};

}  // namespace host_sim::monitor::test
