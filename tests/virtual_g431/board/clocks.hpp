#pragma once

#include <cstdint>
#include <functional>

#include "tests/virtual_g431/board/agenda.hpp"
#include "tests/virtual_g431/board/peripheral.hpp"

namespace virtual_g431 {

/// Why the device started; the flags of RCC_CSR (RM0440 7.4.28).
enum class ResetCause : std::uint32_t {
  power = bit(27) | bit(26),
  software = bit(28) | bit(26),
  watchdog = bit(29) | bit(26)
};

/// Reset and clock control (RM0440 7) with power control (RM0440 6), which limits the clock.
class Clocks : public Peripheral {
 public:
  Clocks(Agenda& agenda, Rules& rules) : agenda_(agenda), rules_(rules) { reset(); }

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;
  void note(ResetCause cause) { csr_ = (csr_ & ~kCauses) | static_cast<std::uint32_t>(cause); }

  /// The power control has its own base address.
  class Power : public Peripheral {
   public:
    explicit Power(Clocks& clocks) : clocks_(clocks) {}
    std::uint32_t read(std::uint32_t offset) override;
    void write(std::uint32_t offset, std::uint32_t value) override;
    void reset() override;

   private:
    friend Clocks;
    Clocks& clocks_;
    std::uint32_t cr1_ = 0x200, cr3_ = 0x8000, cr5_ = 0x100;
    Ticks settled_at_ = 0;
  };
  Power power{*this};

  /// Ticks of one cycle of the core and of AHB.
  [[nodiscard]] Ticks hclk() const { return system() * hclk_divisor(); }
  [[nodiscard]] Ticks pclk1() const { return hclk() * bus_divisor(field(cfgr_, 10, 8)); }
  [[nodiscard]] Ticks pclk2() const { return hclk() * bus_divisor(field(cfgr_, 13, 11)); }
  /// The kernel clock of FDCAN comes from PCLK1 (RM0440 7.4.26).
  [[nodiscard]] bool can_from_bus() const { return field(ccipr_, 25, 24) == 2; }
  /// HSI48 runs and feeds the random number generator.
  [[nodiscard]] bool has_48MHz() const { return (crrcr_ & 3) == 3 && field(ccipr_, 27, 26) == 0; }
  [[nodiscard]] bool runs_on_pll() const { return field(cfgr_, 3, 2) == 3; }
  [[nodiscard]] bool css_pending() const { return (cifr_ & bit(8)) != 0; }

  [[nodiscard]] std::uint32_t ahb1() const { return ahb1enr_; }
  [[nodiscard]] std::uint32_t ahb2() const { return ahb2enr_; }
  [[nodiscard]] std::uint32_t apb1() const { return apb1enr1_; }
  [[nodiscard]] std::uint32_t apb2() const { return apb2enr_; }
  /// The last access was the write that changed a clock enable (RM0440 7.2.17: two cycles).
  [[nodiscard]] bool just_enabled() const { return just_enabled_; }
  void accessed_other() { just_enabled_ = false; }

  /// The crystal: it starts where it is fitted, and may fail while it runs.
  void fit_crystal(bool fitted) { crystal_ = fitted; }
  void fail_crystal();

  /// FLASH_ACR's wait states, which have to fit the clock.
  std::function<std::uint32_t()> wait_states = [] { return 0u; };

 private:
  static constexpr std::uint32_t kCauses = 0xFF000000u;
  static std::uint64_t bus_divisor(std::uint32_t code) { return code < 4 ? 1 : 2u << (code - 4); }

  [[nodiscard]] Ticks hclk_divisor() const;
  [[nodiscard]] Ticks system() const;
  [[nodiscard]] Ticks pll_period();
  void write_cr(std::uint32_t value);
  void write_cfgr(std::uint32_t value);
  void check_clock(const char* when);

  Agenda& agenda_;
  Rules& rules_;
  bool crystal_ = true;
  bool just_enabled_ = false;
  std::uint64_t life_ = 0;  ///< of this reset; what was under way before it is void
  std::uint32_t cr_ = 0, cfgr_ = 0, pllcfgr_ = 0, cier_ = 0, cifr_ = 0;
  std::uint32_t ahb1enr_ = 0, ahb2enr_ = 0, apb1enr1_ = 0, apb2enr_ = 0;
  std::uint32_t ccipr_ = 0, csr_ = 0, crrcr_ = 0;
  Ticks pll_period_ = 8;
  Ticks halved_since_ = 0;
};

}  // namespace virtual_g431
