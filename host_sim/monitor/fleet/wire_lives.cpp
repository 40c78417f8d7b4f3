#include "host_sim/monitor/fleet/wire_lives.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "firmware/protocol/schema/plan.hpp"

namespace host_sim::monitor {

namespace detail = protocol::detail;

void WireLives::take(const detail::TendonDamage& page) {
  in_turn_ = tendon_.has_value();
  several_ = several_ || (tendon_ && *tendon_ != page.tendon);
  tendon_ = page.tendon;
}

void WireLives::take(const detail::Cycles& page) {
  if (is_at_least(protocol::schema::signal_of(&detail::Cycles::cycles), page.cycles)) {
    cycles_.reset();
    return;
  }
  if (cycles_ && page.cycles < *cycles_) {
    falls_.push_back(*cycles_ - page.cycles);
  }
  cycles_ = page.cycles;
  settle();
}

void WireLives::take(const detail::RainflowBin& page) {
  bins_[64u * page.tendon + 8u * page.range_class + page.mean_class] = page;
  settle();
}

void WireLives::take(const detail::WireHistory& page, std::uint32_t damage_ppb,
                     std::int64_t time_ns) {
  Wire& wire = wires_[page.tendon];
  const bool breaks = page.broken && wire.whole && !wire.broken;
  wire.whole = wire.whole || !page.broken;
  wire.broken = wire.broken || page.broken;
  if (breaks && ended_.size() < kMost) {
    wire.ended = ended_.size();
    ended_.push_back({.tendon = page.tendon,
                      .broken = true,
                      .time_ns = time_ns,
                      .damage_ppb = damage_ppb,
                      .cycles = {}});
    settle();
  }
}

void WireLives::epoch_opened(std::uint8_t tendon, std::uint32_t damage_before_ppb,
                             std::int64_t time_ns) {
  const std::optional<double> cycles =
      falls_.size() == 1 ? std::optional<double>(falls_.front()) : std::nullopt;
  falls_.clear();
  const Wire wire =
      std::exchange(wires_[tendon], Wire{.whole = true, .broken = false, .ended = {}});
  if (wire.ended) {
    if (!ended_[*wire.ended].cycles) {
      ended_[*wire.ended].cycles = cycles;
    }
  } else if (!wire.broken && ended_.size() < kMost) {
    ended_.push_back({.tendon = tendon,
                      .broken = false,
                      .time_ns = time_ns,
                      .damage_ppb = damage_before_ppb,
                      .cycles = cycles});
  }
}

void WireLives::restarted() {
  cycles_.reset();
  falls_.clear();
  bins_.clear();
}

void WireLives::settle() {
  for (const auto& [tendon, wire] : wires_) {
    if (wire.ended && !ended_[*wire.ended].cycles) {
      ended_[*wire.ended].cycles = cycles_of(tendon);
    }
  }
}

std::optional<double> WireLives::cycles_of(std::uint8_t tendon) const {
  if (!cycles_) {
    return std::nullopt;
  }
  if (in_turn_ && !several_) {
    return *cycles_;
  }
  // Bins come in turn, so they lag a little behind Cycles.
  constexpr double kLag = 0.01;
  double closed = 0;
  double of_tendon = 0;
  for (const auto& [bin, page] : bins_) {
    closed += page.cycles;
    of_tendon += page.tendon == tendon ? page.cycles + page.half_cycles / 2.0 : 0;
  }
  return std::abs(closed - *cycles_) <= kLag * *cycles_ ? std::optional(of_tendon) : std::nullopt;
}

}  // namespace host_sim::monitor
