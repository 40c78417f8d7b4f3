#pragma once

#include <cstdint>

namespace protocol {

/// CANopen node id, 1 .. 127 (CiA 301).
using Node = std::uint8_t;

/// NMT state in a heartbeat (CiA 301, 7.2.8.3.2.2).
enum class NmtState : std::uint8_t { boot_up = 0x00, stopped = 0x04, operational = 0x05 };

/// How far the life of the worst tendon is used.
enum class LifeState : std::uint8_t {
  unknown,  ///< no trustworthy record of the past was found, or a tendon has no parameters
  normal,
  inspect,  ///< half of the B10 life is used
  replace,  ///< the B10 life is used
  worn,     ///< the B50 life is used
};

/// How far a reading can be trusted; the first that applies.
enum class Quality : std::uint8_t {
  measured,   ///< every sample was taken
  gaps,       ///< samples were missing
  bounded,    ///< cycles were counted larger than they were, never smaller
  saturated,  ///< a value met the end of its range
  untrusted,  ///< the sensor or the record of the past is at fault
};

struct Heartbeat {
  NmtState state = NmtState::boot_up;

  friend constexpr bool operator==(const Heartbeat&, const Heartbeat&) = default;
};

/// The life of the node at a glance.
struct LifeStatus {
  LifeState state = LifeState::unknown;
  std::uint32_t damage_ppb = 0;   ///< of the worst tendon in this epoch; stops at 2^32 - 1
  std::uint8_t worst_tendon = 0;  ///< 0 .. 31
  Quality quality = Quality::measured;
  bool storage_ok = false;
  bool sensor_ok = false;
  bool gap = false;
  bool saturated = false;
  bool overrun = false;
  bool locked = false;  ///< the drive is held off by the emergency stop
  bool broken = false;  ///< a tendon has broken; until its new epoch
  bool slack = false;   ///< a tendon hangs loose

  friend constexpr bool operator==(const LifeStatus&, const LifeStatus&) = default;
};

/// What is counted of a wire.
enum class WireEvent : std::uint8_t {
  above_50,  ///< excursions above 50 % of the ultimate tension
  above_70,
  above_90,
  slack,  ///< times that it hung loose
};

/// What is advised to the drive.
enum class AdviceState : std::uint8_t {
  off,          ///< nothing is wanted of the wire
  unknown,      ///< no minute was seen yet
  no_limit,     ///< the load as it is lets it last
  limited,      ///< less tension, or less pace, lets it last
  unreachable,  ///< no tension with which it still pulls lets it last
  over,         ///< it has lasted as long as was wanted
};

/// Pages of LifeDetail. Each has its number as the multiplexor.
namespace detail {

struct Identity {
  static constexpr std::uint8_t kPage = 0;
  std::uint8_t schema = 0;          ///< version of this frame plan
  std::uint8_t firmware = 0;        ///< version, major in the high 4 bits, minor in the low
  std::uint32_t configuration = 0;  ///< CRC-32 over the parameter blocks

  friend constexpr bool operator==(const Identity&, const Identity&) = default;
};
struct Cycles {
  static constexpr std::uint8_t kPage = 1;
  static constexpr std::uint16_t kUnknownRate = 0xffff;  ///< no minute was seen yet
  std::uint32_t cycles = 0;  ///< closed, all tendons, this epoch; stops at 2^32 - 1
  std::uint16_t cycles_per_min = kUnknownRate;  ///< over the last minute; stops at 0xfffe

  friend constexpr bool operator==(const Cycles&, const Cycles&) = default;
};
struct DamageRate {
  static constexpr std::uint8_t kPage = 2;
  static constexpr std::uint32_t kUnknownRate = 0xffff'ffff;  ///< no minute was seen yet
  std::uint32_t ppb_per_h = kUnknownRate;  ///< worst tendon, over the last minute; stops below
  std::uint16_t unsaved_ppb = 0;           ///< what a power cut now would lose; stops

