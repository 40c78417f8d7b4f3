#include "tests/virtual_g431/board/clocks.hpp"

#include <array>

namespace virtual_g431 {
namespace {

// RCC_CR
constexpr std::uint32_t kHsiOn = bit(8), kHsiReady = bit(10), kHseOn = bit(16), kHseReady = bit(17);
constexpr std::uint32_t kCssOn = bit(19), kPllOn = bit(24), kPllReady = bit(25);
constexpr std::uint32_t kSwitchHsi = 1, kSwitchHse = 2, kSwitchPll = 3;
constexpr Ticks kHsiPeriod = 85;   // 16 MHz
constexpr Ticks kHsePeriod = 170;  // 8 MHz

}  // namespace

void Clocks::reset() {
  ++life_;
  cr_ = kHsiOn | kHsiReady;
  cfgr_ = kSwitchHsi | kSwitchHsi << 2;
  pllcfgr_ = 0x1000;
  cier_ = cifr_ = 0;
  ahb1enr_ = bit(8);
  ahb2enr_ = apb1enr1_ = apb2enr_ = 0;
  ccipr_ = crrcr_ = 0;
  just_enabled_ = false;
}

Ticks Clocks::hclk_divisor() const {
  constexpr std::array<Ticks, 8> kDivisors{2, 4, 8, 16, 64, 128, 256, 512};
  const std::uint32_t code = field(cfgr_, 7, 4);
  return code < 8 ? 1 : kDivisors[code - 8];
}

Ticks Clocks::system() const {
  switch (field(cfgr_, 3, 2)) {
    case kSwitchPll:
      return pll_period_;
    case kSwitchHse:
      return kHsePeriod;
    default:
      return kHsiPeriod;
  }
}

/// RM0440 7.2.4 and 7.4.4; the limits are those of range 1 boosted.
Ticks Clocks::pll_period() {
  const std::uint32_t source = field(pllcfgr_, 1, 0);
  const Ticks input = source == 3 ? kHsePeriod : kHsiPeriod;
  rules_.require(source >= 2, "PLL without a source");
  rules_.require((cr_ & (source == 3 ? kHseReady : kHsiReady)) != 0,
                 "PLL on before its source is ready");
  const Ticks m = field(pllcfgr_, 7, 4) + 1;
  const Ticks n = field(pllcfgr_, 14, 8);
  const Ticks r = 2 * (field(pllcfgr_, 26, 25) + 1);
  // MHz of the oscillators are 1360 / period.
  const double reference_MHz = 1360.0 / static_cast<double>(input * m);
  const double vco_MHz = reference_MHz * static_cast<double>(n);
  rules_.require(reference_MHz >= 2.66 && reference_MHz <= 16,
                 "reference of the PLL out of 2.66 .. 16 MHz");
  rules_.require(n >= 8 && n <= 127 && vco_MHz >= 96 && vco_MHz <= 344,
                 "VCO of the PLL out of 96 .. 344 MHz");
  rules_.require((pllcfgr_ & bit(24)) != 0, "PLL without its output R");
  rules_.require(n != 0 && input * m * r % n == 0,
                 "a clock that the time of the virtual board cannot tell");
  return n == 0 ? kHsiPeriod : input * m * r / n;
}

/// RM0440 5.3.3 table 29, 6.1.5.
void Clocks::check_clock(const char* when) {
  const bool boosted = (power.cr5_ & bit(8)) == 0;
  const bool range_1 = field(power.cr1_, 10, 9) == 1;
  const Ticks period = hclk();
  const std::uint32_t MHz = static_cast<std::uint32_t>((1360 + period - 1) / period);
  const std::uint32_t per_state = !range_1 ? 12 : boosted ? 34 : 30;
  const std::uint32_t highest = !range_1 ? 26 : boosted ? 170 : 150;
  rules_.require(MHz <= highest, std::string(when) + ": " + std::to_string(MHz) +
                                     " MHz without the voltage for it");
  rules_.require(MHz <= per_state * (wait_states() + 1),
                 std::string(when) + ": too few wait states for " + std::to_string(MHz) + " MHz");
  rules_.require(agenda_.now() >= power.settled_at_ || MHz <= 26,
                 std::string(when) + ": before the voltage has settled");
}

void Clocks::write_cr(std::uint32_t value) {
  const std::uint32_t set = value & ~cr_;
  const std::uint32_t cleared = cr_ & ~value & (kHsiOn | kHseOn | kPllOn);
  const auto life = life_;
  const auto ready_in = [this, life](Ticks span, std::uint32_t on, std::uint32_t ready) {
    agenda_.in(span, [this, life, on, ready] {
      if (life == life_ && (cr_ & on) != 0) {
        cr_ |= ready;
      }
    });
  };
  const bool pll_feeds = runs_on_pll() && field(pllcfgr_, 1, 0) == 3;
  rules_.require((cleared & kPllOn) == 0 || !runs_on_pll(), "PLL off while the system runs on it");
  rules_.require((cleared & kHseOn) == 0 || !pll_feeds, "HSE off while the system runs on it");
  rules_.require((cleared & kHsiOn) == 0 || field(cfgr_, 3, 2) != kSwitchHsi,
                 "HSI off while the system runs on it");
  cr_ = (cr_ & (kHsiReady | kHseReady | kPllReady | kCssOn)) |
        (value & (kHsiOn | kHseOn | kPllOn | kCssOn));
  cr_ &= ~((cleared & kHsiOn) << 2 | (cleared & kHseOn) << 1 | (cleared & kPllOn) << 1);
  if ((set & kHsiOn) != 0) {
    ready_in(2 * kMicrosecond, kHsiOn, kHsiReady);
  }
  if ((set & kHseOn) != 0 && crystal_) {
    ready_in(2 * kMillisecond, kHseOn, kHseReady);  // DS12589, typical
  }
  if ((set & kPllOn) != 0) {
    pll_period_ = pll_period();
    ready_in(40 * kMicrosecond, kPllOn, kPllReady);  // DS12589, longest
  }
  rules_.require((set & kCssOn) == 0 || (cr_ & kHseReady) != 0, "CSS on before HSE is ready");
}

void Clocks::write_cfgr(std::uint32_t value) {
  const Ticks before = hclk();
  const std::uint32_t wanted = field(value, 1, 0);
  const std::uint32_t ready = wanted == kSwitchPll   ? kPllReady
                              : wanted == kSwitchHse ? kHseReady
                                                     : kHsiReady;
  if ((cr_ & ready) == 0) {
    rules_.broken("switch to a clock that is not ready");
    return;
  }
  const auto halved = [this] { return runs_on_pll() && hclk_divisor() == 2; };
  const bool was_halved = halved();
  cfgr_ = (value & ~0xCu) | wanted << 2;
  const Ticks after = hclk();
  if (after < before) {
    check_clock("clock raised");
  }
  // RM0440 6.1.5: above 80 MHz only by way of half of it, for 1 us.
  if (after < before && 1360 / after > 80 && !halved()) {
    rules_.require(was_halved && agenda_.now() - halved_since_ >= kMicrosecond,
                   "more than 80 MHz without 1 us of half of it before");
  }
  if (halved() && !was_halved) {
    halved_since_ = agenda_.now();
  }
}

std::uint32_t Clocks::read(std::uint32_t offset) {
  switch (offset) {
    case 0x00:
      return cr_;
    case 0x08:
      return cfgr_;
    case 0x0C:
      return pllcfgr_;
    case 0x18:
      return cier_;
    case 0x1C:
      return cifr_;
    case 0x48:
      return ahb1enr_;
    case 0x4C:
      return ahb2enr_;
    case 0x58:
      return apb1enr1_;
    case 0x60:
      return apb2enr_;
    case 0x88:
      return ccipr_;
    case 0x94:
      return csr_;
    case 0x98:
      return crrcr_;
    default:
      rules_.broken("RCC: read of " + hex(offset));
      return 0;
  }
}

void Clocks::write(std::uint32_t offset, std::uint32_t value) {
  const auto enable = [this, value](std::uint32_t& enabled) {
    enabled = value;
    just_enabled_ = true;
  };
  switch (offset) {
    case 0x00:
      return write_cr(value);
    case 0x08:
      return write_cfgr(value);
    case 0x0C:
      rules_.require((cr_ & (kPllOn | kPllReady)) == 0, "PLLCFGR written while the PLL is on");
      pllcfgr_ = value;
      return;
    case 0x20:
      cifr_ &= ~value;
      return;
    case 0x48:
      return enable(ahb1enr_);
    case 0x4C:
      return enable(ahb2enr_);
    case 0x58:
      return enable(apb1enr1_);
    case 0x60:
      return enable(apb2enr_);
    case 0x88:
      ccipr_ = value;
      return;
    case 0x94:
      if ((value & bit(23)) != 0) {
        csr_ &= ~kCauses;
      }
      return;
    case 0x98:
      crrcr_ = (crrcr_ & 2) | (value & 1);
      if ((value & 1) != 0) {
        const auto life = life_;
        agenda_.in(6 * kMicrosecond, [this, life] { crrcr_ |= life == life_ ? 2u : 0u; });
      }
      return;
    default:
      rules_.broken("RCC: write of " + hex(offset));
  }
}

/// RM0440 7.2.9: the security system takes the internal oscillator and raises the NMI.
void Clocks::fail_crystal() {
  crystal_ = false;
  if ((cr_ & kHseReady) == 0) {
    return;
  }
  const bool used = runs_on_pll() && field(pllcfgr_, 1, 0) == 3;
  cr_ &= ~kHseReady;
  if ((cr_ & kCssOn) != 0) {
    cr_ &= ~(kHseOn | (used ? kPllOn | kPllReady : 0));
    cifr_ |= bit(8);
    if (used) {
      cfgr_ = (cfgr_ & ~0xFu) | kSwitchHsi | kSwitchHsi << 2;
    }
  }
}

std::uint32_t Clocks::Power::read(std::uint32_t offset) {
  switch (offset) {
    case 0x00:
      return cr1_;
    case 0x08:
      return cr3_;
    case 0x14:
      return clocks_.agenda_.now() < settled_at_ ? bit(10) : 0;
    case 0x80:
      return cr5_;
    default:
      clocks_.rules_.broken("PWR: read of " + hex(offset));
      return 0;
  }
}

void Clocks::Power::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case 0x00:
      clocks_.rules_.require(field(value, 10, 9) == 1 || field(value, 10, 9) == 2,
                             "PWR: VOS of no range");
      if (field(value, 10, 9) != field(cr1_, 10, 9)) {
        settled_at_ = clocks_.agenda_.now() + 20 * kMicrosecond;
      }
      cr1_ = value;
      return;
    case 0x08:
      cr3_ = value;
      return;
    case 0x80:
      // RM0440 6.1.5: the range changes at less than 80 MHz only.
      clocks_.rules_.require(1360 / clocks_.hclk() <= 80, "PWR: boost changed above 80 MHz");
      if (value != cr5_) {
        settled_at_ = clocks_.agenda_.now() + 20 * kMicrosecond;
      }
      cr5_ = value;
      return;
    default:
      clocks_.rules_.broken("PWR: write of " + hex(offset));
  }
}

void Clocks::Power::reset() {
  cr1_ = 0x200;
  cr3_ = 0x8000;
  cr5_ = 0x100;
  settled_at_ = 0;
}

}  // namespace virtual_g431
