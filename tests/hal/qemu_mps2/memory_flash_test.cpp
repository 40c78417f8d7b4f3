#include "hal/qemu_mps2/memory_flash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "hal/non_volatile.hpp"

namespace hal::qemu_mps2 {
namespace {

static_assert(NonVolatile<MemoryFlash<2>>);

struct Kept {
  std::vector<std::byte> content;
  bool broken = false;

  bool load(std::span<std::byte> out) const {
    if (content.size() != out.size()) {
      return false;
    }
    std::ranges::copy(content, out.begin());
    return true;
  }
  bool keep(std::uint32_t address, std::span<const std::byte> in) {
    if (broken) {
      return false;
    }
    content.resize(2 * 2048, std::byte{0xff});
    std::ranges::copy(in, content.begin() + address);
    return true;
  }
};

using Flash = MemoryFlash<2, Kept>;
using Unit = std::array<std::byte, 8>;

constexpr Unit kUnit{std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4},
                     std::byte{5}, std::byte{6}, std::byte{7}, std::byte{8}};

Unit unit_at(Flash& flash, std::uint32_t address) {
  Unit unit{};
  EXPECT_EQ(flash.read(address, unit), Error::none);
  return unit;
}

Unit erased() {
  Unit unit;
  unit.fill(std::byte{0xff});
  return unit;
}

TEST(MemoryFlash, StartsErased) {
  Kept kept;
  Flash flash(kept);
  EXPECT_EQ(flash.content().size(), 4096u);
  EXPECT_TRUE(std::ranges::all_of(flash.content(), [](auto b) { return b == std::byte{0xff}; }));
}

TEST(MemoryFlash, ProgramsAUnitOnceAfterEachErase) {
  Kept kept;
  Flash flash(kept);
  EXPECT_EQ(flash.program(2048, kUnit), Error::none);
  EXPECT_EQ(unit_at(flash, 2048), kUnit);
  EXPECT_EQ(unit_at(flash, 2040), erased());
  EXPECT_EQ(unit_at(flash, 2056), erased());
  EXPECT_EQ(flash.program(2048, kUnit), Error::failed);
  EXPECT_EQ(flash.erase(0), Error::none);
  EXPECT_EQ(unit_at(flash, 2048), kUnit);
  EXPECT_EQ(flash.erase(1), Error::none);
  EXPECT_EQ(unit_at(flash, 2048), erased());
  EXPECT_EQ(flash.program(2048, kUnit), Error::none);
}

TEST(MemoryFlash, RefusesWhatItDoesNotHave) {
  Kept kept;
  Flash flash(kept);
  std::array<std::byte, 16> bytes{};
  EXPECT_EQ(flash.erase(2), Error::out_of_range);
  EXPECT_EQ(flash.program(4, kUnit), Error::out_of_range);
  EXPECT_EQ(flash.program(4096, kUnit), Error::out_of_range);
  EXPECT_EQ(flash.program(0xffff'fff8, kUnit), Error::out_of_range);
  EXPECT_EQ(flash.program(0, bytes), Error::out_of_range);
  EXPECT_EQ(flash.program(0, std::span(bytes).first(7)), Error::out_of_range);
  EXPECT_EQ(flash.read(4081, bytes), Error::out_of_range);
  EXPECT_EQ(flash.read(0xffff'ffff, bytes), Error::out_of_range);
  EXPECT_EQ(flash.read(4080, bytes), Error::none);
  EXPECT_EQ(flash.program(4088, kUnit), Error::none);
}

TEST(MemoryFlash, KeepsItsContent) {
  Kept kept;
  {
    Flash flash(kept);
    ASSERT_EQ(flash.program(8, kUnit), Error::none);
    ASSERT_EQ(flash.program(2048, kUnit), Error::none);
    ASSERT_EQ(flash.erase(1), Error::none);
  }
  Flash flash(kept);
  EXPECT_EQ(unit_at(flash, 8), kUnit);
  EXPECT_EQ(unit_at(flash, 2048), erased());
}

TEST(MemoryFlash, StartsErasedWhereWhatWasKeptIsNotWhole) {
  Kept kept;
  kept.content.assign(100, std::byte{0});
  Flash flash(kept);
  EXPECT_EQ(unit_at(flash, 0), erased());
}

TEST(MemoryFlash, SaysWhenItsContentIsNotKept) {
  Kept kept;
  kept.broken = true;
  Flash flash(kept);
  EXPECT_EQ(flash.program(0, kUnit), Error::failed);
  EXPECT_EQ(flash.erase(0), Error::failed);
}

}  // namespace
}  // namespace hal::qemu_mps2
