#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "tests/virtual_g431/board/agenda.hpp"
#include "tests/virtual_g431/board/clocks.hpp"
#include "tests/virtual_g431/board/peripheral.hpp"

namespace virtual_g431 {

/// What the three amplifiers give at one instant, as counts 0 .. 4095.
using PhaseCounts = std::array<std::uint32_t, 3>;
inline constexpr PhaseCounts kAtRest{2048, 2048, 2048};

/// The operational amplifiers of category 2 devices, RM0440 25, as UM2516 wires them: gain 16,
/// bias on VINM0, output inside the device.
class Amplifiers : public Peripheral {
 public:
  explicit Amplifiers(Rules& rules) : rules_(rules) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override { csr_ = {}; }

  /// Whether the converters see amplifier `index`, 0 .. 2.
  [[nodiscard]] bool connected(std::size_t index) const { return (csr_[index] & 0x101) == 0x101; }

 private:
  Rules& rules_;
  std::array<std::uint32_t, 3> csr_{};
};

/// ADC1 and ADC2 with what they share, RM0440 21: injected conversions of the amplifiers, started
/// by TRGO2 of TIM1.
class Converters : public Peripheral {
 public:
  Converters(Agenda& agenda, Rules& rules, const Clocks& clocks, const Amplifiers& amplifiers)
      : agenda_(agenda), rules_(rules), clocks_(clocks), amplifiers_(amplifiers) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

  void trigger();
  /// The line of interrupt 18.
  [[nodiscard]] bool interrupt() const;

  /// The signal; asked once at each trigger that converts.
  std::function<PhaseCounts(Ticks)> signal = [](Ticks) { return kAtRest; };
  /// What was converted last, by both, and how often so far.
  [[nodiscard]] const PhaseCounts& counts() const { return counts_; }
  [[nodiscard]] std::uint64_t conversions() const { return conversions_; }
  /// Triggers that found a conversion under way.
  [[nodiscard]] std::uint64_t collisions() const { return collisions_; }
  /// ES0431 2.5.7, 2.5.8: so many first conversions after a start read something else.
  std::uint32_t wrong_first_conversions = 1;
  /// A converter that never gets ready.
  bool broken = false;

 private:
  struct Converter {
    std::array<std::uint32_t, 0x34> registers{};  ///< 0x00 .. 0xCC
    std::uint32_t isr = 0, cr = 0;
    Ticks regulated_at = 0, calibrated_at = 0;
    std::uint32_t converting = 0;  ///< conversions left of the sequence
    std::uint32_t since_start = 0;
    [[nodiscard]] std::uint32_t at(std::uint32_t offset) const { return registers[offset / 4]; }
  };

  [[nodiscard]] Ticks cycle() const;  ///< ticks of one cycle of the converters
  void write_cr(std::size_t which, std::uint32_t value);
  void convert(std::size_t which, std::uint32_t rank);
  [[nodiscard]] std::uint32_t input(std::size_t which, std::uint32_t channel);

  Agenda& agenda_;
  Rules& rules_;
  const Clocks& clocks_;
  const Amplifiers& amplifiers_;
  std::array<Converter, 2> converters_{};
  std::uint32_t ccr_ = 0;
  std::uint64_t life_ = 0;
  PhaseCounts counts_ = kAtRest;
  std::uint64_t conversions_ = 0;
  std::uint64_t collisions_ = 0;
};

}  // namespace virtual_g431
