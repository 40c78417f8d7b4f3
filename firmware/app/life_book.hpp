#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "firmware/app/derating.hpp"
#include "firmware/app/rates.hpp"
#include "firmware/app/wire_log.hpp"
#include "firmware/protocol/messages.hpp"
#include "firmware/storage/life_record.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/life/weibull.hpp"
#include "lifemodel/support/saturating.hpp"
#include "lifemodel/tendon.hpp"

namespace app {

/// What the damage of a wire asks for. Never falls as the damage grows.
constexpr protocol::LifeState life_state(const lifemodel::Damage& damage,
                                         const lifemodel::LifeDistribution& life) {
  if (damage >= life.b50.damage()) {
    return protocol::LifeState::worn;
  }
  if (damage >= life.b10.damage()) {
    return protocol::LifeState::replace;
  }
  const lifemodel::LifePoint half_of_b10{life.b10.raw / 2};
  return damage >= half_of_b10.damage() ? protocol::LifeState::inspect
                                        : protocol::LifeState::normal;
}

/// How far a reading with these flags can be trusted.
constexpr protocol::Quality quality(lifemodel::Flags flags, bool trusted) {
  using lifemodel::Flag;
  if (!trusted) {
    return protocol::Quality::untrusted;
  }
  if (flags.has(Flag::saturated)) {
    return protocol::Quality::saturated;
  }
  if (flags.has(Flag::overrun) || flags.has(Flag::residue_overflow) || flags.has(Flag::overload)) {
    return protocol::Quality::bounded;
  }
  return flags.has(Flag::gap) ? protocol::Quality::gaps : protocol::Quality::measured;
}

/// The life of one tendon over restarts and epochs: what was stored, and what the estimator has
/// counted since the start.
///
/// A restart ends a history: the residue of the old one stays as the half cycles that were stored,
/// and the count begins anew. A new epoch begins at the present reading.
class TendonLife {
 public:
  /// Before the first reading. `record` is null where there is none; `lost` where there was one.
  void resume(const storage::LifeRecord* record, bool lost, std::uint8_t tendon,
              std::uint32_t configuration) {
    past_ = storage::LifeRecord{};
    if (record != nullptr) {
      past_ = *record;
    }
    past_.past_lost = past_.past_lost || (record == nullptr && lost);
    past_.tendon = tendon;
    past_.configuration = configuration;
    wire_.resume(past_.history);
  }

  /// Takes in a reading; readings never fall.
  void take(const lifemodel::Reading& reading) {
    total_ = reading.total;
    cycles_ = reading.closed_cycles.raw();
    flags_ = flags_ | reading.flags;
  }

  /// It was counted for so long more.
  void operate(hal::Time time) { wire_.operate(time.us); }

  /// Takes in what the watch has seen.
  void take(const lifemodel::WatchReading& watched, std::uint32_t sample_period_us) {
    wire_.take(watched, sample_period_us);
  }
  [[nodiscard]] const WireLog& wire() const { return wire_; }

  /// What a save now would store, but for the sequence.
  [[nodiscard]] storage::LifeRecord record() const {
    storage::LifeRecord now = past_;
    lifemodel::Flags flags = flags_ | lifemodel::Flags::from_bits(past_.flags);
    // Under an extended life law a reading may fall a little.
    if (total_at_opening_ < total_) {
      now.epoch_damage.add(lifemodel::Damage::difference(total_, total_at_opening_), flags);
    }
    now.lifetime_damage.add(total_, flags);
    now.epoch_cycles = lifemodel::saturating_add(now.epoch_cycles, cycles_ - cycles_at_opening_);
    now.flags = static_cast<std::uint8_t>(flags.bits());
    now.history = wire_.history();
    return now;
  }
  [[nodiscard]] lifemodel::Damage damage() const { return record().epoch_damage; }
  [[nodiscard]] lifemodel::Flags flags() const {
    return lifemodel::Flags::from_bits(record().flags);
  }

