#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "lifemodel/damage/cycle_law.hpp"
#include "lifemodel/input/capstan.hpp"
#include "lifemodel/input/motor_drive.hpp"
#include "lifemodel/life/uncertainty.hpp"
#include "lifemodel/life/weibull.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/result.hpp"
#include "lifemodel/watch/watch_limits.hpp"

namespace lifemodel {

/// What the estimator has to know about one tendon. Comes out of a parameter block that has been
/// checked; see ParameterBlock.
struct Parameters {
  std::uint32_t model_digest;  ///< CRC-32 of the model that the block was computed from
  TensionRange hysteresis;     ///< smallest range that is counted, at least one step
  std::uint32_t ultimate_mN;   ///< the ultimate tension, for conversions
  TensionScale scale;
  CycleLaw law;
  LifeDistribution life;
  Capstan capstan;
  Angle bend;        ///< where the bend angle is not measured
  MotorDrive drive;  ///< its gain is 0 where the model has no drive
  std::uint32_t sample_period_us;
  LifeUncertainty uncertainty{};
  WatchLimits watch{};

  [[nodiscard]] constexpr bool has_drive() const { return drive.gain.mantissa != 0; }
};

inline constexpr std::uint32_t kBlockMagic = 0x42504c54;  ///< "TLPB"
/// Of a block that knows neither uncertainty nor watch limits, which is written as ever.
inline constexpr std::uint32_t kBlockVersion = 1;
inline constexpr std::size_t kBlockBytes = 84;
/// Of a block that knows either.
inline constexpr std::uint32_t kWatchedBlockVersion = 2;
inline constexpr std::size_t kWatchedBlockBytes = kBlockBytes + 44;

/// A parameter block as it is stored and sent: little-endian words, the CRC-32 of all before it
/// last.
class ParameterBlock {
 public:
  constexpr ParameterBlock() = default;
  /// Zeros, in the size of this version.
  constexpr explicit ParameterBlock(std::uint32_t version)
      : size_(version == kWatchedBlockVersion ? kWatchedBlockBytes : kBlockBytes) {}

  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  [[nodiscard]] constexpr const std::byte* data() const { return bytes_.data(); }
  [[nodiscard]] constexpr std::byte* data() { return bytes_.data(); }
  [[nodiscard]] constexpr const std::byte* begin() const { return data(); }
  [[nodiscard]] constexpr std::byte* begin() { return data(); }
  [[nodiscard]] constexpr const std::byte* end() const { return data() + size_; }
  [[nodiscard]] constexpr std::byte* end() { return data() + size_; }
  [[nodiscard]] constexpr std::byte& operator[](std::size_t i) { return bytes_[i]; }
  [[nodiscard]] constexpr std::byte operator[](std::size_t i) const { return bytes_[i]; }

  friend constexpr bool operator==(const ParameterBlock&, const ParameterBlock&) = default;

