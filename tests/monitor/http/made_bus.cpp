#include "tests/monitor/http/made_bus.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace host_sim::monitor::test {
namespace {

constexpr double kReplace = 0.4;
constexpr double kWorn = 0.8;
constexpr double kLast = 1.2;
constexpr std::uint32_t kTendons = 4;
constexpr double kStep_h = 0.1 / 3600;

std::uint8_t u8(std::uint32_t value) {
  return static_cast<std::uint8_t>(value);
}

}  // namespace

MadeNode::MadeNode(protocol::Node node)
    : damage(0.07 * (node % 13)), node_(node), sender_(node), rate_per_h_(0.25 + 0.07 * node) {}

void MadeNode::send(SeenFrame frame, const Take& take) const {
  if (corrupt) {
    frame.frame.data[frame.frame.length - 1u] ^= std::byte{0x10};
  }
  if (!silent) {
    take(frame);
  }
}

std::uint32_t MadeNode::ppb(double share) const {
  return static_cast<std::uint32_t>(std::lround(1e9 * share));
}

std::uint16_t MadeNode::left_dh(double end) const {
  const double left = std::max(0.0, (end - damage) / rate_per_h_ * 10);
  return static_cast<std::uint16_t>(std::min(left, 65535.0));
}

protocol::LifeState MadeNode::state_at(double share) const {
  using protocol::LifeState;
  return share >= kWorn          ? LifeState::worn
         : share >= kReplace     ? LifeState::replace
         : share >= kReplace / 2 ? LifeState::inspect
                                 : LifeState::normal;
}

void MadeNode::run(std::int64_t time_ns, const Take& take) {
  damage += rate_per_h_ * kStep_h;
  if (steps_++ % 10 == 0) {
    SeenFrame beat = sender_.heartbeat(time_ns);
    if (!silent) {
      take(beat);
    }
  }
  if (emergency != told_) {
    told_ = emergency;
    send(sender_.emergency(time_ns + kMs,
                           {.code = emergency,
                            .error_register = u8(told_ == decltype(told_)::none ? 0 : 1),
                            .damage_ppm = ppb(damage) / 1000}),
         take);
  }
  send(sender_.status(time_ns + 2 * kMs, {.state = state_at(damage),
                                          .damage_ppb = ppb(damage),
                                          .worst_tendon = u8(node_ % kTendons),
                                          .storage_ok = true,
                                          .sensor_ok = true,
                                          .gap = node_ % 4 == 0}),
       take);
  send_page(time_ns + 50 * kMs, take);
}

void MadeNode::send_page(std::int64_t time_ns, const Take& take) {
  namespace detail = protocol::detail;
  const std::uint32_t turn = pages_ / detail::kPages;
  const auto page = [&](const auto& content) { send(sender_.page(time_ns, content), take); };
  switch (pages_++ % detail::kPages) {
    case detail::Identity::kPage:
      return page(detail::Identity{1, 0x12, 0xc0ffee00u + node_});
    case detail::Cycles::kPage:
      return page(detail::Cycles{123 * steps_, u8(60u + node_)});
    case detail::DamageRate::kPage:
      return page(detail::DamageRate{ppb(rate_per_h_), u8(7u * node_)});
    case detail::TendonDamage::kPage: {
      const std::uint32_t tendon = turn % kTendons;
      const double share = tendon == node_ % kTendons ? damage : damage * (0.3 + 0.1 * tendon);
      return page(detail::TendonDamage{u8(tendon), ppb(share), state_at(share)});
    }
    case detail::RainflowBin::kPage:
      return page(detail::RainflowBin{u8(turn % kTendons), u8(turn / kTendons % 8),
                                      u8(turn / 3 % 8), 10 * (turn + 1) * (1 + turn % 7)});
    case detail::RemainingLife::kPage:
      return page(detail::RemainingLife{left_dh(kReplace), left_dh(kWorn), left_dh(kLast)});
    case detail::Storage::kPage:
      return page(detail::Storage{1000u + turn, 500u * node_});
    case detail::Timing::kPage:
      return page(detail::Timing{u8(100 + node_), u8(20 + node_), u8(turn % 3)});
    default:
      return page(detail::Bus{u8(node_), u8(2u * node_), 1, 3, u8(turn % 5)});
  }
}

MadeBus::MadeBus(int nodes) {
  for (int number = 1; number <= nodes; ++number) {
    nodes_.emplace(number, MadeNode(static_cast<protocol::Node>(number)));
  }
}

void MadeBus::run(std::int64_t time_ns, const MadeNode::Take& take) {
  std::vector<SeenFrame> frames;
  std::int64_t apart_ns = 0;
  for (auto& [number, node] : nodes_) {
    node.run(time_ns + apart_ns, [&](const SeenFrame& frame) { frames.push_back(frame); });
    apart_ns += kMs / 4;
  }
  std::stable_sort(frames.begin(), frames.end(), [](const SeenFrame& one, const SeenFrame& other) {
    return one.time_ns < other.time_ns;
  });
  std::for_each(frames.begin(), frames.end(), take);
}

}  // namespace host_sim::monitor::test