  friend constexpr bool operator==(const DamageRate&, const DamageRate&) = default;
};
struct TendonDamage {
  static constexpr std::uint8_t kPage = 3;
  std::uint8_t tendon = 0;
  std::uint32_t damage_ppb = 0;
  LifeState state = LifeState::unknown;

  friend constexpr bool operator==(const TendonDamage&, const TendonDamage&) = default;
};
struct RainflowBin {
  static constexpr std::uint8_t kPage = 4;
  std::uint8_t tendon = 0;       ///< 0 .. 31
  std::uint8_t range_class = 0;  ///< 0 .. 7, eighths of the ultimate tension; 7 is open above
  std::uint8_t mean_class = 0;   ///< 0 .. 7, eighths of the ultimate tension; 0 is open below
  std::uint8_t half_cycles = 0;  ///< open now, besides; stops at 31
  std::uint32_t cycles = 0;      ///< closed since the start; stops at 2^32 - 1

  friend constexpr bool operator==(const RainflowBin&, const RainflowBin&) = default;
};
/// Of the whole life of a new tendon: until B10, B50 and B90, which this one may have outlived.
struct RemainingLife {
  static constexpr std::uint8_t kPage = 5;
  static constexpr std::uint16_t kUnknown = 0xffff;  ///< no minute was seen yet
  /// Tenths of an hour at the present damage rate; stops at 0xfffe, also where there is no damage.
  std::uint16_t b10_dh = kUnknown;
  std::uint16_t b50_dh = kUnknown;
  std::uint16_t b90_dh = kUnknown;

  friend constexpr bool operator==(const RemainingLife&, const RemainingLife&) = default;
};
struct Storage {
  static constexpr std::uint8_t kPage = 6;
  std::uint32_t sequence = 0;  ///< of the last record, 24 bits; stops
  /// A power cut since the start would have lost at most this; 24 bits, all ones: it may be more.
  std::uint32_t worst_unsaved_ppb = 0;

  friend constexpr bool operator==(const Storage&, const Storage&) = default;
};
struct Timing {
  static constexpr std::uint8_t kPage = 7;
  std::uint16_t worst_jitter_us = 0;
  std::uint16_t p99_jitter_us = 0;
  std::uint16_t missed_deadlines = 0;

  friend constexpr bool operator==(const Timing&, const Timing&) = default;
};
struct Bus {
  static constexpr std::uint8_t kPage = 8;
  std::uint8_t transmit_errors = 0;
  std::uint8_t receive_errors = 0;
  std::uint8_t bus_offs = 0;
  std::uint8_t dropped = 0;   ///< detail pages that found no room
  std::uint16_t refused = 0;  ///< frames that failed the integrity check, and commands refused

  friend constexpr bool operator==(const Bus&, const Bus&) = default;
};

/// Given that the tendon is whole now: until it has broken with a probability of 10, 50 and 90 %.
struct ConditionalLife {
  static constexpr std::uint8_t kPage = 9;
  static constexpr std::uint16_t kUnknown = 0xffff;  ///< no minute was seen yet
  /// Tenths of an hour at the present damage rate; stops at 0xfffe, also where there is no damage.
  std::uint16_t to_10_dh = kUnknown;
  std::uint16_t to_50_dh = kUnknown;
  std::uint16_t to_90_dh = kUnknown;

  friend constexpr bool operator==(const ConditionalLife&, const ConditionalLife&) = default;
};
/// Given the same: the probability that it breaks soon, and how sure ConditionalLife is.
struct BreakRisk {
  static constexpr std::uint8_t kPage = 10;
  static constexpr std::uint16_t kUnknownRisk = (1u << 12) - 1;  ///< no minute was seen yet
  static constexpr std::uint16_t kSure = 4000;                   ///< a probability of 1
  static constexpr std::uint16_t kUnknownBound = (1u << 14) - 1;
  std::uint8_t horizon_h = 0;                   ///< of operation at the present damage rate
  std::uint16_t within_horizon = kUnknownRisk;  ///< probability, 0 .. kSure, rounded up
  /// 95 % interval of ConditionalLife::to_10_dh by the uncertainty of the fit and the scatter of
  /// the damage rate, in half hours, rounded outwards; stops below kUnknownBound.
  std::uint16_t to_10_low_30min = kUnknownBound;
  std::uint16_t to_10_high_30min = kUnknownBound;