 private:
  std::array<std::byte, kWatchedBlockBytes> bytes_{};
  std::size_t size_ = kBlockBytes;
};

inline constexpr std::uint32_t kLowestUltimate_mN = 1'000;
inline constexpr std::uint32_t kHighestUltimate_mN = 1'000'000'000;
inline constexpr std::int32_t kHighestLog2Life = 500 << numeric::kExpBits;

/// Why a parameter block is refused.
enum class BlockError : std::uint8_t {
  none,
  wrong_size,            ///< not as long as a block of its version
  not_a_block,           ///< other magic
  unknown_version,       ///< made for another version of this library
  damaged,               ///< the CRC does not fit
  ultimate_tension,      ///< outside 1 N .. 1 MN, or not what the scale follows from
  hysteresis,            ///< zero, or not below the ultimate tension
  ipl_exponent,          ///< outside 1 .. 12
  ipl_scale,             ///< life at the ultimate tension outside 2^-500 .. 2^500 cycles
  weibull_shape,         ///< outside 0.5 .. 50
  life_points,           ///< not 0 < B10 < B50 < B90, or the mean outside them
  friction_coefficient,  ///< outside 0 .. 1
  bend_angle,            ///< outside 0 .. 1800 deg
  drive,                 ///< offset or gain outside their range
  sample_period,         ///< zero
  uncertainty,           ///< wider than LifeUncertainty has it, or the pivot outside 2^+-500
  watch_limits,          ///< a tension outside 0 .. the ultimate one, or a travel or risk alone
};

/// The reason in words.
constexpr const char* to_string(BlockError error) {
  switch (error) {
    case BlockError::none:
      return "accepted";
    case BlockError::wrong_size:
      return "wrong size: a parameter block of version 1 has 84 bytes, of version 2 128";
    case BlockError::not_a_block:
      return "not a parameter block";
    case BlockError::unknown_version:
      return "unknown version: this library reads versions 1 and 2";
    case BlockError::damaged:
      return "damaged: the CRC-32 does not fit";
    case BlockError::ultimate_tension:
      return "ultimate tension out of range: 1 N to 1 MN";
    case BlockError::hysteresis:
      return "hysteresis out of range: above 0 and below the ultimate tension";
    case BlockError::ipl_exponent:
      return "exponent of the inverse power law out of range: 1 to 12";
    case BlockError::ipl_scale:
      return "scale of the inverse power law out of range";
    case BlockError::weibull_shape:
      return "Weibull shape out of range: 0.5 to 50";
    case BlockError::life_points:
      return "life points out of order: 0 < B10 < B50 < B90";
    case BlockError::friction_coefficient:
      return "friction coefficient out of range: 0 to 1";
    case BlockError::bend_angle:
      return "bend angle out of range: 0 to 1800 deg";
    case BlockError::drive:
      return "current offset or gain of the drive out of range";
    case BlockError::sample_period:
      return "sample period out of range: at least 1 us";
    case BlockError::uncertainty:
      return "uncertainty of the life law out of range";
    case BlockError::watch_limits:
      return "limits of the watch out of range, or a travel without its tension";
  }
  return "unknown";
}

/// Writes the block for `p`.
constexpr ParameterBlock encode(const Parameters& p) {
  const bool watched = p.uncertainty.known() || p.watch != WatchLimits{};
  const std::uint32_t version = watched ? kWatchedBlockVersion : kBlockVersion;
  ParameterBlock block(version);
  ByteWriter out(block);
  out.u32(kBlockMagic);
  out.u32(version);
  out.u32(p.model_digest);
  out.u32(p.ultimate_mN);
  out.i32(p.scale.steps_per_mN.mantissa);
  out.i32(p.scale.steps_per_mN.shift);
  out.u32(p.hysteresis.raw());
  out.u32(p.law.exponent.raw());
  out.i32(p.law.log2_damage_at_ultimate);
  out.u32(p.life.shape.raw());
  out.u32(p.life.b10.raw);
  out.u32(p.life.b50.raw);
  out.u32(p.life.mean.raw);
  out.u32(p.life.b90.raw);
  out.u32(p.capstan.friction.raw());
  out.i32(p.bend.raw());
  out.i32(p.drive.offset.raw());
  out.i32(p.drive.gain.mantissa);
  out.i32(p.drive.gain.shift);
  out.u32(p.sample_period_us);
  if (watched) {
    out.u32(p.uncertainty.log2_life);
    out.u32(p.uncertainty.exponent);
    out.u32(p.uncertainty.log2_shape);
    out.i32(p.uncertainty.log2_damage_at_pivot);
    out.i32(p.watch.minimum.raw());
    out.i32(p.watch.broken.raw());
    out.u32(p.watch.broken_travel_um);
    out.u32(p.watch.slack_travel_um);
    out.u32(p.watch.horizon_s);
    out.u32(p.watch.advice_risk.raw());
    out.u32(p.watch.advice_until_s);
  }
  out.u32(crc32(std::span(block).first(out.size())));
  return block;
}

/// Whether the scale turns the ultimate tension into 1, to 1e-6 and the half mN to which the
/// ultimate tension is rounded.
constexpr bool scale_follows(const Parameters& p) {
  const Factor& scale = p.scale.steps_per_mN;
  const std::int64_t one = scale.times(static_cast<std::int32_t>(p.ultimate_mN));
  const std::int64_t allowed = 512 + scale.times(1) / 2;
  return one > kUltimate.raw() - allowed && one < kUltimate.raw() + allowed;
}

/// Whether the half-widths of intervals are within their ranges.
constexpr bool plausible(const LifeUncertainty& u) {
  return u.log2_life <= LifeUncertainty::kWidestLog2Life &&
         u.exponent <= LifeUncertainty::kWidestExponent &&
         u.log2_shape <= LifeUncertainty::kWidestLog2Shape &&
         u.log2_damage_at_pivot >= -kHighestLog2Life && u.log2_damage_at_pivot <= kHighestLog2Life;
}

/// Whether tensions are below the ultimate one, and each travel has its tension and the advice
/// both of its numbers.
constexpr bool plausible(const WatchLimits& w) {
  const auto below_ultimate = [](Tension t) { return t.raw() >= 0 && t < kUltimate; };
  return below_ultimate(w.minimum) && below_ultimate(w.broken) &&
         (w.broken.raw() == 0) == (w.broken_travel_um == 0) &&
         (w.slack_travel_um == 0 || w.minimum.raw() != 0) && w.advice_risk < Ratio::highest() &&
         (w.advice_risk.raw() == 0) == (w.advice_until_s == 0);
}

/// Reads what a block of version 2 has beyond one of version 1 into `p`.
constexpr Result<Parameters, BlockError> decode_watched(ByteReader& in, Parameters& p) {
  p.uncertainty.log2_life = in.u32();
  p.uncertainty.exponent = in.u32();
  p.uncertainty.log2_shape = in.u32();
  p.uncertainty.log2_damage_at_pivot = in.i32();
  if (!plausible(p.uncertainty)) {
    return BlockError::uncertainty;
  }
  p.watch.minimum = Tension::from_raw(in.i32());
  p.watch.broken = Tension::from_raw(in.i32());
  p.watch.broken_travel_um = in.u32();
  p.watch.slack_travel_um = in.u32();
  p.watch.horizon_s = in.u32();
  p.watch.advice_risk = Ratio::from_raw(in.u32());
  p.watch.advice_until_s = in.u32();
  if (!plausible(p.watch)) {
    return BlockError::watch_limits;
  }
  return p;
}

/// The bytes that the block at the front has, by its version; nothing where it is of none that is
/// known or there are fewer.
constexpr std::optional<std::size_t> block_bytes(std::span<const std::byte> bytes) {
  if (bytes.size() < kBlockBytes) {
    return std::nullopt;
  }
  const std::uint32_t version = ByteReader(bytes.subspan(4)).u32();
  if (version == kBlockVersion) {
    return kBlockBytes;
  }
  if (version == kWatchedBlockVersion && bytes.size() >= kWatchedBlockBytes) {
    return kWatchedBlockBytes;
  }
  return std::nullopt;
}

/// Checks a block and reads it; refuses what is damaged, unknown or out of range, with the reason.
constexpr Result<Parameters, BlockError> decode(std::span<const std::byte> block) {
  if (block.size() != kBlockBytes && block.size() != kWatchedBlockBytes) {
    return BlockError::wrong_size;
  }
  ByteReader in(block);
  if (in.u32() != kBlockMagic) {
    return BlockError::not_a_block;
  }
  const std::uint32_t version = in.u32();
  if (version != kBlockVersion && version != kWatchedBlockVersion) {
    return BlockError::unknown_version;
  }
  if (block_bytes(block) != block.size()) {
    return BlockError::wrong_size;
  }
  if (crc32(block.first(block.size() - 4)) != ByteReader(block.last(4)).u32()) {
    return BlockError::damaged;
  }

  Parameters p{};
  p.model_digest = in.u32();
  p.ultimate_mN = in.u32();
  p.scale.steps_per_mN.mantissa = in.i32();
  p.scale.steps_per_mN.shift = in.i32();
  if (p.ultimate_mN < kLowestUltimate_mN || p.ultimate_mN > kHighestUltimate_mN ||
      !p.scale.steps_per_mN.plausible() || !scale_follows(p)) {
    return BlockError::ultimate_tension;
  }
  p.hysteresis = TensionRange::from_raw(in.u32());
  if (p.hysteresis.raw() == 0 ||
      p.hysteresis.raw() >= static_cast<std::uint32_t>(kUltimate.raw())) {
    return BlockError::hysteresis;
  }
  const auto exponent = IplExponent::checked(in.u32());
  if (!exponent) {
    return BlockError::ipl_exponent;
  }
  p.law.exponent = *exponent;
  p.law.log2_damage_at_ultimate = in.i32();
  if (p.law.log2_damage_at_ultimate < -kHighestLog2Life ||
      p.law.log2_damage_at_ultimate > kHighestLog2Life) {
    return BlockError::ipl_scale;
  }
  const auto shape = WeibullShape::checked(in.u32());
  if (!shape) {
    return BlockError::weibull_shape;
  }
  p.life.shape = *shape;
  p.life.b10 = {in.u32()};
  p.life.b50 = {in.u32()};
  p.life.mean = {in.u32()};
  p.life.b90 = {in.u32()};
  if (p.life.b10.raw == 0 || p.life.b10.raw >= p.life.b50.raw || p.life.b50.raw >= p.life.b90.raw ||
      p.life.mean.raw < p.life.b10.raw || p.life.mean.raw > p.life.b90.raw) {
    return BlockError::life_points;
  }
  const auto friction = FrictionExponent::checked(in.u32());
  if (!friction) {
    return BlockError::friction_coefficient;
  }
  p.capstan.friction = *friction;
  const auto bend = Angle::checked(in.i32());
  if (!bend) {
    return BlockError::bend_angle;
  }
  p.bend = *bend;
  const auto offset = MotorCurrent::checked(in.i32());
  p.drive.gain.mantissa = in.i32();
  p.drive.gain.shift = in.i32();
  if (!offset || (p.has_drive() && !p.drive.gain.plausible())) {
    return BlockError::drive;
  }
  p.drive.offset = *offset;
  p.sample_period_us = in.u32();
  if (p.sample_period_us == 0) {
    return BlockError::sample_period;
  }
  return version == kWatchedBlockVersion ? decode_watched(in, p) : p;
}

}  // namespace lifemodel
