#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/app/life_book.hpp"
#include "firmware/storage/save_policy.hpp"
#include "firmware/storage/store.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/support/saturating.hpp"

namespace app {

/// Keeps the lives in the store: saves when it is due, and knows what a power cut would lose.
template <std::size_t kTendons, storage::Store StoreT>
class Keeper {
 public:
  using Records = std::array<storage::LifeRecord, kTendons>;

  explicit Keeper(StoreT& store) : store_(store) {}

  /// `records` are those of the store, as they were resumed.
  void start(hal::Time now, const Records& records) {
    policy_.start(now);
    note_saved(records);
  }

  /// Saves where it is due; `changed` asks for it at once.
  void keep(hal::Time now, const Records& records, bool changed) {
    unsaved_ppb_ = unsaved_ppb(records);
    worst_unsaved_ppb_ = unsaved_ppb_ > worst_unsaved_ppb_ ? unsaved_ppb_ : worst_unsaved_ppb_;
    changed_ = changed_ || changed;
    if (policy_.due(now, unsaved_ppb_, changed_)) {
      (void)save(now, records);
    }
  }

  hal::Error save(hal::Time now, const Records& records) {
    const hal::Error error = store_.save(std::span<const storage::LifeRecord>(records));
    ok_ = error == hal::Error::none;
    if (ok_) {
      note_saved(records);
      policy_.saved(now);
      changed_ = false;
      unsaved_ppb_ = 0;
    } else {
      policy_.failed(now);
    }
    return error;
  }

  /// Work of the store that can be done ahead of the next save.
  void prepare() {
    if constexpr (requires { store_.prepare(); }) {
      (void)store_.prepare();
    }
  }

  /// False from a save that failed until one that did not.
  [[nodiscard]] bool ok() const { return ok_; }
  /// What a power cut now would lose, of the tendon that would lose most; rounded up, stops.
  [[nodiscard]] std::uint32_t unsaved_ppb() const { return unsaved_ppb_; }
  [[nodiscard]] std::uint32_t worst_unsaved_ppb() const { return worst_unsaved_ppb_; }

 private:
  [[nodiscard]] std::uint32_t unsaved_ppb(const Records& records) const {
    std::uint32_t worst_ppb = 0;
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      const auto unsaved =
          lifemodel::Damage::difference(records[tendon].lifetime_damage, saved_[tendon]);
      const bool none = unsaved == lifemodel::Damage{};
      const std::uint32_t ppb =
          lifemodel::saturating_add(unsaved.parts_per_billion(), none ? 0u : 1u);
      worst_ppb = ppb > worst_ppb ? ppb : worst_ppb;
    }
    return worst_ppb;
  }

  void note_saved(const Records& records) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      saved_[tendon] = records[tendon].lifetime_damage;
    }
  }

  StoreT& store_;
  storage::SavePolicy policy_;
  std::array<lifemodel::Damage, kTendons> saved_{};
  std::uint32_t unsaved_ppb_ = 0;
  std::uint32_t worst_unsaved_ppb_ = 0;
  bool changed_ = false;
  bool ok_ = true;
};

}  // namespace app
