#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "firmware/app/life_state.hpp"
#include "firmware/app/rates.hpp"
#include "firmware/app/tendon_life.hpp"
#include "firmware/storage/life_record.hpp"
#include "lifemodel/block/parameters.hpp"
#include "lifemodel/support/saturating.hpp"

namespace app {

/// The lives of all tendons as of the last reading, which is what is told and what is saved.
template <std::size_t kTendons>
class LifeBook {
 public:
  using Records = std::array<storage::LifeRecord, kTendons>;

  void start(hal::Time now) {
    for (Rates& rates : rates_) {
      rates.start(now);
    }
  }

  /// What is known of a tendon before the first reading. Without `life` it has no parameters.
  void resume(std::size_t tendon, const std::optional<storage::LifeRecord>& record, bool lost,
              std::uint32_t configuration, const std::optional<lifemodel::LifeDistribution>& life) {
    lives_[tendon].resume(record ? &*record : nullptr, lost, static_cast<std::uint8_t>(tendon),
                          configuration);
    distributions_[tendon] = life;
    records_[tendon] = lives_[tendon].record();
  }

  void take(hal::Time now, std::size_t tendon, const lifemodel::Reading& reading) {
    lives_[tendon].take(reading);
    rates_[tendon].take(now, reading.total, reading.closed_cycles.raw());
    records_[tendon] = lives_[tendon].record();
  }

  [[nodiscard]] storage::LifeRecord next_epoch(std::size_t tendon) const {
    return lives_[tendon].next_epoch();
  }
  /// `next` is what next_epoch() gave, with no reading taken since.
  void open(std::size_t tendon, const storage::LifeRecord& next) {
    lives_[tendon].open(next);
    records_[tendon] = lives_[tendon].record();
  }

  [[nodiscard]] const Records& records() const { return records_; }
  [[nodiscard]] const lifemodel::Damage& damage(std::size_t tendon) const {
    return records_[tendon].epoch_damage;
  }
  [[nodiscard]] std::uint32_t damage_ppb(std::size_t tendon) const {
    return damage(tendon).parts_per_billion();
  }
  [[nodiscard]] const Rates& rates(std::size_t tendon) const { return rates_[tendon]; }
  [[nodiscard]] const std::optional<lifemodel::LifeDistribution>& distribution(
      std::size_t tendon) const {
    return distributions_[tendon];
  }

  /// The tendon with the highest damage.
  [[nodiscard]] std::size_t worst() const {
    std::size_t worst = 0;
    for (std::size_t tendon = 1; tendon < kTendons; ++tendon) {
      worst = damage(tendon) > damage(worst) ? tendon : worst;
    }
    return worst;
  }

  [[nodiscard]] protocol::LifeState state(std::size_t tendon) const {
    return distributions_[tendon] ? life_state(damage(tendon), *distributions_[tendon])
                                  : protocol::LifeState::unknown;
  }
  /// The gravest state of a tendon that has parameters.
  [[nodiscard]] protocol::LifeState state() const {
    protocol::LifeState gravest = protocol::LifeState::unknown;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      gravest = state(tendon) > gravest ? state(tendon) : gravest;
    }
    return gravest;
  }

  [[nodiscard]] lifemodel::Flags flags() const {
    std::uint32_t bits = 0;
    for (const storage::LifeRecord& record : records_) {
      bits |= record.flags;
    }
    return lifemodel::Flags::from_bits(bits);
  }

  /// False where a record of the past was lost.
  [[nodiscard]] bool whole() const {
    for (const storage::LifeRecord& record : records_) {
      if (record.past_lost) {
        return false;
      }
    }
    return true;
  }

  /// Closed cycles of this epoch, all tendons; stops.
  [[nodiscard]] std::uint32_t cycles() const {
    std::uint64_t sum = 0;
    for (const storage::LifeRecord& record : records_) {
      sum = lifemodel::saturating_add(sum, record.epoch_cycles);
    }
    constexpr std::uint64_t kHighest = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(sum < kHighest ? sum : kHighest);
  }
  /// Of all tendons that have parameters; Cycles::kUnknownRate until it is known of each of them.
  [[nodiscard]] std::uint16_t cycles_per_min() const {
    constexpr std::uint16_t kUnknown = protocol::detail::Cycles::kUnknownRate;
    std::uint32_t sum = 0;
    bool known = false;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      if (!distributions_[tendon]) {
        continue;
      }
      if (!rates_[tendon].known()) {
        return kUnknown;
      }
      known = true;
      sum += rates_[tendon].cycles_per_min();
    }
    return known ? below(kUnknown, sum) : kUnknown;
  }

 private:
  std::array<TendonLife, kTendons> lives_;
  std::array<Rates, kTendons> rates_;
  std::array<std::optional<lifemodel::LifeDistribution>, kTendons> distributions_;
  Records records_;
};

}  // namespace app
