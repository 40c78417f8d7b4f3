#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "firmware/protocol/messages.hpp"

namespace host_sim::monitor {

/// How long a wire was seen to live: it broke, or gave its place to a new one while it was whole.
struct WireLife {
  std::uint8_t tendon = 0;
  bool broken = false;
  std::int64_t time_ns = 0;
  std::uint32_t damage_ppb = 0;  ///< of its epoch; at the end of its range it is not known
  /// Closed ones and half of the open halves, or closed ones alone; none while they are not known.
  std::optional<double> cycles;
};

/// The ends of the wires of one node, and the cycles that they had then. No page has the cycles of
/// one tendon over restarts. They are known
///   - where the node has one tendon: page Cycles counts its epoch
///   - when a new epoch begins: Cycles, of all tendons, falls by what the old wire had
///   - where the bins, which begin anew at each start, hold all that Cycles counts: those of the
///     tendon
/// and else not.
class WireLives {
 public:
  static constexpr std::size_t kMost = 1000;

  /// What ended, in the order in which it was heard, the first kMost; the cycles of one may come to
  /// be known later.
  [[nodiscard]] const std::vector<WireLife>& ended() const { return ended_; }

  void take(const protocol::detail::TendonDamage& page);
  void take(const protocol::detail::Cycles& page);
  void take(const protocol::detail::RainflowBin& page);
  /// @param damage_ppb of the tendon now
  void take(const protocol::detail::WireHistory& page, std::uint32_t damage_ppb,
            std::int64_t time_ns);
  /// A new epoch of the tendon is proven; the old one ended at this damage.
  void epoch_opened(std::uint8_t tendon, std::uint32_t damage_before_ppb, std::int64_t time_ns);
  /// The node has started, or was not heard for so long that it may have.
  void restarted();

 private:
  struct Wire {
    bool whole = false;                ///< was reported so in this epoch
    bool broken = false;               ///< was reported so in this epoch
    std::optional<std::size_t> ended;  ///< its break in ended_
  };

  void settle();
  [[nodiscard]] std::optional<double> cycles_of(std::uint8_t tendon) const;

  std::vector<WireLife> ended_;
  std::map<std::uint8_t, Wire> wires_;
  std::optional<std::uint8_t> tendon_;  ///< of the last page TendonDamage
  bool in_turn_ = false;                ///< pages TendonDamage follow each other
  bool several_ = false;                ///< and are not of one tendon
  std::optional<std::uint32_t> cycles_;
  std::vector<std::uint32_t> falls_;  ///< of cycles_, since the last new epoch
  /// Of this start, by 64 tendon + bin.
  std::map<std::uint32_t, protocol::detail::RainflowBin> bins_;
};

}  // namespace host_sim::monitor