  friend constexpr bool operator==(const BreakRisk&, const BreakRisk&) = default;
};

/// One tendon after the other, and of each the counts in turn.
struct WireHistory {
  static constexpr std::uint8_t kPage = 11;
  std::uint8_t tendon = 0;        ///< 0 .. 31
  bool broken = false;            ///< until its new epoch
  bool slack = false;             ///< now
  std::uint8_t peak_percent = 0;  ///< highest tension of the ultimate one, rounded up; stops at 255
  WireEvent event = WireEvent::above_50;
  std::uint16_t count = 0;              ///< of that, with this wire; 14 bits, stops
  std::uint16_t below_minimum_min = 0;  ///< time below the minimum tension; stops

  friend constexpr bool operator==(const WireHistory&, const WireHistory&) = default;
};

/// What each tendon may do so that it lasts as long as the model wants, one after the other. The
/// drive decides.
struct Advice {
  static constexpr std::uint8_t kPage = 12;
  static constexpr std::uint16_t kWhole = 4000;              ///< a ratio of 1
  static constexpr std::uint16_t kUnknown = (1u << 12) - 1;  ///< it is off, or unknown
  std::uint8_t tendon = 0;                                   ///< 0 .. 31
  AdviceState state = AdviceState::off;
  /// Peak of the load, scaled as a whole, relative to the ultimate tension, 0 .. kWhole; rounded
  /// down, as is the pace.
  std::uint16_t highest_tension = kUnknown;
  /// Instead of that: cycles in a time, relative to the heaviest minute since the start, 0 ..
  /// kWhole.
  std::uint16_t pace = kUnknown;

  friend constexpr bool operator==(const Advice&, const Advice&) = default;
};

inline constexpr std::uint8_t kPages = 13;

}  // namespace detail

/// What an Emergency frame reports (CiA 301, 7.2.7: device specific codes 0xff00 and up). An event
/// that ends is reported once more, with `none` as the code and its register bit gone.
enum class EmergencyCode : std::uint16_t {
  none = 0x0000,  ///< all that was reported is over
  emergency_stop = 0xff01,
  life_inspect = 0xff11,
  life_replace = 0xff12,
  life_worn = 0xff13,
  overload = 0xff20,       ///< a tension reached the ultimate tension
  tendon_broken = 0xff21,  ///< the motor pulls at friction alone
  tendon_slack = 0xff22,   ///< a tendon moves below its minimum tension
  sensor = 0xff30,
  storage = 0xff40,         ///< the record cannot be written
  record_damaged = 0xff41,  ///< no trustworthy record of the past was found
  parameters = 0xff50,      ///< a tendon has no valid parameter block
  settings = 0xff51,        ///< the node has no whole settings: nobody has authority
  bus = 0xff60,             ///< the controller was off the bus
  deadline = 0xff70,        ///< the control loop was late
  authority = 0xff80,       ///< authentication failed repeatedly
};

struct Emergency {
  EmergencyCode code = EmergencyCode::none;
  std::uint8_t error_register = 0;  ///< CiA 301, 7.5.2.2
  std::uint32_t damage_ppm = 0;     ///< of the worst tendon, 24 bits; stops

  friend constexpr bool operator==(const Emergency&, const Emergency&) = default;
};

enum class CommandCode : std::uint8_t {
  identify = 1,     ///< the status light blinks for `argument` seconds, 0 .. 255
  select_page = 2,  ///< the next LifeDetail is page `argument`
  burst = 3,        ///< the next `argument` LifeDetail pages of all leave at the inhibit time
};

/// Harmless: changes nothing but what is shown.
struct Command {
  CommandCode code = CommandCode::identify;
  std::uint8_t argument = 0;

  friend constexpr bool operator==(const Command&, const Command&) = default;
};

}  // namespace protocol
