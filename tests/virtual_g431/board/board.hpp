#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "tests/virtual_g431/board/agenda.hpp"
#include "tests/virtual_g431/board/analog.hpp"
#include "tests/virtual_g431/board/can.hpp"
#include "tests/virtual_g431/board/clocks.hpp"
#include "tests/virtual_g431/board/core.hpp"
#include "tests/virtual_g431/board/flash.hpp"
#include "tests/virtual_g431/board/lines.hpp"
#include "tests/virtual_g431/board/peripheral.hpp"
#include "tests/virtual_g431/board/small_peripherals.hpp"
#include "tests/virtual_g431/board/timers.hpp"

namespace virtual_g431 {

/// Pages as the firmware's README has them.
inline constexpr std::uint32_t kNodePageOffset = 43 * kPageBytes;
inline constexpr std::uint32_t kStoreOffset = 44 * kPageBytes;

/// A B-G431B-ESC1 with an STM32G431CB, its resistors, a contact for the emergency stop and a tester
/// on its bus. It runs what is in its flash, and is off at first.
///
/// Whatever happens, it holds for rules of the firmware that the drive is enabled only while the
/// brake is released, both only after 100 periods of the control loop came in time, and neither
/// 2.2 ms after the stop has opened.
class Board {
 public:
  /// `contents` outlives the board; junk is drawn from `seed`.
  explicit Board(FlashContents& contents, std::uint32_t seed = 1);

  /// Memory is junk, peripherals as after reset.
  void power_on();
  /// At once; an operation of the flash is torn by a share of its bits.
  void power_off(double torn_share = 0.5);
  /// Time goes on, with the power on or off.
  void run(Ticks span);
  /// Until then at most; true where the condition came true, looked at after each `step`.
  template <class Condition>
  bool run_until(Condition condition, Ticks most, Ticks step = kMillisecond) {
    const Ticks end = agenda.now() + most;
    while (!condition()) {
      if (agenda.now() >= end) {
        return false;
      }
      run(step);
    }
    return true;
  }

  /// The emergency stop is a contact to ground; open, it stops.
  void open_stop(bool open);
  [[nodiscard]] bool drive_enabled() const { return powered_ && port_b.level(3); }
  [[nodiscard]] bool brake_released() const { return powered_ && port_a.level(15); }
  [[nodiscard]] bool terminated() const { return powered_ && port_c.level(14); }
  [[nodiscard]] Ticks powered_at() const { return powered_at_; }

  /// Edges of drive enable and brake release since the power came.
  struct Edge {
    Ticks at;
    bool drive;  ///< drive enable, or else brake release
    bool high;
  };
  std::vector<Edge> edges;
  struct Reset {
    Ticks at;
    ResetCause cause;
  };
  std::vector<Reset> resets;
  /// Entries of the interrupt of the control loop, with what was converted before each.
  struct Period {
    Ticks at;
    PhaseCounts counts;
  };
  std::vector<Period> periods;
  /// So much of the past is kept; 0 keeps all.
  std::size_t most_periods = 0;

  /// Rules that the firmware broke, with what the memory around it shows.
  [[nodiscard]] std::vector<std::string> broken_rules();

  Agenda agenda;
  Rules rules;
  FlashContents& contents;
  Clocks clocks{agenda, rules};
  Flash flash{agenda, rules, contents};
  Port port_a{rules, "GPIOA", {0xABFFFFFF, 0x0C000000, 0x64000000}};
  Port port_b{rules, "GPIOB", {0xFFFFFEBF, 0, 0x00000100}};
  Port port_c{rules, "GPIOC", {}};
  MicrosecondTimer tim2{agenda, rules, clocks};
  TriggerTimer tim1{agenda, rules, clocks};
  Amplifiers amplifiers{rules};
  Converters converters{agenda, rules, clocks, amplifiers};
  CanController can{agenda, rules, clocks};
  NoiseSource noise{agenda, rules, clocks};
  Watchdog watchdog{agenda, rules};
  std::unique_ptr<Core> core;

 private:
  static constexpr std::size_t kSram = 0x5800, kSramMapped = 0x6000, kCcm = 0x2800,
                               kCcmMapped = 0x3000;
  /// Code is mapped up to here; pages from here on go through the model.
  static constexpr std::uint32_t kCode = 42 * kPageBytes;

  struct Place {
    std::uint32_t base, size;
    Peripheral* peripheral;
    const char* name;
    /// Where its clock is enabled; nothing where it always is.
    std::uint32_t (Clocks::*enable)() const;
    unsigned enable_bit;
  };

  const Place* find(std::uint32_t address, unsigned size, const char* how);
  std::uint32_t read(std::uint32_t address, unsigned size);
  void write(std::uint32_t address, unsigned size, std::uint32_t value);
  void reset();
  void start_over();
  void reset_peripherals();
  void note_lines();

  std::mt19937 random_;
  std::vector<Place> places_;
  bool powered_ = false;
  bool watchdog_bit_ = false;
  Ticks powered_at_ = 0;
  bool last_drive_ = false, last_brake_ = false;
  bool resetting_ = false;
  Ticks last_period_ = 0;
  std::uint32_t in_time_ = 0;  ///< periods of the control loop in a row, since the last reset
  std::uint64_t stops_ = 0;    ///< changes of the stop
  alignas(4096) std::array<std::uint8_t, kSramMapped> sram_{};
  alignas(4096) std::array<std::uint8_t, kCcmMapped> ccm_{};
  alignas(4096) std::array<std::uint8_t, 0x1000> system_memory_{};
  std::vector<std::uint8_t> beyond_sram_, beyond_ccm_;
};

}  // namespace virtual_g431
