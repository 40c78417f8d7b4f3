#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "firmware/app/config.hpp"
#include "firmware/app/life_book.hpp"
#include "firmware/app/rainflow_bins.hpp"
#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "firmware/storage/save_policy.hpp"
#include "hal/can_port.hpp"
#include "lifemodel/life/conditional.hpp"

namespace app {

/// How the node is, apart from the lives.
struct NodeState {
  std::uint32_t configuration = 0;  ///< CRC-32 over the configurations of all tendons
  bool trusted = false;             ///< no record of the past was lost
  bool sensor_ok = false;
  bool storage_ok = false;
  bool locked = false;                  ///< the drive is held off
  std::uint32_t sequence = 0;           ///< of the last save
  std::uint32_t unsaved_ppb = 0;        ///< rounded up, as are all that follow
  std::uint32_t worst_unsaved_ppb = 0;  ///< since the start
  protocol::detail::Timing timing;
  hal::CanStatus bus;
  std::uint8_t dropped = 0;   ///< detail pages
  std::uint16_t refused = 0;  ///< frames and commands
};

/// Turns what the node knows into messages.
template <std::size_t kTendons>
class Reporter {
 public:
  using Bins = std::array<RainflowBins, kTendons>;

  Reporter(const LifeBook<kTendons>& book, const Bins& bins, const NodeState& node_state)
      : book_(book), bins_(bins), node_state_(node_state) {}

  [[nodiscard]] protocol::LifeStatus status() const {
    using lifemodel::Flag;
    const std::size_t worst = book_.worst();
    const lifemodel::Flags flags = book_.flags();
    return {.state = node_state_.trusted ? book_.state() : protocol::LifeState::unknown,
            .damage_ppb = book_.damage_ppb(worst),
            .worst_tendon = static_cast<std::uint8_t>(worst),
            .quality = quality(flags, node_state_.trusted && node_state_.sensor_ok),
            .storage_ok = node_state_.storage_ok,
            .sensor_ok = node_state_.sensor_ok,
            .gap = flags.has(Flag::gap),
            .saturated = flags.has(Flag::saturated),
            .overrun = flags.has(Flag::overrun),
            .locked = node_state_.locked,
            .broken = book_.broken() != 0,
            .slack = book_.slack() != 0};
  }

  /// Damage of the worst tendon, rounded down.
  [[nodiscard]] std::uint32_t damage_ppm() const { return book_.damage_ppb(book_.worst()) / 1000; }

  /// True while a status would show a damage that is further ahead of the store than the last
  /// storage page said, and the page could say more.
  [[nodiscard]] bool unsaved_to_publish() const {
    return node_state_.worst_unsaved_ppb > published_unsaved_ppb_ &&
           published_unsaved_ppb_ < kMostPublished_ppb;
  }

  /// Hands the message of a page to `send`, which returns whether it has left, and returns that.
  /// A page that there is not does not leave.
  template <class Send>
  bool with_page(std::uint8_t page, Send&& send) {
    using namespace protocol::detail;
    switch (page) {
      case Identity::kPage:
        return send(Identity{protocol::schema::kSchemaVersion, kFirmwareVersion,
                             node_state_.configuration});
      case Cycles::kPage:
        return send(Cycles{book_.cycles(), book_.cycles_per_min()});
      case DamageRate::kPage:
        return send(damage_rate());
      case TendonDamage::kPage:
        return send_tendon(send);
      case RainflowBin::kPage:
        return send_bin(send);
      case RemainingLife::kPage:
        return send(remaining_life());
      case ConditionalLife::kPage:
        return send(conditional_life(shortest_lived()));
      case BreakRisk::kPage:
        return send(break_risk(shortest_lived()));
      case Storage::kPage:
        return send_storage(send);
      case Timing::kPage:
        return send(node_state_.timing);
      case Bus::kPage:
        return send(bus());
      case WireHistory::kPage:
        return send_history(send);
      case Advice::kPage:
        return send_advice(send);
    }
    return false;
  }

