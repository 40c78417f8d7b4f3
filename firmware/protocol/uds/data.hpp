#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/protocol/authority/gate.hpp"
#include "firmware/protocol/uds/table.hpp"
#include "firmware/storage/life_record.hpp"
#include "firmware/storage/store.hpp"
#include "hal/clock.hpp"
#include "lifemodel/support/inlining.hpp"
#include "lifemodel/support/saturating.hpp"

namespace protocol::uds {

/// Writes an answer, little-endian. What finds no room is left out.
class Answer {
 public:
  constexpr explicit Answer(std::span<std::byte> out) : out_(out) {}

  LIFEMODEL_ONE_COPY constexpr void u8(std::uint8_t value) {
    if (size_ == out_.size()) {
      return;
    }
    out_[size_++] = std::byte{value};
  }
  constexpr void u16(std::uint16_t value) {
    u8(static_cast<std::uint8_t>(value));
    u8(static_cast<std::uint8_t>(value >> 8));
  }
  LIFEMODEL_ONE_COPY constexpr void u32(std::uint32_t value) {
    u16(static_cast<std::uint16_t>(value));
    u16(static_cast<std::uint16_t>(value >> 16));
  }
  /// Identifiers, which ISO 14229-1 sends with the high byte first.
  constexpr void identifier(std::uint16_t value) {
    u8(static_cast<std::uint8_t>(value >> 8));
    u8(static_cast<std::uint8_t>(value));
  }
  constexpr void bytes(std::span<const std::byte> values) {
    for (const std::byte value : values) {
      u8(static_cast<std::uint8_t>(value));
    }
  }

  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr std::size_t room() const { return out_.size() - size_; }

 private:
  std::span<std::byte> out_;
  std::size_t size_ = 0;
};

/// A life record, kLifeBytes:
///
///   0  4  sequence of the last save
///   4  1  tendon
///   5  1  flags (lifemodel::Flag), sticky
///   6  2  epoch, the number of the wire
///   8  4  damage of this wire, 1e-9; stops at 2^32 - 1
///  12  4  damage of all wires so far, 1e-9; stops at 2^32 - 1
///  16 16  damage of this wire, exact: Q24.104, least significant byte first
///  32 16  damage of all wires so far, exact
///  48  8  closed cycles of this wire
///  56  4  CRC-32 of the parameter block it was counted under
///  60  1  1: an earlier record of this wire was lost, so its damage is a lower bound
constexpr void write_life(Answer& out, const storage::LifeRecord& life) {
  out.u32(life.sequence);
  out.u8(life.tendon);
  out.u8(life.flags);
  out.u16(life.epoch);
  out.u32(life.epoch_damage.parts_per_billion());
  out.u32(life.lifetime_damage.parts_per_billion());
  for (const auto* damage : {&life.epoch_damage, &life.lifetime_damage}) {
    for (const std::uint32_t word : damage->words()) {
      out.u32(word);
    }
  }
  out.u32(static_cast<std::uint32_t>(life.epoch_cycles));
  out.u32(static_cast<std::uint32_t>(life.epoch_cycles >> 32));
  out.u32(life.configuration);
  out.u8(life.past_lost ? 1 : 0);
}

/// A line of the log, kLogBytes:
///
///   0  4  number
///   4  4  storage sequence at that moment
///   8  1  storage::Event
///   9  1  tendon
///  10  2  epoch
///  12  4  CRC-32 of the parameter block, or the routine that was refused
constexpr void write_log(Answer& out, const storage::LogEntry& entry) {
  out.u32(entry.number);
  out.u32(entry.sequence);
  out.u8(static_cast<std::uint8_t>(entry.event));
  out.u8(entry.tendon);
  out.u16(entry.epoch);
  out.u32(entry.detail);
}

/// What a tendon counts with, kParametersBytes; the numbers are those of the firmware:
///
///   0  1  source: 0 none, 1 the configuration, 2 loaded
///   1  1  why others were refused last: 0 they were not, 1 torn, 2 the block does not hold, 3 nor
///         its extension, 4 this board evaluates none, 5 an effect needs what is not measured
///   2  1  that effect (lifemodel::extension::Effect; 0xff: the input itself)
///   3  1  what it needs: 1 velocity, 2 angle of the rotor, 3 temperature of the sheath, 4 of the
///         winding
///   4  4  CRC-32 of the block that was refused; 0 where it is torn
struct ParameterReport {
  std::uint8_t source = 0;
  std::uint8_t fault = 0;
  std::uint8_t effect = 0;
  std::uint8_t covariate = 0;
  std::uint32_t refused_crc = 0;
};

constexpr void write_parameters(Answer& out, const ParameterReport& report) {
  out.u8(report.source);
  out.u8(report.fault);
  out.u8(report.effect);
  out.u8(report.covariate);
  out.u32(report.refused_crc);
}

/// Numbers of the authority stop at 2^32 - 1.
constexpr void count(std::uint32_t& number) {
  number = lifemodel::saturating_add(number, 1u);
}

/// What the authority has seen.
struct AuthorityCounts {
  std::uint32_t granted = 0;   ///< and done, since the start
  std::uint32_t refused = 0;   ///< for whatever reason, since the start
  std::uint32_t unlogged = 0;  ///< refusals without a line of their own, since the start

  friend constexpr bool operator==(const AuthorityCounts&, const AuthorityCounts&) = default;
};

/// The state of the authority, kAuthorityBytes:
///
///   0  1  1: this node has a key
///   1  1  failures since the last success; stops at 255
///   2  4  ms until the lock opens; 0: it is open
///   6  4  granted, 10  4  refused, 14  4  unlogged: see AuthorityCounts
constexpr void write_authority(Answer& out, const authority::Gate& gate,
                               const AuthorityCounts& counts, hal::Time now) {
  out.u8(gate.enabled() ? 1 : 0);
  const std::uint32_t failures = gate.failures();
  out.u8(static_cast<std::uint8_t>(failures < 0xff ? failures : 0xff));
  // At most 640 s, so 32 bits hold it; rounded up, so that 0 means open.
  out.u32((static_cast<std::uint32_t>(gate.lock_left(now).us) + 999) / 1000);
  out.u32(counts.granted);
  out.u32(counts.refused);
  out.u32(counts.unlogged);
}

}  // namespace protocol::uds
