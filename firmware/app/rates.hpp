#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/protocol/messages.hpp"
#include "hal/clock.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/life/interval.hpp"
#include "lifemodel/life/weibull.hpp"

namespace app {

/// A value for a field whose highest value stands for unknown; stops below that.
template <class Field>
constexpr Field below(Field unknown, std::uint64_t value) {
  return value < unknown ? static_cast<Field>(value) : static_cast<Field>(unknown - 1);
}

/// Damage, cycles and peak of one tendon over the last minute, from readings since the start, which
/// never fall.
class Rates {
 public:
  static constexpr std::size_t kSlots = 6;
  static constexpr hal::Time kSlot = hal::seconds(10);

  void start(hal::Time now) { next_ = now + kSlot; }

  /// True where the rates are new, every ten seconds. `window_peak` is the highest tension since
  /// the window of the watch has begun.
  bool take(hal::Time now, const lifemodel::Damage& damage, std::uint64_t cycles,
            std::uint32_t window_peak = 0) {
    if (now < next_) {
      return false;
    }
    oldest_ = marks_[position_];
    newest_ = {damage, cycles};
    marks_[position_] = newest_;
    window_peak_ = window_peak;
    position_ = (position_ + 1) % kSlots;
    marked_ += marked_ < kSlots ? 1 : 0;
    next_ = now + kSlot;
    if (known()) {
      heaviest_ = std::max(heaviest_, damage_per_min());
      if (position_ == 0) {
        add_stretch();
      }
    }
    if (window_over()) {
      past_window_peak_ = window_peak;
    }
    return true;
  }
  /// After take() was true: whether a whole minute is over, and the window of the watch with it.
  [[nodiscard]] bool window_over() const { return position_ == 0; }

  /// Whether load_spread() is known: ten minutes with damage were seen.
  [[nodiscard]] bool spread_known() const { return stretches_ >= kFewestStretches; }
  /// Half of the width of the 95 % interval of log2 of the damage rate of a minute, Q21, as if the
  /// minutes to come scattered as those that were seen since the start, of which the last hour
  /// weighs most. Minutes without damage are left out: they are rest, not operation. A controller
  /// knows no more of the future than that; a load that is averaged over hours scatters less.
  [[nodiscard]] std::uint32_t load_spread() const {
    const auto variance = static_cast<std::uint32_t>(variance_ + variance_ / (stretches_ - 1));
    constexpr std::uint32_t kQuantile = 2007;  // 1.96, Q10
    return (lifemodel::root(variance) * kQuantile) << 1;
  }

  /// False until a whole minute has passed.
  [[nodiscard]] bool known() const { return marked_ == kSlots; }
  /// Cycles::kUnknownRate until it is known; stops below.
  [[nodiscard]] std::uint16_t cycles_per_min() const {
    using protocol::detail::Cycles;
    return known() ? below(Cycles::kUnknownRate, cycles_of_min()) : Cycles::kUnknownRate;
  }
  /// DamageRate::kUnknownRate until it is known; stops below.
  [[nodiscard]] std::uint32_t damage_ppb_per_h() const {
    using protocol::detail::DamageRate;
    return known() ? below(DamageRate::kUnknownRate,
                           damage_per_min().multiplied(60).parts_per_billion())
                   : DamageRate::kUnknownRate;
  }
  /// What this many hours do at this rate; stops at the highest damage.
  /// @pre known()
  [[nodiscard]] lifemodel::Damage damage_in(std::uint32_t hours) const {
    return damage_per_min().multiplied(60 * hours);
  }
  /// @pre known()
  [[nodiscard]] lifemodel::Damage damage_per_min() const {
    return lifemodel::Damage::difference(newest_.damage, oldest_.damage);
  }
  /// The highest of these since the start.
  [[nodiscard]] const lifemodel::Damage& heaviest_per_min() const { return heaviest_; }
  /// Closed cycles of the same minute.
  [[nodiscard]] std::uint64_t cycles_of_min() const { return newest_.cycles - oldest_.cycles; }
  /// The highest tension of the last minute at least, and of no more than two, Q29 as
  /// lifemodel::Tension.
  [[nodiscard]] std::uint32_t peak() const { return std::max(past_window_peak_, window_peak_); }
  /// Tenths of an hour that `left` lasts at this rate; RemainingLife::kUnknown until the rate is
  /// known; stops below.
  [[nodiscard]] std::uint16_t lasts_dh(const lifemodel::Damage& left) const {
    constexpr std::uint16_t kUnknown = protocol::detail::RemainingLife::kUnknown;
    return known()
               ? below(kUnknown, lifemodel::repeats_within(left, damage_per_min().multiplied(6)))
               : kUnknown;
  }
  /// Half hours that `left` lasts at this rate, rounded down; 2^32 - 1 at most.
  /// @pre known()
  [[nodiscard]] std::uint32_t lasts_30min(const lifemodel::Damage& left) const {
    return lifemodel::repeats_within(left, damage_per_min().multiplied(30));
  }
  /// The same until `end`, a point of the whole life of a new wire.
  [[nodiscard]] std::uint16_t remaining_dh(const lifemodel::Damage& used,
                                           lifemodel::LifePoint end) const {
    const lifemodel::Damage limit = end.damage();
    return lasts_dh(used < limit ? lifemodel::Damage::difference(limit, used)
                                 : lifemodel::Damage{});
  }

 private:
  struct Mark {
    lifemodel::Damage damage;
    std::uint64_t cycles = 0;
  };

  /// Mean and variance, which forget what lies longer back than kMostStretches.
  void add_stretch() {
    const lifemodel::Damage damage = damage_per_min();
    if (damage.none()) {
      return;
    }
    constexpr std::int32_t kFarthest = 8 << kScatterBits;
    const auto log2 = static_cast<std::int32_t>(lifemodel::log2_of(damage) >>
                                                (lifemodel::numeric::kLogBits - kScatterBits));
    stretches_ += stretches_ < kMostStretches ? 1 : 0;
    if (stretches_ == 1) {
      mean_ = log2;
    }
    const std::int32_t before = std::clamp(log2 - mean_, -kFarthest, kFarthest);
    mean_ += before / stretches_;
    const std::int32_t after = std::clamp(log2 - mean_, -kFarthest, kFarthest);
    variance_ += (before * after - variance_) / stretches_;
  }

  static constexpr int kScatterBits = 10;
  static constexpr std::int32_t kFewestStretches = 10;
  static constexpr std::int32_t kMostStretches = 60;

  std::int32_t stretches_ = 0;
  std::int32_t mean_ = 0;      ///< of log2 of the damage of a minute, Q10
  std::int32_t variance_ = 0;  ///< Q20
  std::array<Mark, kSlots> marks_{};
  std::uint32_t window_peak_ = 0;
  std::uint32_t past_window_peak_ = 0;
  lifemodel::Damage heaviest_;
  Mark oldest_;
  Mark newest_;
  std::size_t position_ = 0;
  std::size_t marked_ = 0;
  hal::Time next_{};
};

}  // namespace app
