#include "tests/virtual_g431/board/board.hpp"

#include <algorithm>

namespace virtual_g431 {
namespace {

constexpr std::uint32_t kSramBase = 0x20000000, kCcmBase = 0x10000000, kFlashBase = 0x08000000;
constexpr std::uint32_t kSystemMemory = 0x1FFF7000;
constexpr unsigned kAdcInterrupt = 18;  // RM0440 14.3

}  // namespace

Board::Board(FlashContents& contents_, std::uint32_t seed) : contents(contents_), random_(seed) {
  core = std::make_unique<Core>(
      agenda, rules,
      Core::Device{[this] { return clocks.hclk(); }, kAdcInterrupt,
                   [this] { return converters.interrupt(); },
                   [this] { return flash.nmi() || clocks.css_pending(); },
                   [this] { return flash.busy(); },
                   [this](std::uint32_t address, unsigned size) { return read(address, size); },
                   [this](std::uint32_t address, unsigned size, std::uint32_t value) {
                     write(address, size, value);
                   }});
  core->map_code(kFlashBase, contents.bytes.data(), kCode);
  core->map_device(kFlashBase + kCode, kFlashBytes - kCode);
  core->map_ram(kSramBase, sram_.data(), sram_.size());
  core->map_ram(kCcmBase, ccm_.data(), ccm_.size());
  core->map_code(kSystemMemory, system_memory_.data(), system_memory_.size());
  // RM0440 48.1: the unique identifier at 0x1FFF7590.
  for (std::size_t i = 0; i < 12; ++i) {
    system_memory_[0x590 + i] = static_cast<std::uint8_t>(0xA0 + i);
  }
  core->map_device(0x40000000, 0x30000);
  core->map_device(0x48000000, 0x2000);
  core->map_device(0x50000000, 0x61000);
  core->on_reset_request = [this] { reset(); };
  core->on_entry = [this](unsigned number) {
    if (number == exception::kInterrupt0 + kAdcInterrupt) {
      const Ticks since = agenda.now() - last_period_;
      in_time_ = since > 50 * kMicrosecond && since < 150 * kMicrosecond ? in_time_ + 1 : 0;
      last_period_ = agenda.now();
      if (most_periods != 0 && periods.size() >= 2 * most_periods) {
        periods.erase(periods.begin(), periods.end() - static_cast<std::ptrdiff_t>(most_periods));
      }
      periods.push_back({agenda.now(), converters.counts()});
    }
  };
  // RM0440 2.2.2 and 7.4.
  places_ = {
      {0x40000000, 0x400, &tim2, "TIM2", &Clocks::apb1, 0},
      {0x40003000, 0x400, &watchdog, "IWDG", nullptr, 0},
      {0x40006400, 0x400, &can, "FDCAN1", &Clocks::apb1, 25},
      {0x40007000, 0x400, &clocks.power, "PWR", &Clocks::apb1, 28},
      {0x4000A400, 0x350, &can.ram, "message RAM", &Clocks::apb1, 25},
      {0x40010300, 0x100, &amplifiers, "OPAMP", &Clocks::apb2, 0},
      {0x40012C00, 0x400, &tim1, "TIM1", &Clocks::apb2, 11},
      {0x40021000, 0x400, &clocks, "RCC", nullptr, 0},
      {0x40022000, 0x400, &flash, "FLASH", &Clocks::ahb1, 8},
      {0x48000000, 0x400, &port_a, "GPIOA", &Clocks::ahb2, 0},
      {0x48000400, 0x400, &port_b, "GPIOB", &Clocks::ahb2, 1},
      {0x48000800, 0x400, &port_c, "GPIOC", &Clocks::ahb2, 2},
      {0x50000000, 0x400, &converters, "ADC12", &Clocks::ahb2, 13},
      {0x50060800, 0x400, &noise, "RNG", &Clocks::ahb2, 26},
  };
  flash.writable_from = kStoreOffset;
  clocks.wait_states = [this] { return flash.wait_states(); };
  tim1.on_trigger = [this] { converters.trigger(); };
  watchdog.on_timeout = [this] {
    watchdog_bit_ = true;
    core->request_reset();
  };
  can.transceiver_on = [this] {
    // CAN shutdown low, and the lines at FDCAN1 (UM2516, DS12589).
    return !port_c.level(11) && port_c.mode(11) == 1 && port_a.mode(11) == 2 &&
           port_a.function(11) == 9 && port_b.mode(9) == 2 && port_b.function(9) == 9;
  };
  // The firmware's README: 4.7 kohm to ground; without CAN shutdown driven the transceiver is off.
  port_b.connect(3, false);
  port_a.connect(15, false);
  port_c.connect(11, true);
  open_stop(false);
  port_a.on_change = port_b.on_change = [this] { note_lines(); };
}

void Board::note_lines() {
  const bool drive = drive_enabled();
  const bool brake = brake_released();
  if (drive != last_drive_) {
    edges.push_back({agenda.now(), true, drive});
  }
  if (brake != last_brake_) {
    edges.push_back({agenda.now(), false, brake});
  }
  if (!resetting_) {
    const bool rose = (drive && !last_drive_) || (brake && !last_brake_);
    rules.require(!rose || in_time_ >= 100, "drive or brake let go without 100 periods in time");
    rules.require(!drive || brake, "drive enabled while the brake holds");
  }
  last_drive_ = drive;
  last_brake_ = brake;
}

void Board::open_stop(bool open) {
  port_b.connect(7, open ? std::nullopt : std::optional(false));
  const std::uint64_t change = ++stops_;
  if (open) {
    agenda.in(2200 * kMicrosecond, [this, change] {
      rules.require(change != stops_ || !(drive_enabled() || brake_released()),
                    "drive or brake let go 2.2 ms after the stop has opened");
    });
  }
}

void Board::power_on() {
  const auto junk = [this] { return static_cast<std::uint32_t>(random_()); };
  std::generate(sram_.begin(), sram_.end(), junk);
  std::generate(ccm_.begin(), ccm_.end(), junk);
  can.fill_ram(junk);
  beyond_sram_.assign(sram_.begin() + kSram, sram_.end());
  beyond_ccm_.assign(ccm_.begin() + kCcm, ccm_.end());
  powered_ = true;
  powered_at_ = agenda.now();
  edges.clear();
  resets.clear();
  periods.clear();
  start_over();
  clocks.note(ResetCause::power);
}

void Board::power_off(double torn_share) {
  flash.tear(torn_share, random_);
  powered_ = false;
  reset_peripherals();
}

/// All lines at once.
void Board::reset_peripherals() {
  resetting_ = true;
  for (const Place& place : places_) {
    place.peripheral->reset();
  }
  note_lines();
  resetting_ = false;
  in_time_ = 0;
}

/// An operation of the flash that is under way ends as if nothing had happened.
void Board::start_over() {
  reset_peripherals();
  core->reset();
}

void Board::reset() {
  const ResetCause cause = watchdog_bit_ ? ResetCause::watchdog : ResetCause::software;
  watchdog_bit_ = false;
  resets.push_back({agenda.now(), cause});
  start_over();
  clocks.note(cause);
}

void Board::run(Ticks span) {
  const Ticks end = agenda.now() + span;
  if (powered_) {
    core->run_until(end);
  }
  if (!core->stopped()) {
    agenda.advance_to(end);
  }
}

const Board::Place* Board::find(std::uint32_t address, unsigned size, const char* how) {
  const auto place =
      std::find_if(places_.begin(), places_.end(), [address](const Place& candidate) {
        return address >= candidate.base && address - candidate.base < candidate.size;
      });
  if (place == places_.end()) {
    rules.broken(std::string(how) + " " + hex(address) + ", where nothing is");
    return nullptr;
  }
  const auto refuse = [&](const char* what) {
    rules.broken(std::string(place->name) + ": " + how + what);
  };
  if (size != 4 || address % 4 != 0) {
    refuse(" of less than a word");
  }
  if (place->enable != nullptr) {
    if (clocks.just_enabled()) {
      refuse(" right after its clock was enabled");
    }
    if (((clocks.*place->enable)() >> place->enable_bit & 1) == 0) {
      refuse(" without its clock");
      return nullptr;
    }
  }
  clocks.accessed_other();
  return &*place;
}

std::uint32_t Board::read(std::uint32_t address, unsigned size) {
  if (address >= kFlashBase && address < kFlashBase + kFlashBytes) {
    while (flash.busy()) {
      agenda.advance_to(agenda.next());
    }
    return flash.load(address - kFlashBase, size);
  }
  const Place* place = find(address, size, "read");
  return place == nullptr ? 0 : place->peripheral->read(address - place->base);
}

void Board::write(std::uint32_t address, unsigned size, std::uint32_t value) {
  if (address >= kFlashBase && address < kFlashBase + kFlashBytes) {
    return flash.store(address - kFlashBase, value, size);
  }
  if (const Place* place = find(address, size, "write")) {
    place->peripheral->write(address - place->base, value);
  }
}

std::vector<std::string> Board::broken_rules() {
  if (!std::equal(beyond_sram_.begin(), beyond_sram_.end(), sram_.begin() + kSram)) {
    rules.broken("written beyond the SRAM");
  }
  if (!std::equal(beyond_ccm_.begin(), beyond_ccm_.end(), ccm_.begin() + kCcm)) {
    rules.broken("written beyond the CCM SRAM");
  }
  return rules.all();
}

}  // namespace virtual_g431
