#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/protocol/messages.hpp"
#include "hal/clock.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/life/weibull.hpp"

namespace app {

/// A value for a field whose highest value stands for unknown; stops below that.
template <class Field>
constexpr Field below(Field unknown, std::uint64_t value) {
  return value < unknown ? static_cast<Field>(value) : static_cast<Field>(unknown - 1);
}

/// Damage and cycles of one tendon over the last minute, from readings since the start, which never
/// fall.
class Rates {
 public:
  static constexpr std::size_t kSlots = 6;
  static constexpr hal::Time kSlot = hal::seconds(10);

  void start(hal::Time now) { next_ = now + kSlot; }

  void take(hal::Time now, const lifemodel::Damage& damage, std::uint64_t cycles) {
    if (now < next_) {
      return;
    }
    oldest_ = marks_[position_];
    newest_ = {damage, cycles};
    marks_[position_] = newest_;
    position_ = (position_ + 1) % kSlots;
    marked_ += marked_ < kSlots ? 1 : 0;
    next_ = now + kSlot;
  }

  /// False until a whole minute has passed.
  [[nodiscard]] bool known() const { return marked_ == kSlots; }
  /// Cycles::kUnknownRate until it is known; stops below.
  [[nodiscard]] std::uint16_t cycles_per_min() const {
    using protocol::detail::Cycles;
    return known() ? below(Cycles::kUnknownRate, newest_.cycles - oldest_.cycles)
                   : Cycles::kUnknownRate;
  }
  /// DamageRate::kUnknownRate until it is known; stops below.
  [[nodiscard]] std::uint32_t damage_ppb_per_h() const {
    using protocol::detail::DamageRate;
    return known()
               ? below(DamageRate::kUnknownRate, times(damage_per_min(), 60).parts_per_billion())
               : DamageRate::kUnknownRate;
  }
  /// Tenths of an hour until `end` at this rate; RemainingLife::kUnknown until the rate is known;
  /// stops below.
  [[nodiscard]] std::uint16_t remaining_dh(const lifemodel::Damage& used,
                                           lifemodel::LifePoint end) const {
    constexpr std::uint16_t kUnknown = protocol::detail::RemainingLife::kUnknown;
    if (!known()) {
      return kUnknown;
    }
    constexpr std::uint32_t kMinutes = 6;
    const std::uint32_t left =
        lifemodel::remaining_repeats(used, times(damage_per_min(), kMinutes), end);
    return below(kUnknown, left);
  }

 private:
  struct Mark {
    lifemodel::Damage damage;
    std::uint64_t cycles = 0;
  };

  [[nodiscard]] lifemodel::Damage damage_per_min() const {
    return lifemodel::Damage::difference(newest_.damage, oldest_.damage);
  }

  static lifemodel::Damage times(const lifemodel::Damage& damage, std::uint32_t n) {
    lifemodel::Damage sum;
    lifemodel::Flags flags;
    for (std::uint32_t i = 0; i < n; ++i) {
      sum.add(damage, flags);
    }
    return sum;
  }

  std::array<Mark, kSlots> marks_{};
  Mark oldest_;
  Mark newest_;
  std::size_t position_ = 0;
  std::size_t marked_ = 0;
  hal::Time next_{};
};

}  // namespace app
