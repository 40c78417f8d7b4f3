#pragma once

#include <cstdint>

#include "firmware/storage/life_record.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/support/saturating.hpp"
#include "lifemodel/tendon.hpp"

namespace app {

/// The life of one tendon over restarts and epochs: what was stored, and what the estimator has
/// counted since the start.
///
/// A restart ends a history: the residue of the old one stays as the half cycles that were stored,
/// and the count begins anew. A new epoch begins at the reading of the moment.
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
  }

  /// Takes in a reading; readings never fall.
  void take(const lifemodel::Reading& reading) {
    total_ = reading.total;
    cycles_ = reading.closed_cycles.raw();
    flags_ = flags_ | reading.flags;
  }

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
    return now;
  }
  [[nodiscard]] lifemodel::Damage damage() const { return record().epoch_damage; }
  [[nodiscard]] lifemodel::Flags flags() const {
    return lifemodel::Flags::from_bits(record().flags);
  }

  /// The record with which the next epoch begins. The wire is new, its flags are gone, the
  /// lifetime goes on.
  [[nodiscard]] storage::LifeRecord next_epoch() const {
    storage::LifeRecord next = record();
    next.epoch = static_cast<std::uint16_t>(next.epoch + 1);
    next.epoch_damage = {};
    next.epoch_cycles = 0;
    next.flags = 0;
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
  }

 private:
  storage::LifeRecord past_;
  lifemodel::Damage total_;
  lifemodel::Damage total_at_opening_;
  std::uint64_t cycles_ = 0;
  std::uint64_t cycles_at_opening_ = 0;
  lifemodel::Flags flags_;
};

}  // namespace app