 private:
  [[nodiscard]] protocol::detail::DamageRate damage_rate() const {
    constexpr std::uint32_t kHighest = std::numeric_limits<std::uint16_t>::max();
    const std::uint32_t unsaved_ppb = node_state_.unsaved_ppb;
    return {book_.rates(book_.worst()).damage_ppb_per_h(),
            static_cast<std::uint16_t>(unsaved_ppb < kHighest ? unsaved_ppb : kHighest)};
  }

  /// The tendons in turn.
  template <class Send>
  bool send_tendon(Send& send) {
    const std::size_t tendon = tendon_;
    const bool left = send(protocol::detail::TendonDamage{
        static_cast<std::uint8_t>(tendon), book_.damage_ppb(tendon), book_.state(tendon)});
    tendon_ = left ? (tendon + 1) % kTendons : tendon;
    return left;
  }

  /// The tendons in turn, each with all that is counted of its wire.
  template <class Send>
  bool send_history(Send& send) {
    using protocol::WireEvent;
    constexpr std::uint32_t kEvents = 4;
    const std::size_t tendon = wire_ / kEvents;
    const auto event = static_cast<WireEvent>(wire_ % kEvents);
    const storage::WireHistory& history = book_.records()[tendon].history;
    const auto stopped = [](std::uint32_t value, std::uint32_t most) {
      return static_cast<std::uint16_t>(value < most ? value : most);
    };
    const std::uint32_t count = event == WireEvent::above_50   ? history.above_50
                                : event == WireEvent::above_70 ? history.above_70
                                : event == WireEvent::above_90 ? history.above_90
                                                               : history.slack_events;
    // 100 / 2^29, rounded up.
    const std::uint32_t percent = (history.peak / 32 * 25 + ((1u << 22) - 1)) >> 22;
    const bool left = send(protocol::detail::WireHistory{
        .tendon = static_cast<std::uint8_t>(tendon),
        .broken = history.broken,
        .slack = ((book_.slack() >> tendon) & 1u) != 0,
        .peak_percent = static_cast<std::uint8_t>(stopped(percent, 0xff)),
        .event = event,
        .count = stopped(count, 0x3fff),
        .below_minimum_min = stopped(history.below_minimum_s / 60, 0xffff)});
    wire_ = left ? (wire_ + 1) % (kTendons * kEvents) : wire_;
    return left;
  }

  /// The tendons in turn.
  template <class Send>
  bool send_advice(Send& send) {
    using protocol::AdviceState;
    protocol::detail::Advice page;
    const Derating& derating = book_.derating(advised_);
    page.tendon = static_cast<std::uint8_t>(advised_);
    page.state = derating.state();
    if (page.state != AdviceState::off && page.state != AdviceState::unknown) {
      const auto in_steps = [](lifemodel::Ratio ratio) {
        return static_cast<std::uint16_t>(
            (std::uint64_t{ratio.raw()} * protocol::detail::Advice::kWhole) >>
            lifemodel::Ratio::kFractionBits);
      };
      page.highest_tension = in_steps(derating.advice().tension);
      page.pace = in_steps(derating.advice().pace);
    }
    const bool left = send(page);
    advised_ = left ? (advised_ + 1) % kTendons : advised_;
    return left;
  }

