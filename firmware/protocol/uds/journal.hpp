#pragma once

#include <cstdint>
#include <optional>

#include "firmware/protocol/authority/gate.hpp"
#include "firmware/protocol/uds/data.hpp"
#include "firmware/protocol/uds/device.hpp"
#include "firmware/storage/store.hpp"
#include "hal/error.hpp"

namespace protocol::uds {

/// Refusals that the log of a node holds at most. The rest of it is for what was done, so that
/// nobody can fill it without the key.
inline constexpr std::uint32_t kRefusalLines = 64;

/// Keeps the log of what was done under authority, or refused.
///
/// What is done leaves its line before it is done; without a line it is not done. Every refusal of
/// a command that was judged leaves a line. A refusal that costs its sender nothing (wrong form, no
/// key, locked out) leaves one for each kind, until something is done or the next lock begins. Past
/// kRefusalLines refusals are only counted, but for the first failure since something was done: its
/// line stands for as many as there may have been, so that no restart forgets them.
template <Device DeviceT>
class Journal {
 public:
  explicit Journal(DeviceT& device) : device_(device) {}

  /// Reads the log; gives the failures since something was done. Bounded by the log.
  std::uint32_t start() {
    std::uint32_t failures = 0;
    for (std::uint32_t i = 0;; ++i) {
      const std::optional<storage::LogEntry> entry = device_.log_entry(i);
      if (!entry) {
        return failures;
      }
      if (is_deed(entry->event)) {
        failures = 0;
        stands_for_all_ = false;
      } else if (entry->event != storage::Event::not_done) {
        if (is_failure(entry->event)) {
          stands_for_all_ = refusals_ >= kRefusalLines;
          failures += stands_for_all_ ? authority::kMostFailures : 1u;
        }
        ++refusals_;
      }
    }
  }

  /// The line of what is about to be done.
  hal::Error about_to(storage::Event event, std::uint8_t tendon, std::uint32_t configuration) {
    const hal::Error error = device_.log(event, tendon, configuration);
    if (error == hal::Error::none) {
      logged_ = 0;
      stands_for_all_ = false;
    }
    return error;
  }
  /// What the line before announces could not be done.
  void not_done(std::uint8_t tendon, std::uint16_t routine) {
    write(storage::Event::not_done, tendon, routine);
  }

  /// `detail`: the routine, or the CRC of the parameters.
  void refused(storage::Event event, std::uint8_t tendon, std::uint32_t detail) {
    if (is_judged(event)) {
      logged_ &= ~bit(storage::Event::locked_out);
    } else if ((logged_ & bit(event)) != 0) {
      count(unlogged_);
      return;
    }
    const bool past = refusals_ >= kRefusalLines;
    if (past && (stands_for_all_ || !is_failure(event))) {
      count(unlogged_);
      return;
    }
    logged_ |= bit(event);
    if (write(event, tendon, detail)) {
      ++refusals_;
      stands_for_all_ = past;
    }
  }

  /// Lines that were left out, or that found no room.
  [[nodiscard]] std::uint32_t unlogged() const { return unlogged_; }

 private:
  static constexpr std::uint32_t bit(storage::Event event) {
    return 1u << static_cast<unsigned>(event);
  }
  static constexpr bool is_deed(storage::Event event) {
    return event == storage::Event::epoch_opened || event == storage::Event::parameters_loaded;
  }
  static constexpr bool is_failure(storage::Event event) {
    return event == storage::Event::wrong_mac || event == storage::Event::nonce_reused ||
           event == storage::Event::nonce_expired;
  }
  static constexpr bool is_judged(storage::Event event) {
    return is_failure(event) || event == storage::Event::counter_rolled_back ||
           event == storage::Event::parameters_refused;
  }
  bool write(storage::Event event, std::uint8_t tendon, std::uint32_t detail) {
    if (device_.log(event, tendon, detail) == hal::Error::none) {
      return true;
    }
    count(unlogged_);
    return false;
  }

  DeviceT& device_;
  std::uint32_t refusals_ = 0;
  std::uint32_t logged_ = 0;  ///< bits of the events that have a line already
  bool stands_for_all_ = false;
  std::uint32_t unlogged_ = 0;
};

}  // namespace protocol::uds
