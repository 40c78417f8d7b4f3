#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "hal/fake/flash.hpp"
#include "hal/non_volatile.hpp"

namespace storage_test {
namespace {

using hal::Error;
using hal::fake::BadPage;
using hal::fake::FlashFault;
using TwoPages = hal::fake::Flash<2, 32, 8>;
using Unit = std::array<std::byte, 8>;
using FaultKind = FlashFault::Kind;
static_assert(hal::NonVolatile<TwoPages>);

constexpr Unit all(unsigned value) {
  Unit unit{};
  unit.fill(static_cast<std::byte>(value));
  return unit;
}
const Unit kErased = all(0xff);
const Unit kZeros = all(0);
const Unit kData = all(0x5a);

Unit read(const TwoPages& flash, std::uint32_t address, Error expected = Error::none) {
  Unit unit{};
  EXPECT_EQ(flash.read(address, unit), expected);
  return unit;
}

TEST(FakeFlash, ProgramsErasedUnitsOnce) {
  TwoPages flash;
  EXPECT_EQ(read(flash, 8), kErased);
  EXPECT_EQ(flash.program(8, kData), Error::none);
  EXPECT_EQ(flash.program(8, kData), Error::failed);
  EXPECT_EQ(flash.program(8, kZeros), Error::failed);
  EXPECT_EQ(flash.overwrites(), 2u);
  EXPECT_EQ(read(flash, 8), kData);
  EXPECT_EQ(read(flash, 0), kErased);
  EXPECT_EQ(flash.erase(0), Error::none);
  EXPECT_EQ(read(flash, 8), kErased);
  EXPECT_EQ(flash.program(8, kData), Error::none);
  EXPECT_EQ(flash.erases(0), 1u);
  EXPECT_EQ(flash.erases(1), 0u);
  EXPECT_EQ(flash.operations(), 5u);
}

TEST(FakeFlash, RefusesWhatItDoesNotHave) {
  TwoPages flash;
  EXPECT_EQ(flash.program(4, kData), Error::out_of_range);
  EXPECT_EQ(flash.program(64, kData), Error::out_of_range);
  EXPECT_EQ(flash.program(0, std::span(kData).first(4)), Error::out_of_range);
  EXPECT_EQ(flash.erase(2), Error::out_of_range);
  Unit unit{};
  EXPECT_EQ(flash.read(60, unit), Error::out_of_range);
}

TEST(FakeFlash, ACutProgramIsOldTornOrNew) {
  const auto cut = [](FaultKind kind) {
    TwoPages flash;
    flash.fault(1, {kind, 7});
    EXPECT_EQ(flash.program(0, kData), Error::none);
    EXPECT_EQ(flash.program(8, kZeros), Error::failed);
    EXPECT_FALSE(flash.powered());
    EXPECT_EQ(flash.program(16, kData), Error::failed);
    EXPECT_EQ(flash.erase(0), Error::failed);
    (void)read(flash, 0, Error::failed);
    flash.power_on();
    EXPECT_EQ(read(flash, 0), kData);
    EXPECT_EQ(read(flash, 16), kErased);
    return flash;
  };
  EXPECT_EQ(read(cut(FaultKind::cut_before), 8), kErased);
  EXPECT_EQ(read(cut(FaultKind::cut_after), 8), kZeros);
  EXPECT_EQ(read(cut(FaultKind::cut_torn), 8, Error::damaged), kZeros);
  const Unit half = read(cut(FaultKind::cut_half), 8);
  EXPECT_NE(half, kErased);
  EXPECT_NE(half, kZeros);
}

TEST(FakeFlash, ATornUnitHidesItsPartOfAReadAlone) {
  TwoPages flash;
  for (std::uint32_t address = 0; address < 24; address += 8) {
    EXPECT_EQ(flash.program(address, kData), Error::none);
  }
  flash.spoil(8);
  std::array<std::byte, 16> out{};
  EXPECT_EQ(flash.read(4, out), Error::damaged);
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(out[i], i < 4 || i >= 12 ? std::byte{0x5a} : std::byte{0}) << i;
  }
}

TEST(FakeFlash, ACutEraseLeavesAMixture) {
  bool old = false;
  bool erased = false;
  bool torn = false;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    TwoPages flash;
    for (std::uint32_t address = 0; address < 32; address += 8) {
      EXPECT_EQ(flash.program(address, kData), Error::none);
    }
    flash.fault(flash.operations(), {FaultKind::cut_torn, seed});
    EXPECT_EQ(flash.erase(0), Error::failed);
    flash.power_on();
    for (std::uint32_t address = 0; address < 32; address += 8) {
      Unit unit{};
      torn = flash.read(address, unit) == Error::damaged || torn;
      old = old || unit == kData;
      erased = erased || unit == kErased;
    }
  }
  EXPECT_TRUE(old && erased && torn);
}

TEST(FakeFlash, RefusedAndLostOperationsChangeNothing) {
  TwoPages flash;
  flash.fault(0, {FaultKind::refuse});
  EXPECT_EQ(flash.program(0, kData), Error::failed);
  EXPECT_EQ(read(flash, 0), kErased);
  flash.fault(1, {FaultKind::lose});
  EXPECT_EQ(flash.program(0, kData), Error::none);
  EXPECT_EQ(read(flash, 0), kErased);
  EXPECT_EQ(flash.program(0, kData), Error::none);
  flash.fault(3, {FaultKind::lose});
  EXPECT_EQ(flash.erase(0), Error::none);
  EXPECT_EQ(read(flash, 0), kData);
  flash.fault(4, {FaultKind::refuse});
  EXPECT_EQ(flash.erase(0), Error::failed);
  EXPECT_EQ(read(flash, 0), kData);
}

TEST(FakeFlash, BadPages) {
  TwoPages flash;
  EXPECT_EQ(flash.program(0, kData), Error::none);
  EXPECT_EQ(flash.program(8, kData), Error::none);
  flash.make_bad(0, BadPage::erase_fails);
  EXPECT_EQ(flash.erase(0), Error::failed);
  EXPECT_EQ(read(flash, 8), kData);
  flash.make_bad(0, BadPage::keeps_bits);
  EXPECT_EQ(flash.erase(0), Error::none);
  EXPECT_EQ(read(flash, 0), kData);
  EXPECT_EQ(read(flash, 8), kErased);
  flash.make_bad(0, BadPage::program_fails);
  EXPECT_EQ(flash.program(8, kData), Error::failed);
  EXPECT_EQ(read(flash, 8), kErased);
}

TEST(FakeFlash, BitRot) {
  TwoPages flash;
  EXPECT_EQ(flash.program(0, kData), Error::none);
  flash.flip(3, 1);
  EXPECT_EQ(read(flash, 0)[3], std::byte{0x58});
}

TEST(FakeFlash, TakesAnImage) {
  TwoPages flash;
  std::array<std::byte, TwoPages::kBytes> image{};
  image.fill(std::byte{0xff});
  std::ranges::copy(kData, image.begin() + 8);
  flash.load(image);
  EXPECT_TRUE(std::ranges::equal(flash.content(), image));
  EXPECT_EQ(flash.program(8, kData), Error::failed);
  EXPECT_EQ(flash.program(0, kData), Error::none);
}

}  // namespace
}  // namespace storage_test