  /// The bins that have something to report in turn; where none has, the first.
  template <class Send>
  bool send_bin(Send& send) {
    constexpr std::uint32_t kAll = kTendons * RainflowBins::kBins;
    std::uint32_t position = bin_;
    for (std::uint32_t seen = 0;
         seen < kAll && !bins(position).reported(position % RainflowBins::kBins); ++seen) {
      position = position + 1 < kAll ? position + 1 : 0;
    }
    const std::uint32_t bin = position % RainflowBins::kBins;
    const bool left = send(protocol::detail::RainflowBin{
        .tendon = static_cast<std::uint8_t>(position / RainflowBins::kBins),
        .range_class = static_cast<std::uint8_t>(bin / RainflowBins::kClasses),
        .mean_class = static_cast<std::uint8_t>(bin % RainflowBins::kClasses),
        .half_cycles = bins(position).half_cycles(bin),
        .cycles = bins(position).cycles(bin)});
    if (left) {
      bin_ = position + 1 < kAll ? position + 1 : 0;
    }
    return left;
  }
  [[nodiscard]] const RainflowBins& bins(std::uint32_t position) const {
    return bins_[position / RainflowBins::kBins];
  }

  /// Of the tendon that has the least left of its whole life.
  [[nodiscard]] protocol::detail::RemainingLife remaining_life() const {
    protocol::detail::RemainingLife least;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      const auto& life = book_.distribution(tendon);
      if (!life) {
        continue;
      }
      const Rates& rates = book_.rates(tendon);
      const lifemodel::Damage& used = book_.damage(tendon);
      const std::uint16_t b10_dh = rates.remaining_dh(used, life->b10);
      const std::uint16_t b90_dh = rates.remaining_dh(used, life->b90);
      if (b10_dh < least.b10_dh || (b10_dh == least.b10_dh && b90_dh < least.b90_dh)) {
        least = {b10_dh, rates.remaining_dh(used, life->b50), b90_dh};
      }
    }
    return least;
  }

