#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <array>
#include <numeric>

#include "hal/stm32g4/flash_memory.hpp"
#include "tests/stm32g4/model/chip.hpp"

namespace stm32g4_models {
namespace {

using hal::Error;
using Operations = hal::stm32g4::FlashOperations<Word, FlashModel::Array>;
using Bytes = std::array<std::byte, 8>;

Bytes bytes(int first) {
  Bytes result{};
  for (int i = 0; i < 8; ++i) {
    result[static_cast<std::size_t>(i)] = static_cast<std::byte>(first + i);
  }
  return result;
}

class Flash : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kFirstPage = 44;
  static constexpr std::uint32_t kStart = kFirstPage * 2048;

  ReadyChip chip;
  Operations operations{chip.flash.registers, chip.flash.array};
  hal::stm32g4::FlashMemory<Operations> memory{operations, kFirstPage, 20};
  int nmis = 0;

  void SetUp() override {
    chip.flash.nmi = [this] {
      ++nmis;
      EXPECT_TRUE(operations.isr_ecc_error());
    };
  }
  Error read(std::uint32_t address, std::span<std::byte> out) { return memory.read(address, out); }
};

TEST_F(Flash, ProgramsADoubleWordLowBytesFirst) {
  ASSERT_EQ(memory.program(16, bytes(0x10)), Error::none);
  EXPECT_EQ(chip.flash.unit(kStart + 16), 0x1716151413121110u);
  Bytes back{};
  EXPECT_EQ(read(16, back), Error::none);
  EXPECT_EQ(back, bytes(0x10));
}

TEST_F(Flash, IsLockedAfterEveryOperation) {
  ASSERT_EQ(memory.program(0, bytes(1)), Error::none);
  EXPECT_EQ(chip.flash.registers.cr.held(), 1u << 31);
  ASSERT_EQ(memory.erase(3), Error::none);
  EXPECT_EQ(chip.flash.registers.cr.held(), 1u << 31);
}

TEST_F(Flash, ErasesItsPageAndNoOther) {
  ASSERT_EQ(memory.program(2047 - 7, bytes(1)), Error::none);
  ASSERT_EQ(memory.program(2048, bytes(2)), Error::none);
  ASSERT_EQ(memory.program(4096, bytes(3)), Error::none);
  ASSERT_EQ(memory.erase(1), Error::none);
  EXPECT_EQ(chip.flash.unit(kStart + 2040), 0x0807060504030201u);
  EXPECT_EQ(chip.flash.unit(kStart + 2048), ~std::uint64_t{0});
  EXPECT_EQ(chip.flash.unit(kStart + 4096), 0x0A09080706050403u);
}

TEST_F(Flash, ReadsNothingStaleAfterAnErase) {
  ASSERT_EQ(memory.program(0, bytes(1)), Error::none);
  Bytes back{};
  ASSERT_EQ(read(0, back), Error::none);
  ASSERT_EQ(memory.erase(0), Error::none);
  ASSERT_EQ(read(0, back), Error::none);
  EXPECT_EQ(back[0], std::byte{0xFF}) << "the data cache still has the past";
  EXPECT_TRUE(chip.flash.registers.acr.has(1u << 10)) << "the cache stays on";
}

TEST_F(Flash, ReadsWhatItProgrammedAfterItHadReadItErased) {
  Bytes back{};
  ASSERT_EQ(read(0, back), Error::none);
  ASSERT_EQ(memory.program(0, bytes(1)), Error::none);
  ASSERT_EQ(read(0, back), Error::none);
  EXPECT_EQ(back, bytes(1));
}

TEST_F(Flash, DoesNotProgramTwice) {
  ASSERT_EQ(memory.program(0, bytes(1)), Error::none);
  EXPECT_EQ(memory.program(0, bytes(9)), Error::failed);
  EXPECT_EQ(memory.program(0, Bytes{}), Error::failed) << "zeros over data, which the device takes";
  EXPECT_EQ(chip.flash.unit(kStart), 0x0807060504030201u);
}

TEST_F(Flash, ReadsAnyRange) {
  ASSERT_EQ(memory.program(8, bytes(0x20)), Error::none);
  std::array<std::byte, 11> out{};
  ASSERT_EQ(read(6, out), Error::none);
  EXPECT_EQ(out[0], std::byte{0xFF});
  EXPECT_EQ(out[1], std::byte{0xFF});
  EXPECT_EQ(out[2], std::byte{0x20});
  EXPECT_EQ(out[9], std::byte{0x27});
  EXPECT_EQ(out[10], std::byte{0xFF});
}

TEST_F(Flash, KeepsToItsPages) {
  Bytes out{};
  EXPECT_EQ(memory.program(20 * 2048, bytes(1)), Error::out_of_range);
  EXPECT_EQ(memory.program(20 * 2048 - 8, bytes(1)), Error::none);
  EXPECT_EQ(memory.program(4, bytes(1)), Error::out_of_range);
  EXPECT_EQ(memory.program(0, std::span(out).first(7)), Error::out_of_range);
  EXPECT_EQ(memory.erase(20), Error::out_of_range);
  EXPECT_EQ(read(20 * 2048 - 7, out), Error::out_of_range);
  EXPECT_EQ(read(0xFFFFFFFFu, out), Error::out_of_range);
  EXPECT_EQ(chip.flash.operations, 1u);
}

TEST_F(Flash, TornDoubleWordReadsAsDamagedAndTheOthersAreRead) {
  ASSERT_EQ(memory.program(0, bytes(1)), Error::none);
  chip.flash.tear_next = true;
  static_cast<void>(memory.program(8, bytes(2)));
  ASSERT_EQ(memory.program(16, bytes(3)), Error::none);
  chip.flash.reset();
  chip.flash.registers.acr.hold(0x704);

  std::array<std::byte, 24> out{};
  out.fill(std::byte{0xAA});
  EXPECT_EQ(read(0, out), Error::damaged);
  EXPECT_EQ(nmis, 1);
  EXPECT_EQ(out[0], std::byte{1});
  for (std::size_t i = 8; i < 16; ++i) {
    EXPECT_EQ(out[i], std::byte{0});
  }
  EXPECT_EQ(out[16], std::byte{3});

  Bytes good{};
  EXPECT_EQ(read(16, good), Error::none) << "the damage of one read is not that of the next";
  EXPECT_EQ(read(8, good), Error::damaged) << "and it does not heal";
  EXPECT_EQ(memory.program(8, bytes(2)), Error::failed) << "torn is not erased";
  ASSERT_EQ(memory.erase(0), Error::none);
  EXPECT_EQ(read(8, good), Error::none);
  EXPECT_EQ(memory.program(8, bytes(2)), Error::none);
}

TEST_F(Flash, AnNmiOfAnotherCauseIsNotTaken) {
  EXPECT_FALSE(operations.isr_ecc_error()) << "no ECCD";
  chip.flash.registers.eccr.raise(1u << 31);
  EXPECT_FALSE(operations.isr_ecc_error()) << "code or constants are damaged";
  EXPECT_FALSE(chip.flash.registers.eccr.has(1u << 31));
}

class FlashErrors : public Flash, public ::testing::WithParamInterface<std::uint32_t> {};

TEST_P(FlashErrors, OfAProgrammingAreToldAndForgotten) {
  chip.flash.next_error = GetParam();
  EXPECT_EQ(memory.program(0, bytes(1)), Error::failed);
  EXPECT_EQ(chip.flash.registers.sr.held(), 0u);
  EXPECT_EQ(memory.program(0, bytes(1)), Error::none);
}

TEST_P(FlashErrors, OfAnEraseAreToldAndForgotten) {
  ASSERT_EQ(memory.program(0, bytes(1)), Error::none);
  chip.flash.next_error = GetParam();
  EXPECT_EQ(memory.erase(0), Error::failed);
  EXPECT_EQ(chip.flash.unit(kStart), 0x0807060504030201u);
  EXPECT_EQ(memory.erase(0), Error::none);
}

TEST_P(FlashErrors, OfThePastDoNotForbidToProgram) {
  chip.flash.registers.sr.raise(GetParam());
  EXPECT_EQ(memory.program(0, bytes(1)), Error::none);
}

// RM0440 5.7.5: OPERR, PROGERR, WRPERR, PGAERR, SIZERR, PGSERR, MISERR, FASTERR.
INSTANTIATE_TEST_SUITE_P(Each, FlashErrors,
                         ::testing::Values(1u << 1, 1u << 3, 1u << 4, 1u << 5, 1u << 6, 1u << 7,
                                           1u << 8, 1u << 9));

TEST_F(Flash, GivesUpOnAnOperationThatNeverEnds) {
  chip.flash.stuck = true;
  // CR cannot be written then, which the model reports.
  testing::TestPartResultArray failures;
  {
    const testing::ScopedFakeTestPartResultReporter reporter(&failures);
    EXPECT_EQ(operations.erase(50), Error::failed);
  }
  EXPECT_GE(failures.size(), 1);
}

}  // namespace
}  // namespace stm32g4_models
