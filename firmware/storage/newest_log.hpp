#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/storage/slot.hpp"
#include "hal/error.hpp"
#include "hal/non_volatile.hpp"
#include "lifemodel/support/inlining.hpp"

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
    if ((refused_ & bit(page)) == 0 && is_blank(*memory_, address(page), kBytes)) {
      as_found_ |= bit(page);
      return true;
    }
    refused_ &= ~bit(page);
    as_found_ &= ~bit(page);
    const bool blank = memory_->erase(kPages.first + page) == hal::Error::none &&
                       is_blank(*memory_, address(page), kBytes);
    if (!blank) {
      fail(page);
    }
    return blank;
  }
  /// Whether the page was blank when it was wanted so, and was not erased.
  [[nodiscard]] bool as_found(std::uint32_t page) const { return (as_found_ & bit(page)) != 0; }

  /// A program failed. An erase that lost its power may leave a page that looks blank and takes
  /// nothing: one that was not erased since is erased before it is used again, any other is left
  /// out.
  void refuse(std::uint32_t page) {
    if (as_found(page)) {
      refused_ |= bit(page);
    } else {
      fail(page);
    }
  }

  [[nodiscard]] bool failed(std::uint32_t page) const { return (failed_ & bit(page)) != 0; }
  void fail(std::uint32_t page) { failed_ |= bit(page); }
  /// All pages but these, a bit each, get another chance.
  void forgive_all_but(std::uint32_t pages) { failed_ &= pages; }

 private:
  Memory* memory_;
  // A bit for each page.
  std::uint32_t failed_ = 0;    ///< is left out
  std::uint32_t as_found_ = 0;  ///< looked blank, and was not erased
  std::uint32_t refused_ = 0;   ///< and took nothing: to be erased
};

/// Slots written one after another over pages taken in turn; of each key the newest counts.
///
/// Invariant, at every instant and so over every power cut: the newest committed slot of each key
/// can be read. A page is erased only while none of them lies on it alone: before anything new is
/// written to a page, what is newest on the page that comes next is copied over, and until all
/// copies are made the originals stay.
///
/// A page that fails to erase or program is left out until no other is left or until the next
/// start; what it holds still counts. Pages that an earlier firmware has filled with slots of the
/// Former of a format are read, and nothing is added to them: what is newest on them moves to
/// others in the new format. One append erases each page once at most, and at most one page for
/// each that fails and one more; after prepare() none where none fails. The start reads every
/// slot once, where there is a Former twice. Sequences are the caller's, each higher than the ones
/// before.
template <hal::NonVolatile Memory, SlotFormat Format, std::size_t kKeys, PageRange kPages>
class NewestLog {
  static constexpr std::uint32_t kStride = slot_stride<Memory>(Format::kBytes);
  static constexpr std::uint32_t kFormerStride = [] {
    if constexpr (SucceedingFormat<Format>) {
      return slot_stride<Memory>(Format::Former::kBytes);
    } else {
      return kStride;
    }
  }();
  using Ring = PageRing<Memory, kPages>;
  using Bytes = std::array<std::byte, Format::kBytes>;
  using View = std::span<const std::byte, Format::kBytes>;

 public:
  static constexpr std::uint32_t kSlots =  ///< a page
      static_cast<std::uint32_t>(Memory::kPageBytes / kStride);
  static_assert(kSlots > kKeys, "a fresh page takes the copies of all keys and what is new");

  explicit NewestLog(Memory& memory) : ring_(memory) {
    bool begun_in_vain = false;
    for (std::uint32_t page = 0; page < Ring::kCount; ++page) {
      begun_in_vain = scan(page) || begun_in_vain;
    }
    torn_ = torn_ || begun_in_vain;
  }

  /// The newest slot of a key; nothing if there is none or it cannot be read any more.
  [[nodiscard]] std::optional<Bytes> newest(std::size_t key) {
    return where_[key] ? read(*where_[key]) : std::nullopt;
  }
  /// The highest sequence that can be read; 0 if there is none.
  [[nodiscard]] std::uint32_t highest() const { return highest_; }
  /// Slots that could not be read at the start. None had more than one sequence to itself, so while
  /// any slot can be read, a sequence above highest() + spent() is new for certain.
  [[nodiscard]] std::uint32_t spent() const { return spent_; }
  /// Whether more of these were written to their end than the one that a power cut may leave, so
  /// that something that was committed was lost.
  [[nodiscard]] bool damaged() const { return finished_ > 1; }

  /// Whether what was written last is not whole: its power was cut.
  [[nodiscard]] bool torn() const { return torn_; }