  /// The tendon that has the least left given that it is whole: the one with the highest damage
  /// until rates are known.
  [[nodiscard]] std::size_t shortest_lived() const {
    std::size_t shortest = book_.worst();
    std::uint16_t least_dh = protocol::detail::ConditionalLife::kUnknown;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      const std::uint16_t dh = lasts_dh(tendon, lifemodel::kHazard10);
      if (dh < least_dh) {
        least_dh = dh;
        shortest = tendon;
      }
    }
    return shortest;
  }
  /// Tenths of an hour until the tendon, which is whole now, has broken at this hazard.
  [[nodiscard]] std::uint16_t lasts_dh(std::size_t tendon, lifemodel::Hazard hazard) const {
    const auto& life = book_.distribution(tendon);
    if (!life || !book_.rates(tendon).known()) {
      return protocol::detail::ConditionalLife::kUnknown;
    }
    return book_.rates(tendon).lasts_dh(
        lifemodel::further_damage(life->shape, book_.damage(tendon), hazard));
  }
  [[nodiscard]] protocol::detail::ConditionalLife conditional_life(std::size_t tendon) const {
    return {lasts_dh(tendon, lifemodel::kHazard10), lasts_dh(tendon, lifemodel::kHazard50),
            lasts_dh(tendon, lifemodel::kHazard90)};
  }
  /// In whole hours, rounded up; as many as the field holds.
  [[nodiscard]] std::uint8_t horizon_h(std::size_t tendon) const {
    constexpr std::uint32_t kHighest = std::numeric_limits<std::uint8_t>::max();
    const std::uint32_t seconds = book_.outlook(tendon).horizon_s;
    const std::uint32_t hours = seconds / 3600 + (seconds % 3600 != 0 ? 1 : 0);
    return static_cast<std::uint8_t>(std::clamp(hours, std::uint32_t{1}, kHighest));
  }
  [[nodiscard]] protocol::detail::BreakRisk break_risk(std::size_t tendon) const {
    using protocol::detail::BreakRisk;
    BreakRisk result;
    result.horizon_h = horizon_h(tendon);
    const auto& life = book_.distribution(tendon);
    const Rates& rates = book_.rates(tendon);
    if (life && rates.known()) {
      const lifemodel::Ratio risk = lifemodel::break_risk(life->shape, book_.damage(tendon),
                                                          rates.damage_in(result.horizon_h));
      constexpr std::uint64_t kOne = lifemodel::Ratio::highest().raw();
      result.within_horizon =
          static_cast<std::uint16_t>((std::uint64_t{risk.raw()} * BreakRisk::kSure + kOne - 1) >>
                                     lifemodel::Ratio::kFractionBits);
      bound(result, tendon, life->shape);
    }
    return result;
  }

  /// Fills the ends of the interval, where the model says how sure its fit is and the load was seen
  /// long enough.
  void bound(protocol::detail::BreakRisk& page, std::size_t tendon,
             lifemodel::WeibullShape shape) const {
    using protocol::detail::BreakRisk;
    const Outlook& outlook = book_.outlook(tendon);
    const Rates& rates = book_.rates(tendon);
    const storage::LifeRecord& record = book_.records()[tendon];
    if (!outlook.fit.known() || !rates.spread_known() || record.epoch_cycles == 0 ||
        record.epoch_damage.none()) {
      return;
    }
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    const auto cycles = static_cast<std::uint32_t>(std::min(record.epoch_cycles, kMost));
    const lifemodel::numeric::Normal count = lifemodel::numeric::normal(cycles, 0);
    const std::int64_t log2_each =
        lifemodel::log2_of(record.epoch_damage) - lifemodel::numeric::log2(count);
    constexpr int kDrop = lifemodel::numeric::kLogBits - lifemodel::numeric::kExpBits;
    const lifemodel::LifeSpread spread{
        .life = lifemodel::life_spread(outlook.fit, outlook.wanted.law.exponent,
                                       static_cast<std::int32_t>(log2_each >> kDrop)),
        .shape = outlook.fit.log2_shape,
        .load = rates.load_spread()};
    const auto interval = lifemodel::further_damage_interval(shape, record.epoch_damage,
                                                             lifemodel::kHazard10, spread);
    page.to_10_low_30min = below(BreakRisk::kUnknownBound, rates.lasts_30min(interval.low));
    page.to_10_high_30min =
        below(BreakRisk::kUnknownBound, std::uint64_t{rates.lasts_30min(interval.high)} + 1);
  }

  /// At least a step of the save policy, and a quarter of headroom over what was seen, so that a
  /// damage that grows for a minute does not fill the bus with storage pages.
  template <class Send>
  bool send_storage(Send& send) {
    std::uint32_t bound_ppb = published_unsaved_ppb_;
    if (node_state_.worst_unsaved_ppb > bound_ppb) {
      const std::uint32_t worst_ppb = std::min(node_state_.worst_unsaved_ppb, kMostPublished_ppb);
      bound_ppb = std::max(worst_ppb + worst_ppb / 4, storage::SavePolicy::kStep_ppb);
      bound_ppb = std::min(bound_ppb, kMostPublished_ppb);
    }
    const bool left = send(protocol::detail::Storage{node_state_.sequence, bound_ppb});
    published_unsaved_ppb_ = left ? bound_ppb : published_unsaved_ppb_;
    return left;
  }

  [[nodiscard]] protocol::detail::Bus bus() const {
    constexpr std::uint32_t kHighest = std::numeric_limits<std::uint8_t>::max();
    const std::uint32_t bus_offs = node_state_.bus.bus_offs;
    return {.transmit_errors = node_state_.bus.transmit_errors,
            .receive_errors = node_state_.bus.receive_errors,
            .bus_offs = static_cast<std::uint8_t>(bus_offs < kHighest ? bus_offs : kHighest),
            .dropped = node_state_.dropped,
            .refused = node_state_.refused};
  }

  /// What the field of the storage page holds.
  static constexpr std::uint32_t kMostPublished_ppb = (1u << 24) - 1;

  const LifeBook<kTendons>& book_;
  const Bins& bins_;
  const NodeState& node_state_;
  std::size_t tendon_ = 0;
  std::uint32_t bin_ = 0;
  std::uint32_t wire_ = 0;
  std::size_t advised_ = 0;
  std::uint32_t published_unsaved_ppb_ = 0;
};

}  // namespace app
