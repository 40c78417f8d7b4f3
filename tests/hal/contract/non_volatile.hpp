#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hal/non_volatile.hpp"

namespace hal_test {

/// What hal/non_volatile.hpp states. `Rig`:
///   auto& memory()                   blank, of at least two pages
///   bool tear(std::uint32_t address)  that unit, which is erased, is torn; false where that cannot
///                                     be
template <class Rig>
class NonVolatileContract : public testing::Test {
 protected:
  using Memory = std::remove_cvref_t<decltype(std::declval<Rig&>().memory())>;
  static constexpr std::uint32_t kUnit = Memory::kUnitBytes;
  static constexpr std::uint32_t kPage = Memory::kPageBytes;
  using Bytes = std::vector<std::byte>;

  static_assert(kPage % kUnit == 0 && kPage / kUnit >= 3);

  [[nodiscard]] std::uint32_t end() { return rig_.memory().pages() * kPage; }

  Bytes read(std::uint32_t address, std::size_t size) {
    Bytes bytes(size, std::byte{0x5a});
    EXPECT_EQ(rig_.memory().read(address, bytes), hal::Error::none) << address;
    return bytes;
  }
  static Bytes unit(std::uint8_t first) {
    Bytes bytes;
    for (std::uint32_t i = 0; i < kUnit; ++i) {
      bytes.push_back(static_cast<std::byte>(first + i));
    }
    return bytes;
  }
  static Bytes erased(std::size_t size = kUnit) { return Bytes(size, std::byte{0xff}); }
  hal::Error program(std::uint32_t address, const Bytes& bytes) {
    return rig_.memory().program(address, bytes);
  }