  /// The record with which the next epoch begins. The wire is new, its flags are gone, the
  /// lifetime continues.
  [[nodiscard]] storage::LifeRecord next_epoch() const {
    storage::LifeRecord next = record();
    next.epoch = static_cast<std::uint16_t>(next.epoch + 1);
    next.epoch_damage = {};
    next.epoch_cycles = 0;
    next.flags = 0;
    next.history = {};
    next.past_lost = false;
    return next;
  }
  /// Begins the epoch of `next`, which was made by next_epoch() with no reading taken since.
  void open(const storage::LifeRecord& next) {
    const lifemodel::Damage lifetime = past_.lifetime_damage;
    past_ = next;
    past_.lifetime_damage = lifetime;
    total_at_opening_ = total_;
    cycles_at_opening_ = cycles_;
    flags_ = {};
    wire_.begin();
  }

 private:
  storage::LifeRecord past_;
  lifemodel::Damage total_;
  lifemodel::Damage total_at_opening_;
  std::uint64_t cycles_ = 0;
  std::uint64_t cycles_at_opening_ = 0;
  lifemodel::Flags flags_;
  WireLog wire_;
};

/// What a forecast of a tendon takes besides its life distribution.
struct Outlook {
  std::uint32_t horizon_s = lifemodel::WatchLimits::kStandardHorizon_s;
  lifemodel::LifeUncertainty fit;
  Derating::Terms wanted{};

  static Outlook of(const lifemodel::Parameters& parameters) {
    return {parameters.watch.horizon(), parameters.uncertainty, Derating::Terms::of(parameters)};
  }
};

/// The lives of all tendons as of the last reading, which is what is reported and saved.
template <std::size_t kTendons>
class LifeBook {
 public:
  using Records = std::array<storage::LifeRecord, kTendons>;

  void start(hal::Time now) {
    for (Rates& rates : rates_) {
      rates.start(now);
    }
    last_reading_.fill(now);
  }

  /// What is known of a tendon before the first reading. Without `life` it has no parameters.
  void resume(std::size_t tendon, const std::optional<storage::LifeRecord>& record, bool lost,
              std::uint32_t configuration, const std::optional<lifemodel::LifeDistribution>& life,
              const Outlook& outlook = {}) {
    lives_[tendon].resume(record ? &*record : nullptr, lost, static_cast<std::uint8_t>(tendon),
                          configuration);
    distributions_[tendon] = life;
    outlooks_[tendon] = outlook;
    deratings_[tendon].resume(life ? outlook.wanted : Derating::Terms{});
    records_[tendon] = lives_[tendon].record();
  }

  /// True where the window of the watch is over, once a minute.
  bool take(hal::Time now, std::size_t tendon, const lifemodel::Reading& reading,
            const lifemodel::WatchReading& watched = {}, std::uint32_t sample_period_us = 0) {
    lives_[tendon].take(watched, sample_period_us);
    lives_[tendon].take(reading);
    lives_[tendon].operate(now - last_reading_[tendon]);
    last_reading_[tendon] = now;
    const bool marked =
        rates_[tendon].take(now, reading.total, reading.closed_cycles.raw(), watched.window_peak);
    records_[tendon] = lives_[tendon].record();
    if (marked && distributions_[tendon]) {
      deratings_[tendon].take(distributions_[tendon]->shape, rates_[tendon], records_[tendon]);
    }
    return marked && rates_[tendon].window_over();
  }

  [[nodiscard]] storage::LifeRecord next_epoch(std::size_t tendon) const {
    return lives_[tendon].next_epoch();
  }
  /// `next` is what next_epoch() gave, with no reading taken since.
  void open(std::size_t tendon, const storage::LifeRecord& next) {
    lives_[tendon].open(next);
    deratings_[tendon].begin();
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

  [[nodiscard]] const Outlook& outlook(std::size_t tendon) const { return outlooks_[tendon]; }
  [[nodiscard]] const Derating& derating(std::size_t tendon) const { return deratings_[tendon]; }

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

  /// A bit for each tendon whose wire has broken, or hangs loose now.
  [[nodiscard]] std::uint32_t broken() const {
    std::uint32_t bits = 0;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      bits |= records_[tendon].history.broken ? 1u << tendon : 0;
    }
    return bits;
  }
  [[nodiscard]] std::uint32_t slack() const {
    std::uint32_t bits = 0;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      bits |= lives_[tendon].wire().slack() ? 1u << tendon : 0;
    }
    return bits;
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
  std::array<Outlook, kTendons> outlooks_;
  std::array<Derating, kTendons> deratings_;
  std::array<hal::Time, kTendons> last_reading_{};
  Records records_;
};

}  // namespace app
