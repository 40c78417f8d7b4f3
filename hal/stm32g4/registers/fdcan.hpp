#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// CAN controller, RM0440 44.4.
template <Word W>
struct FdcanRegisters {
  W crel, endn;
  W reserved_08;
  W dbtp, test, rwd, cccr, nbtp, tscc, tscv, tocc, tocv;
  W reserved_30[4];
  W ecr, psr, tdcr;
  W reserved_4c;
  W ir, ie, ils, ile;
  W reserved_60[8];
  W rxgfc, xidam, hpms;
  W reserved_8c;
  W rxf0s, rxf0a, rxf1s, rxf1a;
  W reserved_a0[8];
  W txbc, txfqs, txbrp, txbar, txbcr, txbto, txbcf, txbtie, txbcie, txefs, txefa;
  W reserved_ec[5];
  W ckdiv;
};
static_assert(offsetof(FdcanRegisters<Register>, cccr) == 0x18);
static_assert(offsetof(FdcanRegisters<Register>, nbtp) == 0x1C);
static_assert(offsetof(FdcanRegisters<Register>, ecr) == 0x40);
static_assert(offsetof(FdcanRegisters<Register>, psr) == 0x44);
static_assert(offsetof(FdcanRegisters<Register>, ir) == 0x50);
static_assert(offsetof(FdcanRegisters<Register>, rxgfc) == 0x80);
static_assert(offsetof(FdcanRegisters<Register>, rxf0s) == 0x90);
static_assert(offsetof(FdcanRegisters<Register>, txbc) == 0xC0);
static_assert(offsetof(FdcanRegisters<Register>, txbar) == 0xCC);
static_assert(offsetof(FdcanRegisters<Register>, ckdiv) == 0x100);

namespace fdcan {
// CCCR, 44.4.6
inline constexpr std::uint32_t kInit = bit(0), kConfigure = bit(1);
// NBTP, 44.4.7: all fields are one less than what they stand for
constexpr std::uint32_t bit_timing(std::uint32_t prescaler, std::uint32_t segment1,
                                   std::uint32_t segment2, std::uint32_t jump) {
  return (jump - 1) << 25 | (prescaler - 1) << 16 | (segment1 - 1) << 8 | (segment2 - 1);
}
// ECR, 44.4.12
constexpr std::uint32_t transmit_errors(std::uint32_t ecr) {
  return ecr & 0xFFu;
}
constexpr std::uint32_t receive_errors(std::uint32_t ecr) {
  return ecr >> 8 & 0x7Fu;
}
inline constexpr std::uint32_t kReceivePassive = bit(15);
// PSR, 44.4.13
inline constexpr std::uint32_t kPassive = bit(5), kWarning = bit(6), kBusOff = bit(7);
// IR, 44.4.15
inline constexpr std::uint32_t kFifo0Lost = bit(2);
// RXGFC, 44.4.19
inline constexpr std::uint32_t kRejectRemoteExtended = bit(0), kRejectRemoteStandard = bit(1);
inline constexpr std::uint32_t kRejectOtherExtended = 2u << 2, kRejectOtherStandard = 2u << 4;
constexpr std::uint32_t filters(std::uint32_t standard, std::uint32_t extended) {
  return standard << 16 | extended << 24;
}
// RXF0S, 44.4.22
constexpr std::uint32_t fill_level(std::uint32_t rxf0s) {
  return rxf0s & 0xFu;
}
constexpr std::uint32_t get_index(std::uint32_t rxf0s) {
  return rxf0s >> 8 & 3u;
}
// TXFQS, 44.4.27
inline constexpr std::uint32_t kTransmitFull = bit(21);
constexpr std::uint32_t put_index(std::uint32_t txfqs) {
  return txfqs >> 16 & 3u;
}
}  // namespace fdcan

}  // namespace hal::stm32g4
