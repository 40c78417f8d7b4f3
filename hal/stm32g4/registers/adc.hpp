#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// One analog-to-digital converter, RM0440 21.6.
template <Word W>
struct AdcRegisters {
  W isr, ier, cr, cfgr, cfgr2;
  W smpr[2];
  W reserved_1c;
  W tr[3];
  W reserved_2c;
  W sqr[4];
  W dr;
  W reserved_44[2];
  W jsqr;
  W reserved_50[4];
  W ofr[4];
  W reserved_70[4];
  W jdr[4];
  W reserved_90[4];
  W awd2cr, awd3cr;
  W reserved_a8[2];
  W difsel, calfact;
};
static_assert(offsetof(AdcRegisters<Register>, cr) == 0x08);
static_assert(offsetof(AdcRegisters<Register>, smpr) == 0x14);
static_assert(offsetof(AdcRegisters<Register>, sqr) == 0x30);
static_assert(offsetof(AdcRegisters<Register>, jsqr) == 0x4C);
static_assert(offsetof(AdcRegisters<Register>, ofr) == 0x60);
static_assert(offsetof(AdcRegisters<Register>, jdr) == 0x80);
static_assert(offsetof(AdcRegisters<Register>, difsel) == 0xB0);

/// What ADC1 and ADC2 share, RM0440 21.7.
template <Word W>
struct AdcCommonRegisters {
  W csr;
  W reserved_04;
  W ccr, cdr;
};
static_assert(offsetof(AdcCommonRegisters<Register>, ccr) == 0x08);

namespace adc {
// ISR, 21.6.1
inline constexpr std::uint32_t kReady = bit(0), kInjectedEnd = bit(5), kInjectedSequence = bit(6);
// IER, 21.6.2
inline constexpr std::uint32_t kInjectedSequenceInterrupt = bit(6);
// CR, 21.6.3
inline constexpr std::uint32_t kEnable = bit(0), kInjectedStart = bit(3);
inline constexpr std::uint32_t kRegulator = bit(28), kDeepPowerDown = bit(29);
inline constexpr std::uint32_t kCalibrateDifferential = bit(30), kCalibrate = bit(31);
/// Bits that software can only set; writing them as read would start what is not meant.
inline constexpr std::uint32_t kSetOnly =
    bit(0) | bit(1) | bit(2) | bit(3) | bit(4) | bit(5) | bit(31);
// CFGR, 21.6.4
inline constexpr std::uint32_t kNoInjectedQueue = bit(31);
// SMPR2, 21.6.7: channels 10 .. 18; 24.5 cycles
constexpr std::uint32_t sample_24_5_cycles(unsigned channel) {
  return 3u << (3 * (channel - 10));
}
// JSQR, 21.6.16
constexpr std::uint32_t injected_length(std::uint32_t conversions) {
  return conversions - 1;
}
constexpr std::uint32_t injected_channel(unsigned rank, std::uint32_t channel) {
  return channel << (9 + 6 * (rank - 1));
}
inline constexpr std::uint32_t kTriggerTim1Trgo2 = 8u << 2, kRisingEdge = 1u << 7;
// CCR, 21.7.2
inline constexpr std::uint32_t kClockModeMask = 3u << 16, kHclkBy4 = 3u << 16;
}  // namespace adc

}  // namespace hal::stm32g4
