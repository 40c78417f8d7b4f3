#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

/// Flash interface of category 2 devices, RM0440 5.7.
template <Word W>
struct FlashRegisters {
  W acr, pdkeyr, keyr, optkeyr, sr, cr, eccr;
  W reserved_1c;
  W optr;
};
static_assert(offsetof(FlashRegisters<Register>, keyr) == 0x08);
static_assert(offsetof(FlashRegisters<Register>, sr) == 0x10);
static_assert(offsetof(FlashRegisters<Register>, cr) == 0x14);
static_assert(offsetof(FlashRegisters<Register>, eccr) == 0x18);
static_assert(offsetof(FlashRegisters<Register>, optr) == 0x20);

namespace flash {
// ACR, 5.7.1
inline constexpr std::uint32_t kLatencyMask = 15, kLatency4 = 4;
inline constexpr std::uint32_t kPrefetch = bit(8), kInstructionCache = bit(9);
inline constexpr std::uint32_t kDataCache = bit(10), kDataCacheReset = bit(12);
// KEYR, 5.7.3
inline constexpr std::uint32_t kKey1 = 0x45670123, kKey2 = 0xCDEF89AB;
// SR, 5.7.5
inline constexpr std::uint32_t kEndOfOperation = bit(0), kOperationError = bit(1);
inline constexpr std::uint32_t kProgramError = bit(3), kWriteProtected = bit(4);
inline constexpr std::uint32_t kAlignmentError = bit(5), kSizeError = bit(6);
inline constexpr std::uint32_t kSequenceError = bit(7), kMissError = bit(8), kFastError = bit(9);
inline constexpr std::uint32_t kReadProtected = bit(14), kOptionError = bit(15);
inline constexpr std::uint32_t kBusy = bit(16);
inline constexpr std::uint32_t kAnyError = kOperationError | kProgramError | kWriteProtected |
                                           kAlignmentError | kSizeError | kSequenceError |
                                           kMissError | kFastError | kReadProtected | kOptionError;
// CR, 5.7.6
inline constexpr std::uint32_t kProgram = bit(0), kPageErase = bit(1), kStart = bit(16);
inline constexpr std::uint32_t kLock = bit(31);
constexpr std::uint32_t page(std::uint32_t number) {
  return number << 3;
}
// ECCR, 5.7.7
inline constexpr std::uint32_t kEccInterrupt = bit(24);
inline constexpr std::uint32_t kEccCorrected = bit(30), kEccDetected = bit(31);
}  // namespace flash

}  // namespace hal::stm32g4