  /// Writes a slot that Format::name() trusts. failed: no page takes it, and the newest is as it
  /// was.
  hal::Error append(View bytes) {
    const auto name = Format::name(bytes);
    if (!name || name->key >= kKeys) {
      return hal::Error::out_of_range;
    }
    std::uint32_t tried = 0;
    // A page may be tried as it was found, and erased.
    for (std::uint32_t attempt = 0; attempt <= 2 * Ring::kCount; ++attempt) {
      if (slot_ == kSlots && !open_any(tried)) {
        break;
      }
      if (evacuate_next(name->key) && write(bytes, *name)) {
        return hal::Error::none;
      }
    }
    ring_.forgive_all_but(0);
    prepared_ = false;
    return hal::Error::failed;
  }

  /// Erases the page that comes next, where that is left to do: at most one erase a call, nothing
  /// once it is done. failed: the page was left out; call again.
  hal::Error prepare() {
    if (prepared_) {
      return hal::Error::none;
    }
    const std::uint32_t page = ring_.next_good(page_);
    if (page == page_) {
      prepared_ = true;
      return hal::Error::none;
    }
    if (holds_newest(page)) {
      return hal::Error::none;
    }
    prepared_ = ring_.make_blank(page);
    return prepared_ ? hal::Error::none : hal::Error::failed;
  }

 private:
  struct SlotPosition {
    std::uint32_t page;
    std::uint32_t slot;
    std::uint32_t sequence;
  };

  /// Whether slots of a former format are on the page.
  [[nodiscard]] bool is_former(std::uint32_t page) const {
    return (former_ & Ring::bit(page)) != 0;
  }
  [[nodiscard]] std::uint32_t stride(std::uint32_t page) const {
    return is_former(page) ? kFormerStride : kStride;
  }
  [[nodiscard]] std::uint32_t slots(std::uint32_t page) const {
    return static_cast<std::uint32_t>(Memory::kPageBytes / stride(page));
  }
  [[nodiscard]] std::uint32_t address(std::uint32_t page, std::uint32_t slot) const {
    return Ring::address(page) + slot * stride(page);
  }

  std::optional<Bytes> read(const SlotPosition& position) {
    Bytes bytes;
    const std::uint32_t from = address(position.page, position.slot);
    if constexpr (SucceedingFormat<Format>) {
      if (is_former(position.page)) {
        const auto former = std::span(bytes).template first<Format::Former::kBytes>();
        if (ring_.memory().read(from, former) != hal::Error::none ||
            !Format::Former::name(former)) {
          return {};
        }
        Format::renew(bytes);
        return bytes;
      }
    }
    if (ring_.memory().read(from, bytes) != hal::Error::none) {
      return {};
    }
    return bytes;
  }
  std::optional<SlotName> name_at(std::uint32_t page, std::uint32_t slot) {
    const auto bytes = read({page, slot, 0});
    return bytes ? Format::name(*bytes) : std::nullopt;
  }

  /// Notes a page on which a slot of a former format is whole.
  LIFEMODEL_ONE_COPY void look_for_former(std::uint32_t page) {
    if constexpr (SucceedingFormat<Format>) {
      using Former = typename Format::Former;
      for (std::uint32_t at = 0; at + kFormerStride <= Memory::kPageBytes; at += kFormerStride) {
        std::array<std::byte, Former::kBytes> bytes;
        if (ring_.memory().read(Ring::address(page) + at, bytes) == hal::Error::none &&
            Former::name(bytes)) {
          former_ |= Ring::bit(page);
          return;
        }
      }
    }
  }

  /// True where something was begun on the page and nothing of it is whole.
  bool scan(std::uint32_t page) {
    look_for_former(page);
    std::uint32_t used = 0;
    bool newest_here = false;
    bool torn = false;
    bool whole = false;
    for (std::uint32_t slot = 0; slot < slots(page); ++slot) {
      if (is_blank(ring_.memory(), address(page, slot), stride(page))) {
        continue;
      }
      used = slot + 1;
      const auto name = name_at(page, slot);
      torn = !name;
      whole = whole || name;
      if (!name) {
        note_damaged(page, slot);
      } else if (take(*name, page, slot)) {
        newest_here = true;
      }
    }
    if (newest_here) {
      page_ = page;
      slot_ = is_former(page) ? kSlots : used;
      torn_ = torn;
    }
    return torn && !whole;
  }

  void note_damaged(std::uint32_t page, std::uint32_t slot) {
    constexpr std::uint32_t kUnit = Memory::kUnitBytes;
    ++spent_;
    if (!is_blank(ring_.memory(), address(page, slot) + stride(page) - kUnit, kUnit)) {
      ++finished_;
    }
  }

