#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/storage/flash_store.hpp"
#include "firmware/storage/slot.hpp"
#include "hal/fake/flash.hpp"

namespace storage_test {

/// The memory of a store that can be copied: lets a copy continue with another image.
template <class FlashT>
class Socket {
 public:
  static constexpr std::size_t kUnitBytes = FlashT::kUnitBytes;
  static constexpr std::size_t kPageBytes = FlashT::kPageBytes;

  explicit Socket(FlashT& flash) : flash_(&flash) {}
  void plug(FlashT& flash) { flash_ = &flash; }

  [[nodiscard]] std::uint32_t pages() const { return flash_->pages(); }
  hal::Error erase(std::uint32_t page) { return flash_->erase(page); }
  hal::Error program(std::uint32_t address, std::span<const std::byte> in) {
    return flash_->program(address, in);
  }
  hal::Error read(std::uint32_t address, std::span<std::byte> out) const {
    return flash_->read(address, out);
  }

 private:
  FlashT* flash_;
};

/// As on an STM32G431.
struct Large {
  using Flash = hal::fake::Flash<20, 2'048, 8>;
  static constexpr storage::FlashLayout kLayout{};
};

/// The same for blocks without an extension alone.
struct LargeNominal {
  using Flash = Large::Flash;
  static constexpr storage::FlashLayout kLayout{{0, 16}, {16, 2}, {18, 2}, lifemodel::kBlockBytes};
};

/// So small that every page turn comes soon: 10 records, 8 parameter blocks, 36 entries a page.
struct Small {
  using Flash = hal::fake::Flash<8, 880, 8>;
  static constexpr storage::FlashLayout kLayout{{0, 4}, {4, 2}, {6, 2}, lifemodel::kBlockBytes};
};

/// As little as there can be: two pages of records, so that the newest are always moved on.
struct Tiny {
  using Flash = hal::fake::Flash<6, 880, 8>;
  static constexpr storage::FlashLayout kLayout{{0, 2}, {2, 2}, {4, 2}, lifemodel::kBlockBytes};
};

template <class Geometry, std::size_t kTendons>
using StoreOn = storage::FlashStore<Socket<typename Geometry::Flash>, kTendons, Geometry::kLayout>;

}  // namespace storage_test
