#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace host_sim::monitor {

/// The highest damage of the present epoch that a genuine frame told, in parts per billion.
///
/// A late frame, or a power cut, may tell less than was told before, which changes nothing. Only
/// kWitnesses statuses in a row that all lie below by more than a power cut can have lost are a new
/// epoch.
class DamageWatch {
 public:
  static constexpr int kWitnesses = 3;

  /// A damage from another frame than the status: it can raise the highest one only.
  void raise(std::uint32_t damage_ppb) { highest_ppb_ = std::max(highest_ppb_, damage_ppb); }

  /// What a power cut may lose, as the node told it.
  void may_lose(std::uint32_t unsaved_ppb) { unsaved_ppb_ = std::max(unsaved_ppb_, unsaved_ppb); }

  /// The damage of a status. Gives the highest damage of the epoch before, where this one opens a
  /// new one.
  std::optional<std::uint32_t> status(std::uint32_t damage_ppb) {
    if (highest_ppb_ <= damage_ppb || highest_ppb_ - damage_ppb <= unsaved_ppb_) {
      raise(damage_ppb);
      forget_witnesses();
      return std::nullopt;
    }
    low_ppb_ = std::max(low_ppb_, damage_ppb);
    if (++witnesses_ < kWitnesses) {
      return std::nullopt;
    }
    const std::uint32_t before_ppb = highest_ppb_;
    highest_ppb_ = low_ppb_;
    forget_witnesses();
    return before_ppb;
  }

  [[nodiscard]] std::uint32_t highest_ppb() const { return highest_ppb_; }

 private:
  void forget_witnesses() {
    witnesses_ = 0;
    low_ppb_ = 0;
  }

  std::uint32_t highest_ppb_ = 0;
  std::uint32_t unsaved_ppb_ = 0;
  std::uint32_t low_ppb_ = 0;
  int witnesses_ = 0;
};

}  // namespace host_sim::monitor