  /// Whether the page of the slot is the one in use, as far as can be known.
  bool take(SlotName name, std::uint32_t page, std::uint32_t slot) {
    if (name.key < kKeys) {
      auto& where = where_[name.key];
      if (!where || name.sequence > where->sequence) {
        where = SlotPosition{page, slot, name.sequence};
      }
    }
    // Of two pages that share a save or a copy, the one with room left is in use.
    if (name.sequence < highest_ || (name.sequence == highest_ && slot_ != kSlots)) {
      return false;
    }
    highest_ = name.sequence;
    return true;
  }

  [[nodiscard]] bool holds_newest(std::uint32_t page) const {
    for (const auto& where : where_) {
      if (where && where->page == page) {
        return true;
      }
    }
    return false;
  }

  /// Copies what is newest on the pages up to the next good one, but for `own`, which is about to
  /// be replaced. False where the page ran full.
  bool evacuate_next(std::uint32_t own) {
    const std::uint32_t next = ring_.next_good(page_);
    for (std::uint32_t page = Ring::after(page_); page != page_; page = Ring::after(page)) {
      for (std::uint32_t key = 0; key < kKeys; ++key) {
        const bool here = where_[key] && where_[key]->page == page;
        if (here && key != own && !copy(key)) {
          return false;
        }
      }
      if (page == next) {
        break;
      }
    }
    return slot_ != kSlots;
  }

  /// Copies the newest slot of a key to the page in use. True also where it cannot be read any
  /// more: its page is then left alone until a newer one is written.
  bool copy(std::uint32_t key) {
    const auto bytes = read(*where_[key]);
    const auto name = bytes ? Format::name(*bytes) : std::nullopt;
    if (!name) {
      return true;
    }
    return slot_ != kSlots && write(View(*bytes), *name);
  }

  bool write(View bytes, SlotName name) {
    const std::uint32_t slot = slot_++;
    if (write_slot(ring_.memory(), address(page_, slot), bytes) != hal::Error::none) {
      ring_.refuse(page_);
      slot_ = kSlots;
      return false;
    }
    torn_ = false;
    where_[name.key] = SlotPosition{page_, slot, name.sequence};
    highest_ = name.sequence > highest_ ? name.sequence : highest_;
    return true;
  }

  /// Pages that failed in earlier calls are tried again where no other is left.
  bool open_any(std::uint32_t& tried) {
    if (open_next(tried)) {
      return true;
    }
    ring_.forgive_all_but(tried);
    return open_next(tried);
  }

  /// Continues on a page that is erased, or can be without loss. False where there is none.
  bool open_next(std::uint32_t& tried) {
    std::uint32_t page = page_;
    for (std::uint32_t step = 0; step < Ring::kCount; ++step) {
      page = Ring::after(page);
      if (ring_.failed(page) || (tried & Ring::bit(page)) != 0 || !release(page)) {
        continue;
      }
      const bool blank = ring_.make_blank(page);
      tried |= ring_.as_found(page) ? 0 : Ring::bit(page);
      if (blank) {
        page_ = page;
        slot_ = 0;
        former_ &= ~Ring::bit(page);
        prepared_ = false;
        return true;
      }
    }
    return false;
  }

  /// Whether nothing would be lost with a page. Where the newest slot of a key lies on it, its copy
  /// on another page takes over.
  bool release(std::uint32_t page) {
    for (std::uint32_t key = 0; key < kKeys; ++key) {
      auto& where = where_[key];
      if (where && where->page == page) {
        const auto twin = find({key, where->sequence}, page);
        if (!twin) {
          return false;
        }
        where = twin;
      }
    }
    return true;
  }
  std::optional<SlotPosition> find(SlotName wanted, std::uint32_t except) {
    for (std::uint32_t page = 0; page < Ring::kCount; ++page) {
      for (std::uint32_t slot = 0; page != except && slot < slots(page); ++slot) {
        if (name_at(page, slot) == wanted) {
          return SlotPosition{page, slot, wanted.sequence};
        }
      }
    }
    return {};
  }

  Ring ring_;
  std::array<std::optional<SlotPosition>, kKeys> where_{};
  std::uint32_t former_ = 0;               ///< a bit for each page
  std::uint32_t page_ = Ring::kCount - 1;  ///< in use
  std::uint32_t slot_ = kSlots;            ///< next of it; all from it on are blank
  std::uint32_t highest_ = 0;
  std::uint32_t spent_ = 0;
  std::uint32_t finished_ = 0;
  bool prepared_ = false;
  bool torn_ = false;
};

}  // namespace storage