  Rig rig_;
};

TYPED_TEST_SUITE_P(NonVolatileContract);

TYPED_TEST_P(NonVolatileContract, ErasedBytesReadFf) {
  for (std::uint32_t page = 0; page < this->rig_.memory().pages(); ++page) {
    ASSERT_EQ(this->rig_.memory().erase(page), hal::Error::none);
  }
  EXPECT_EQ(this->read(0, this->end()), this->erased(this->end()));
}

TYPED_TEST_P(NonVolatileContract, AProgrammedUnitIsReadBackAndItsNeighboursAreUntouched) {
  const std::uint32_t last = this->end() - this->kUnit;
  for (const std::uint32_t address : {0u, 2 * this->kUnit, this->kPage, last}) {
    ASSERT_EQ(this->program(address, this->unit(static_cast<std::uint8_t>(address + 1))),
              hal::Error::none);
  }
  for (std::uint32_t address = 0; address < this->end(); address += this->kUnit) {
    const bool programmed =
        address == 0 || address == 2 * this->kUnit || address == this->kPage || address == last;
    ASSERT_EQ(this->read(address, this->kUnit),
              programmed ? this->unit(static_cast<std::uint8_t>(address + 1)) : this->erased())
        << address;
  }
}

TYPED_TEST_P(NonVolatileContract, AUnitIsProgrammedOnceAfterEachErase) {
  ASSERT_EQ(this->program(this->kUnit, this->unit(1)), hal::Error::none);
  EXPECT_EQ(this->program(this->kUnit, this->unit(2)), hal::Error::failed);
  EXPECT_EQ(this->read(this->kUnit, this->kUnit), this->unit(1));
  ASSERT_EQ(this->rig_.memory().erase(0), hal::Error::none);
  EXPECT_EQ(this->program(this->kUnit, this->unit(2)), hal::Error::none);
  EXPECT_EQ(this->read(this->kUnit, this->kUnit), this->unit(2));
}

TYPED_TEST_P(NonVolatileContract, AnEraseIsOfOnePage) {
  ASSERT_EQ(this->program(this->kPage - this->kUnit, this->unit(1)), hal::Error::none);
  ASSERT_EQ(this->program(this->kPage, this->unit(2)), hal::Error::none);
  ASSERT_EQ(this->program(2 * this->kPage - this->kUnit, this->unit(3)), hal::Error::none);
  ASSERT_EQ(this->rig_.memory().erase(1), hal::Error::none);
  EXPECT_EQ(this->read(this->kPage - this->kUnit, this->kUnit), this->unit(1));
  EXPECT_EQ(this->read(this->kPage, this->kPage), this->erased(this->kPage));
}

TYPED_TEST_P(NonVolatileContract, WhatLiesOutsideIsOutOfRange) {
  auto& memory = this->rig_.memory();
  const std::uint32_t end = this->end();
  EXPECT_EQ(memory.erase(memory.pages()), hal::Error::out_of_range);
  EXPECT_EQ(memory.erase(~0u), hal::Error::out_of_range);
  EXPECT_EQ(this->program(end, this->unit(1)), hal::Error::out_of_range);
  EXPECT_EQ(this->program(~0u - this->kUnit + 1, this->unit(1)), hal::Error::out_of_range);
  std::vector<std::byte> bytes(this->kUnit);
  EXPECT_EQ(memory.read(end, bytes), hal::Error::out_of_range);
  EXPECT_EQ(memory.read(end - this->kUnit + 1, bytes), hal::Error::out_of_range);
  EXPECT_EQ(memory.read(~0u - 3, bytes), hal::Error::out_of_range);
  EXPECT_EQ(memory.read(end - this->kUnit, bytes), hal::Error::none);
}

TYPED_TEST_P(NonVolatileContract, OnlyAWholeUnitAtItsPlaceIsProgrammed) {
  if (this->kUnit > 1) {
    EXPECT_EQ(this->program(1, this->unit(1)), hal::Error::out_of_range);
    EXPECT_EQ(this->program(0, std::vector<std::byte>(this->kUnit - 1)), hal::Error::out_of_range);
  }
  EXPECT_EQ(this->program(0, std::vector<std::byte>(this->kUnit + 1)), hal::Error::out_of_range);
  EXPECT_EQ(this->program(0, {}), hal::Error::out_of_range);
  EXPECT_EQ(this->read(0, this->end()), this->erased(this->end()));
}

TYPED_TEST_P(NonVolatileContract, AnyRangeIsReadAcrossUnitsAndPages) {
  ASSERT_EQ(this->program(this->kPage - this->kUnit, this->unit(1)), hal::Error::none);
  ASSERT_EQ(this->program(this->kPage, this->unit(100)), hal::Error::none);
  const auto both = this->read(this->kPage - 1, 2);
  EXPECT_EQ(both[0], static_cast<std::byte>(this->kUnit));
  EXPECT_EQ(both[1], std::byte{100});
  EXPECT_TRUE(this->read(0, 0).empty());
}

TYPED_TEST_P(NonVolatileContract, ATornUnitIsDamagedAndTheOthersAreReadAllTheSame) {
  ASSERT_EQ(this->program(0, this->unit(1)), hal::Error::none);
  ASSERT_EQ(this->program(2 * this->kUnit, this->unit(3)), hal::Error::none);
  if (!this->rig_.tear(this->kUnit)) {
    GTEST_SKIP() << "units of this back end do not tear";
  }
  std::vector<std::byte> bytes(3 * this->kUnit, std::byte{0x5a});
  EXPECT_EQ(this->rig_.memory().read(0, bytes), hal::Error::damaged);
  auto expected = this->unit(1);
  expected.resize(2 * this->kUnit);
  const auto third = this->unit(3);
  expected.insert(expected.end(), third.begin(), third.end());
  EXPECT_EQ(bytes, expected);
  EXPECT_EQ(this->read(2 * this->kUnit, this->kUnit), third);
  EXPECT_EQ(this->program(this->kUnit, this->unit(2)), hal::Error::failed);
  ASSERT_EQ(this->rig_.memory().erase(0), hal::Error::none);
  EXPECT_EQ(this->read(0, this->kPage), this->erased(this->kPage));
}

REGISTER_TYPED_TEST_SUITE_P(NonVolatileContract, ErasedBytesReadFf,
                            AProgrammedUnitIsReadBackAndItsNeighboursAreUntouched,
                            AUnitIsProgrammedOnceAfterEachErase, AnEraseIsOfOnePage,
                            WhatLiesOutsideIsOutOfRange, OnlyAWholeUnitAtItsPlaceIsProgrammed,
                            AnyRangeIsReadAcrossUnitsAndPages,
                            ATornUnitIsDamagedAndTheOthersAreReadAllTheSame);

}  // namespace hal_test
