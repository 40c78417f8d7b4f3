#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

#include "firmware/protocol/messages.hpp"

namespace protocol::test {

using Random = std::mt19937_64;

/// A number of so many bits, often one of the ends.
inline std::uint32_t number(Random& random, unsigned bits) {
  const std::uint64_t largest = (std::uint64_t{1} << bits) - 1;
  switch (random() % 8) {
    case 0:
      return 0;
    case 1:
      return static_cast<std::uint32_t>(largest);
    default:
      return static_cast<std::uint32_t>(random() & largest);
  }
}
inline std::uint8_t u8(Random& random, unsigned bits = 8) {
  return static_cast<std::uint8_t>(number(random, bits));
}
inline std::uint16_t u16(Random& random) {
  return static_cast<std::uint16_t>(number(random, 16));
}
inline bool coin(Random& random) {
  return number(random, 1) != 0;
}
template <class T, std::size_t kSize>
T one_of(Random& random, const std::array<T, kSize>& values) {
  return values[random() % kSize];
}

inline LifeState life_state(Random& random) {
  return static_cast<LifeState>(random() % 5);
}

inline void fill(Random& random, Heartbeat& m) {
  m.state = one_of(random, std::array{NmtState::boot_up, NmtState::stopped, NmtState::operational});
}
inline void fill(Random& random, LifeStatus& m) {
  m = {.state = life_state(random),
       .damage_ppb = number(random, 32),
       .worst_tendon = u8(random, 5),
       .quality = static_cast<Quality>(random() % 5),
       .storage_ok = coin(random),
       .sensor_ok = coin(random),
       .gap = coin(random),
       .saturated = coin(random),
       .overrun = coin(random),
       .locked = coin(random),
       .broken = coin(random),
       .slack = coin(random)};
}
inline void fill(Random& random, detail::Identity& m) {
  m = {.schema = u8(random), .firmware = u8(random), .configuration = number(random, 32)};
}
inline void fill(Random& random, detail::Cycles& m) {
  m = {.cycles = number(random, 32), .cycles_per_min = u16(random)};
}
inline void fill(Random& random, detail::DamageRate& m) {
  m = {.ppb_per_h = number(random, 32), .unsaved_ppb = u16(random)};
}
inline void fill(Random& random, detail::TendonDamage& m) {
  m = {.tendon = u8(random, 5), .damage_ppb = number(random, 32), .state = life_state(random)};
}
inline void fill(Random& random, detail::RainflowBin& m) {
  m = {.tendon = u8(random, 5),
       .range_class = u8(random, 3),
       .mean_class = u8(random, 3),
       .half_cycles = u8(random, 5),
       .cycles = number(random, 32)};
}
inline void fill(Random& random, detail::RemainingLife& m) {
  m = {.b10_dh = u16(random), .b50_dh = u16(random), .b90_dh = u16(random)};
}
inline void fill(Random& random, detail::Storage& m) {
  m = {.sequence = number(random, 24), .worst_unsaved_ppb = number(random, 24)};
}
inline void fill(Random& random, detail::Timing& m) {
  m = {.worst_jitter_us = u16(random),
       .p99_jitter_us = u16(random),
       .missed_deadlines = u16(random)};
}
inline void fill(Random& random, detail::Bus& m) {
  m = {.transmit_errors = u8(random),
       .receive_errors = u8(random),
       .bus_offs = u8(random),
       .dropped = u8(random),
       .refused = u16(random)};
}
inline void fill(Random& random, detail::ConditionalLife& m) {
  m = {.to_10_dh = u16(random), .to_50_dh = u16(random), .to_90_dh = u16(random)};
}
inline void fill(Random& random, detail::BreakRisk& m) {
  const auto bits = [&](std::uint8_t count) {
    return static_cast<std::uint16_t>(number(random, count));
  };
  m = {.horizon_h = u8(random),
       .within_horizon = bits(12),
       .to_10_low_30min = bits(14),
       .to_10_high_30min = bits(14)};
}
inline void fill(Random& random, detail::WireHistory& m) {
  m = {.tendon = u8(random, 5),
       .broken = coin(random),
       .slack = coin(random),
       .peak_percent = u8(random),
       .event = static_cast<WireEvent>(random() % 4),
       .count = static_cast<std::uint16_t>(number(random, 14)),
       .below_minimum_min = u16(random)};
}
inline void fill(Random& random, detail::Advice& m) {
  m = {.tendon = u8(random, 5),
       .state = static_cast<AdviceState>(random() % 6),
       .highest_tension = static_cast<std::uint16_t>(number(random, 12)),
       .pace = static_cast<std::uint16_t>(number(random, 12))};
}
inline void fill(Random& random, Emergency& m) {
  constexpr std::array kCodes{EmergencyCode::none,           EmergencyCode::emergency_stop,
                              EmergencyCode::life_inspect,   EmergencyCode::life_replace,
                              EmergencyCode::life_worn,      EmergencyCode::overload,
                              EmergencyCode::tendon_broken,  EmergencyCode::tendon_slack,
                              EmergencyCode::sensor,         EmergencyCode::storage,
                              EmergencyCode::record_damaged, EmergencyCode::parameters,
                              EmergencyCode::settings,       EmergencyCode::bus,
                              EmergencyCode::deadline,       EmergencyCode::authority};
  m = {.code = one_of(random, kCodes),
       .error_register = u8(random),
       .damage_ppm = number(random, 24)};
}
inline void fill(Random& random, Command& m) {
  m = {.code = static_cast<CommandCode>(1 + random() % 3), .argument = u8(random)};
}

/// Calls `act` with a random message of a random kind.
template <class Act>
void with_random_message(Random& random, Act act) {
  const auto run = [&]<class Message>(Message message) {
    fill(random, message);
    act(message);
  };
  switch (random() % 17) {
    case 0:
      return run(Heartbeat{});
    case 1:
      return run(LifeStatus{});
    case 2:
      return run(detail::Identity{});
    case 3:
      return run(detail::Cycles{});
    case 4:
      return run(detail::DamageRate{});
    case 5:
      return run(detail::TendonDamage{});
    case 6:
      return run(detail::RainflowBin{});
    case 7:
      return run(detail::RemainingLife{});
    case 8:
      return run(detail::Storage{});
    case 9:
      return run(detail::Timing{});
    case 10:
      return run(detail::Bus{});
    case 11:
      return run(detail::ConditionalLife{});
    case 12:
      return run(detail::BreakRisk{});
    case 13:
      return run(detail::WireHistory{});
    case 14:
      return run(detail::Advice{});
    case 15:
      return run(Emergency{});
    default:
      return run(Command{});
  }
}

}  // namespace protocol::test
