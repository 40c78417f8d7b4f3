#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "hal/stm32g4/flash_memory.hpp"
#include "tests/stm32g4/model/rcc_model.hpp"
#include "tests/stm32g4/model/word.hpp"

namespace stm32g4_models {

/// RM0440 chapter 5: one bank of 64 pages, its interface, its data cache and its error code.
class FlashModel : public RegisterModel<hal::stm32g4::FlashRegisters<Word>> {
 public:
  static constexpr std::uint32_t kPages = 64;
  static constexpr std::uint32_t kPageBytes = 2048;

  explicit FlashModel(Supply& supply) : supply_(supply), array(*this) {
    registers.acr.hold(0x600);
    registers.cr.hold(0xC0000000);
    units_.assign(kPages * kPageBytes / 8, kErased);
  }

  /// The memory as the bus sees it.
  class Array {
   public:
    explicit Array(FlashModel& flash) : flash_(flash) {}
    hal::stm32g4::DoubleWord load(std::uint32_t offset) { return flash_.load(offset); }
    void store(std::uint32_t offset, hal::stm32g4::DoubleWord value) {
      flash_.store(offset, value);
    }

   private:
    FlashModel& flash_;
  };

 private:
  Supply& supply_;

 public:
  Array array;
  /// Called for the NMI of a double error.
  std::function<void()> nmi = [] { ADD_FAILURE() << "an NMI that nobody takes"; };
  /// Errors that the next operation ends with, as bits of SR; it then does nothing.
  std::uint32_t next_error = 0;
  /// The power goes in the middle of the next programming: the unit is torn.
  bool tear_next = false;
  /// An operation that never ends.
  bool stuck = false;
  unsigned operations = 0;
  /// Looks at SR until an operation ends, and what happens in the time between two of them.
  unsigned busy_looks = 7;
  std::function<void()> on_busy;

  /// Two bits of a unit are lost.
  void damage(std::uint32_t offset) { torn_.insert(offset / 8); }
  [[nodiscard]] std::uint64_t unit(std::uint32_t offset) const { return units_[offset / 8]; }

  /// The device starts again; what is stored stays.
  void reset() {
    registers.cr.hold(0xC0000000);
    registers.sr.hold(0);
    registers.eccr.hold(0);
    cache_.clear();
    keys_ = 0;
    barred_ = false;
    busy_ = {};
  }

  std::uint32_t on_read(const Word& word) override {
    if (&word == &registers.sr && busy_.pending() && on_busy) {
      on_busy();
    }
    if (&word == &registers.sr && busy_.due() && !stuck) {
      registers.sr.drop(1u << 16);
      registers.cr.drop(1u << 16);
    }
    return word.held();
  }

  void on_write(Word& word, std::uint32_t value) override {
    if (&word == &registers.keyr) {
      return write_key(value);
    }
    if (&word == &registers.sr) {
      registers.sr.drop(value & 0xFFFFu);
      return;
    }
    if (&word == &registers.eccr) {
      registers.eccr.drop(value & 0xC0000000u);
      return;
    }
    if (&word == &registers.cr) {
      return write_cr(value);
    }
    if (&word == &registers.acr) {
      EXPECT_FALSE((value & 1u << 12) != 0 && (value & 1u << 10) != 0)
          << "the data cache was reset while it is on (5.7.1)";
      if ((value & 1u << 12) != 0) {
        cache_.clear();
      }
      supply_.wait_states = value & 15u;
    }
    word.hold(value);
  }

 private:
  static constexpr std::uint64_t kErased = ~std::uint64_t{0};

  void write_key(std::uint32_t value) {
    EXPECT_FALSE(barred_) << "a key after a wrong one: locked until reset (5.3.5)";
    EXPECT_TRUE(registers.cr.has(1u << 31)) << "a key while the interface is not locked (5.3.5)";
    if (keys_ == 0 && value == 0x45670123u) {
      keys_ = 1;
    } else if (keys_ == 1 && value == 0xCDEF89ABu) {
      keys_ = 0;
      registers.cr.drop(1u << 31);
    } else {
      ADD_FAILURE() << "a wrong key (5.3.5)";
      barred_ = true;
    }
  }

  void write_cr(std::uint32_t value) {
    EXPECT_FALSE(registers.sr.has(1u << 16)) << "CR was written while an operation runs (5.7.6)";
    EXPECT_FALSE(registers.cr.has(1u << 31)) << "CR was written while it is locked (5.3.5)";
    if (registers.cr.has(1u << 31)) {
      return;
    }
    registers.cr.hold(value);
    if ((value & 1u << 16) != 0) {
      erase(value);
    }
  }

  void erase(std::uint32_t cr) {
    EXPECT_EQ(cr & 7u, 2u) << "STRT without PER alone (5.3.6)";
    const std::uint32_t page = cr >> 3 & 0x7Fu;
    EXPECT_LT(page, kPages) << "a page that is not there";
    if (start() && page < kPages) {
      for (std::uint32_t i = page * kPageBytes / 8; i < (page + 1) * kPageBytes / 8; ++i) {
        units_[i] = kErased;
        torn_.erase(i);
      }
    }
  }

  /// False where the operation ends with an error.
  bool start() {
    ++operations;
    registers.sr.raise(1u << 16);
    busy_.begin(busy_looks);
    const std::uint32_t error = next_error;
    next_error = 0;
    registers.sr.raise(error);
    return error == 0;
  }

  void store(std::uint32_t offset, hal::stm32g4::DoubleWord value) {
    EXPECT_EQ(offset % 8, 0u) << "programming of an odd address (PGAERR)";
    EXPECT_FALSE(registers.sr.has(1u << 16)) << "programming while an operation runs";
    if (!registers.cr.has(1) || (registers.sr.held() & 0xC3FAu) != 0) {
      ADD_FAILURE() << "programming without PG, or with old errors (PGSERR, 5.3.7)";
      registers.sr.raise(1u << 7);
      return;
    }
    if (!start()) {
      return;
    }
    const std::uint64_t wanted = std::uint64_t{value.high} << 32 | value.low;
    if (units_[offset / 8] != kErased && wanted != 0) {
      registers.sr.raise(1u << 3);
      return;
    }
    if (tear_next) {
      tear_next = false;
      units_[offset / 8] = wanted | 0x00FF00FF00FF00FFu;
      torn_.insert(offset / 8);
      return;
    }
    units_[offset / 8] = wanted;
  }

  hal::stm32g4::DoubleWord load(std::uint32_t offset) {
    EXPECT_EQ(offset % 8, 0u);
    EXPECT_FALSE(registers.sr.has(1u << 16)) << "a read of flash while an operation runs stalls";
    const std::uint32_t index = offset / 8;
    if (torn_.contains(index)) {
      registers.eccr.raise(1u << 31);
      nmi();
      EXPECT_FALSE(registers.eccr.has(1u << 31)) << "ECCD was not cleared: the NMI comes again";
    }
    std::uint64_t value = units_[index];
    if (registers.acr.has(1u << 10)) {
      value = cache_.try_emplace(index, value).first->second;
    }
    return {static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32)};
  }

  std::vector<std::uint64_t> units_;
  std::set<std::uint32_t> torn_;
  std::map<std::uint32_t, std::uint64_t> cache_;
  int keys_ = 0;
  bool barred_ = false;
  Delayed busy_;
};

}  // namespace stm32g4_models
