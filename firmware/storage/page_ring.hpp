#pragma once

#include <cstdint>

#include "firmware/storage/page_range.hpp"
#include "firmware/storage/slot.hpp"
#include "hal/error.hpp"
#include "hal/non_volatile.hpp"

namespace storage {

/// Pages of a memory that are taken in turn, numbered from 0, and which of them have failed.
template <hal::NonVolatile Memory, PageRange kPages>
class PageRing {
  static_assert(kPages.count >= 2 && kPages.count <= 32);

 public:
  static constexpr std::uint32_t kCount = kPages.count;

  explicit PageRing(Memory& memory) : memory_(&memory) {}

  [[nodiscard]] Memory& memory() const { return *memory_; }
  static constexpr std::uint32_t address(std::uint32_t page) {
    return (kPages.first + page) * static_cast<std::uint32_t>(Memory::kPageBytes);
  }
  static constexpr std::uint32_t bit(std::uint32_t page) { return 1u << page; }
  static constexpr std::uint32_t after(std::uint32_t page) {
    return page + 1 == kCount ? 0 : page + 1;
  }

  /// The page after this one that has not failed; the same if there is none.
  [[nodiscard]] std::uint32_t next_good(std::uint32_t page) const {
    for (std::uint32_t next = after(page); next != page; next = after(next)) {
      if (!failed(next)) {
        return next;
      }
    }
    return page;
  }

  /// Erases a page unless it is blank. An erase that seems to succeed and keeps bits is one that
  /// failed; the page is then left out.
  bool make_blank(std::uint32_t page) {
    constexpr auto kBytes = static_cast<std::uint32_t>(Memory::kPageBytes);
    if (is_blank(*memory_, address(page), kBytes)) {
      return true;
    }
    const bool blank = memory_->erase(kPages.first + page) == hal::Error::none &&
                       is_blank(*memory_, address(page), kBytes);
    if (!blank) {
      fail(page);
    }
    return blank;
  }

  [[nodiscard]] bool failed(std::uint32_t page) const { return (failed_ & bit(page)) != 0; }
  void fail(std::uint32_t page) { failed_ |= bit(page); }
  /// All pages but these, a bit each, get another chance.
  void forgive_all_but(std::uint32_t pages) { failed_ &= pages; }

 private:
  Memory* memory_;
  std::uint32_t failed_ = 0;  ///< a bit for each page that is left out
};

}  // namespace storage
