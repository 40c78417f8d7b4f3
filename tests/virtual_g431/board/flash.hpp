#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <span>

#include "tests/virtual_g431/board/agenda.hpp"
#include "tests/virtual_g431/board/peripheral.hpp"

namespace virtual_g431 {

inline constexpr std::uint32_t kFlashBytes = 128 * 1024;
inline constexpr std::uint32_t kPageBytes = 2048;

/// What outlives a power cut: bits, and which double words their error code contradicts.
struct FlashContents {
  alignas(4096) std::array<std::uint8_t, kFlashBytes> bytes{};
  std::bitset<kFlashBytes / 8> damaged;

  FlashContents() { bytes.fill(0xFF); }
  /// Programs `data` as a programmer does; pages of what it does not reach stay.
  void flash(std::uint32_t offset, std::span<const std::uint8_t> data);
};

/// The flash interface of category 2 devices in one bank, RM0440 5.
///
/// An operation takes effect when it ends. A cut of the power before leaves a double word of which
/// some bits are programmed, or a page that is neither old nor erased.
class Flash : public Peripheral {
 public:
  /// An operation that begins: a double word, or a page.
  struct Operation {
    bool erases;
    std::uint32_t offset;
  };

  Flash(Agenda& agenda, Rules& rules, FlashContents& contents)
      : agenda_(agenda), rules_(rules), contents_(contents) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  /// Of the array; offsets from its start.
  std::uint32_t load(std::uint32_t offset, unsigned size);
  void store(std::uint32_t offset, std::uint32_t value, unsigned size);

  [[nodiscard]] bool busy() const { return operation_.has_value(); }
  [[nodiscard]] bool nmi() const { return (eccr_ & bit(31)) != 0; }
  [[nodiscard]] std::uint32_t wait_states() const { return acr_ & 15; }

  /// A double word is read that its error code contradicts, as `load` does with those of the store;
  /// of code, which the core reads by itself, a test says when.
  void meet_damage(std::uint32_t offset) {
    if ((eccr_ & bit(31)) == 0) {
      eccr_ = bit(31) | offset / 8;
    }
  }

  /// The power goes: what is under way is torn, by a share of 0 .. 1 of its bits.
  void tear(double share, std::mt19937& random);
  /// The same on a copy, while the operation goes on.
  void tear_copy(FlashContents& copy, double share, std::mt19937& random) const;

  /// Called when an operation begins.
  std::function<void(const Operation&)> on_begin = [](const Operation&) {};
  /// Offsets that may be written; the firmware has no business elsewhere.
  std::uint32_t writable_from = kFlashBytes;
  Ticks erase_time = 22 * kMillisecond;    ///< DS12589, typical
  Ticks program_time = 85 * kMicrosecond;  ///< DS12589, typical 81.7, longest 90

 private:
  void write_cr(std::uint32_t value);
  void write_acr(std::uint32_t value);
  void begin(Operation operation, Ticks span);
  void finish();
  [[nodiscard]] std::uint32_t word(std::uint32_t offset) const;
  void put(std::uint32_t offset, std::uint32_t value);

  Agenda& agenda_;
  Rules& rules_;
  FlashContents& contents_;
  std::uint32_t acr_ = 0, sr_ = 0, cr_ = 0, eccr_ = 0;
  unsigned keys_ = 0;                        ///< given so far
  bool locked_out_ = false;                  ///< a wrong key: until reset
  std::optional<std::uint32_t> first_half_;  ///< offset of a double word whose low word is there
  std::uint32_t low_ = 0, high_ = 0;
  std::optional<Operation> operation_;
  Agenda::Entry end_{};
  bool changed_ = false;  ///< the data cache may have what was there
};

}  // namespace virtual_g431
