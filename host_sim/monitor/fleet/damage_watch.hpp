#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "firmware/protocol/messages.hpp"

namespace host_sim::monitor {

/// The graver of two states; an unknown one is graver than a normal one only.
constexpr protocol::LifeState graver(protocol::LifeState one, protocol::LifeState other) {
  using protocol::LifeState;
  const LifeState high = std::max(one, other);
  const LifeState low = std::min(one, other);
  return low == LifeState::unknown && high == LifeState::normal ? low : high;
}

/// The highest damage and the gravest state that genuine reports gave of one epoch of a node, or of
/// one of its tendons. This is the one place that lets them fall, and it does so for a proven new
/// epoch alone.
///
/// Reports come late, twice, out of order, from a log that is played again: that a node reports
/// less, and continues to, proves nothing. What none of these can hold is a record of the future.
/// Within an epoch, a damage that was reported with one record is never undercut with a later one;
/// but for a power cut, of which the node reports the most that it loses. So the proof is a low
/// report, then a record that is later than that of a mark, then kWitnesses more low reports,
/// without a break of the reports and without another count in the frames of the records. A mark is
/// a record and the damage that was reported before and after it, without a break. Low is a damage
///   - below that of a mark by more than a power cut loses, where that is known, or
///   - below that of a mark of the same run of reports at all: without a break there was no
///   restart.
/// What is shown then is the highest that was ever low in the epoch before, for that may have been
/// of the new one.
class DamageWatch {
 public:
  static constexpr int kWitnesses = 3;

  /// What another frame than the reports gave: it raises only.
  void raise(std::uint32_t damage_ppb) { highest_ppb_ = std::max(highest_ppb_, damage_ppb); }
  void raise(protocol::LifeState state) { gravest_ = std::max(gravest_, state); }

  /// The run of reports is broken: there may have been a restart, or another speaker.
  void broken() {
    run_ppb_ = 0;
    next_.reset();
    of_run_.reset();
    forget_low();
  }

  /// Records come in other frames than the reports, and those have gone on with another count: the
  /// last record may be of another speaker than the low reports around it.
  void records_of_another() { forget_low(); }

  /// The node reports its last record, and what a power cut may lose: none where that may be more
  /// than it can report.
  void record(std::uint32_t sequence, std::optional<std::uint32_t> unsaved_ppb) {
    if (sequence < latest_) {
      forget_low();  // an old log
      return;
    }
    latest_ = sequence;
    unsaved_ppb_ = unsaved_ppb && unsaved_ppb_
                       ? std::optional(std::max(*unsaved_ppb_, *unsaved_ppb))
                       : std::nullopt;
    if (low_ == 0) {
      next_ = {sequence, run_ppb_};
    } else {
      later_ = later_ || sequence > low_from_;
    }
  }

  /// A report. Gives the highest damage of the epoch before, where it proves a new one.
  std::optional<std::uint32_t> report(std::uint32_t damage_ppb, protocol::LifeState state,
                                      bool trusted) {
    const std::optional<std::uint32_t> low_from = mark_above(damage_ppb);
    if (!low_from || !trusted) {
      forget_low();
    }
    if (!low_from) {
      raise(damage_ppb);
      raise(state);
      run_ppb_ = std::max(run_ppb_, damage_ppb);
      if (next_ && damage_ppb >= next_->damage_ppb) {
        set_mark(*std::exchange(next_, std::nullopt));
      }
    } else {
      low_ppb_ = std::max(low_ppb_, damage_ppb);
      low_state_ = std::max(low_state_, state);
    }
    if (!low_from || !trusted) {
      return std::nullopt;
    }
    if (low_ == 0) {
      low_from_ = *low_from;
    }
    low_ += low_ == 0 || later_ ? 1 : 0;
    if (low_ <= kWitnesses) {
      return std::nullopt;
    }
    const std::uint32_t before_ppb = highest_ppb_;
    DamageWatch epoch;
    epoch.highest_ppb_ = low_ppb_;
    epoch.gravest_ = low_state_;
    epoch.run_ppb_ = damage_ppb;
    epoch.latest_ = latest_;
    *this = epoch;
    return before_ppb;
  }

  [[nodiscard]] std::uint32_t highest_ppb() const { return highest_ppb_; }
  [[nodiscard]] protocol::LifeState gravest() const { return gravest_; }

 private:
  struct Mark {
    std::uint32_t sequence = 0;
    std::uint32_t damage_ppb = 0;
  };
  void set_mark(const Mark& mark) {
    of_run_ = mark;
    if (!of_all_ || mark.damage_ppb >= of_all_->damage_ppb) {
      of_all_ = mark;
    }
  }

  /// The record of a mark from which on the damage is low.
  [[nodiscard]] std::optional<std::uint32_t> mark_above(std::uint32_t damage_ppb) const {
    if (of_run_ && damage_ppb < of_run_->damage_ppb) {
      return of_run_->sequence;
    }
    if (of_all_ && unsaved_ppb_ && damage_ppb < of_all_->damage_ppb &&
        of_all_->damage_ppb - damage_ppb > *unsaved_ppb_) {
      return of_all_->sequence;
    }
    return std::nullopt;
  }

  void forget_low() {
    low_ = 0;
    later_ = false;
  }

  std::uint32_t highest_ppb_ = 0;
  protocol::LifeState gravest_ = protocol::LifeState::unknown;
  std::uint32_t latest_ = 0;                      ///< record that was reported
  std::optional<std::uint32_t> unsaved_ppb_ = 0;  ///< none: not known
  std::uint32_t run_ppb_ = 0;                     ///< highest of this run of reports
  std::optional<Mark> next_;                      ///< its damage was not reported again yet
  std::optional<Mark> of_run_;
  std::optional<Mark> of_all_;
  int low_ = 0;  ///< reports: the first, and those after a later record
  bool later_ = false;
  std::uint32_t low_from_ = 0;
  std::uint32_t low_ppb_ = 0;  ///< highest and gravest that was low in this epoch
  protocol::LifeState low_state_ = protocol::LifeState::unknown;
};

}  // namespace host_sim::monitor
