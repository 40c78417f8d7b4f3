// Whatever becomes of the frames of a node on their way, no damage is shown that no genuine frame
// told. Damaged frames have up to three wrong bits of data, which the protection finds for certain,
// or wrong bits of their identifier.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "host_sim/monitor/fleet/fleet.hpp"
#include "tests/monitor/fleet/sender.hpp"

namespace host_sim::monitor {
namespace {

using test::kMs;

struct Traffic {
  std::vector<SeenFrame> frames;
  std::set<std::uint32_t> damages_ppb{0};
  std::set<std::uint32_t> tendon_damages_ppb;
};

Traffic genuine_traffic() {
  Traffic traffic;
  test::Sender sender(static_cast<protocol::Node>(*rc::gen::inRange(1, 128)));
  auto damage_ppb = *rc::gen::inRange<std::uint32_t>(0, 2'000'000'000);
  const int count = *rc::gen::inRange(1, 120);
  for (int i = 0; i < count; ++i) {
    const std::int64_t time_ns = i * 100 * kMs;
    damage_ppb = *rc::gen::inRange(0, 40) == 0
                     ? 0
                     : damage_ppb + *rc::gen::inRange<std::uint32_t>(0, 1'000'000);
    traffic.damages_ppb.insert(damage_ppb);
    traffic.frames.push_back(sender.damage(time_ns, damage_ppb));
    if (i % 9 == 3) {
      traffic.tendon_damages_ppb.insert(damage_ppb);
      traffic.frames.push_back(sender.page(
          time_ns, protocol::detail::TendonDamage{.tendon = 1, .damage_ppb = damage_ppb}));
    }
    if (i % 10 == 0) {
      traffic.frames.push_back(sender.heartbeat(time_ns));
      const std::uint32_t damage_ppm = damage_ppb / 1000;
      traffic.damages_ppb.insert(damage_ppm * 1000);
      traffic.frames.push_back(sender.emergency(time_ns, {.code = protocol::EmergencyCode::overload,
                                                          .error_register = 0,
                                                          .damage_ppm = damage_ppm}));
    }
  }
  return traffic;
}

void damage(SeenFrame& seen) {
  if (*rc::gen::inRange(0, 4) == 0) {
    seen.frame.id ^= *rc::gen::inRange<std::uint32_t>(1, 0x800);
    return;
  }
  if (seen.frame.length < 8) {
    return;  // a heartbeat tells no damage
  }
  const auto bits = *rc::gen::unique<std::vector<int>>(
      static_cast<std::size_t>(*rc::gen::inRange(1, 4)), rc::gen::inRange(0, 64));
  for (const int bit : bits) {
    seen.frame.data[static_cast<std::size_t>(bit / 8)] ^= std::byte{1} << (bit % 8);
  }
}

/// What arrives of `sent`, at the times at which it arrives.
std::vector<SeenFrame> spoiled(const std::vector<SeenFrame>& sent) {
  std::vector<SeenFrame> arrived;
  for (const SeenFrame& frame : sent) {
    switch (*rc::gen::inRange(0, 8)) {
      case 0:
        break;
      case 1:
        arrived.insert(arrived.end(), 2, frame);
        break;
      case 2:
        arrived.push_back(frame);
        damage(arrived.back());
        break;
      default:
        arrived.push_back(frame);
    }
    if (arrived.size() >= 2 && *rc::gen::inRange(0, 6) == 0) {
      const auto back =
          *rc::gen::inRange<std::size_t>(2, std::min<std::size_t>(arrived.size(), 12) + 1);
      std::swap(arrived.back(), arrived[arrived.size() - back]);
    }
  }
  std::int64_t time_ns = 0;
  for (SeenFrame& frame : arrived) {
    time_ns += *rc::gen::element<std::int64_t>(0, 10, 50, 100, 900) * kMs;
    frame.time_ns = time_ns;
  }
  return arrived;
}

RC_GTEST_PROP(FleetProperty, ShowsNoDamageThatNoGenuineFrameTold, ()) {
  const Traffic traffic = genuine_traffic();
  Fleet fleet;
  for (const SeenFrame& frame : spoiled(traffic.frames)) {
    fleet.see(frame);
    for (const auto& [number, node] : fleet.view().nodes) {
      RC_ASSERT(traffic.damages_ppb.contains(node.highest_damage_ppb));
      if (node.status) {
        RC_ASSERT(traffic.damages_ppb.contains(node.status->value.damage_ppb));
      }
      for (const auto& [tendon, value] : node.tendons) {
        RC_ASSERT(tendon == 1);
        RC_ASSERT(traffic.tendon_damages_ppb.contains(value.value.damage_ppb));
      }
      for (const DamagePoint& point : node.curve) {
        RC_ASSERT(traffic.damages_ppb.contains(point.damage_ppb));
      }
    }
  }
}

}  // namespace
}  // namespace host_sim::monitor
