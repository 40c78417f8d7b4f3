#include "tests/virtual_g431/board/flash.hpp"

#include <algorithm>
#include <cstring>

namespace virtual_g431 {
namespace {

// FLASH_ACR
constexpr std::uint32_t kDataCache = bit(10), kInstructionCacheReset = bit(11),
                        kDataCacheReset = bit(12);
// FLASH_SR
constexpr std::uint32_t kProgramError = bit(3), kAlignmentError = bit(5), kSizeError = bit(6),
                        kSequenceError = bit(7);
constexpr std::uint32_t kErrors = 0xC3FA, kBusy = bit(16);
// FLASH_CR
constexpr std::uint32_t kProgram = bit(0), kPageErase = bit(1), kStart = bit(16), kLock = bit(31);

}  // namespace

void FlashContents::flash(std::uint32_t offset, std::span<const std::uint8_t> data) {
  std::copy(data.begin(), data.end(), bytes.begin() + offset);
  for (std::size_t i = offset / 8; i <= (offset + data.size() - 1) / 8; ++i) {
    damaged.reset(i);
  }
}

void Flash::reset() {
  acr_ = 0x00040600;
  sr_ = eccr_ = 0;
  cr_ = 0xC0000000;
  keys_ = 0;
  locked_out_ = changed_ = false;
  first_half_.reset();
  // A reset, other than a loss of power, lets the operation end (RM0440 5.3.6 warns of it; the
  // device finishes what its high voltage has begun).
}

std::uint32_t Flash::word(std::uint32_t offset) const {
  std::uint32_t value = 0;
  std::memcpy(&value, &contents_.bytes[offset], 4);
  return value;
}
void Flash::put(std::uint32_t offset, std::uint32_t value) {
  std::memcpy(&contents_.bytes[offset], &value, 4);
}

std::uint32_t Flash::read(std::uint32_t offset) {
  switch (offset) {
    case 0x00:
      return acr_;
    case 0x10:
      return sr_ | (busy() ? kBusy : 0);
    case 0x14:
      return cr_;
    case 0x18:
      return eccr_;
    default:
      rules_.broken("FLASH: read of " + hex(offset));
      return 0;
  }
}

void Flash::write_acr(std::uint32_t value) {
  rules_.require((value & kDataCacheReset) == 0 || (acr_ & kDataCache) == 0,
                 "FLASH: data cache reset while it is on");
  rules_.require((value & kInstructionCacheReset) == 0, "FLASH: instruction cache reset");
  if ((value & kDataCacheReset) != 0) {
    changed_ = false;
  }
  rules_.require(!changed_ || (value & kDataCache) == 0,
                 "FLASH: data cache on with what was there before a write");
  acr_ = value;
}

void Flash::write(std::uint32_t offset, std::uint32_t value) {
  switch (offset) {
    case 0x00:
      return write_acr(value);
    case 0x08: {
      rules_.require((cr_ & kLock) != 0, "FLASH: a key while it is not locked");
      rules_.require(!locked_out_, "FLASH: a key after a wrong one");
      constexpr std::array<std::uint32_t, 2> kKeys{0x45670123, 0xCDEF89AB};
      if (locked_out_ || (cr_ & kLock) == 0 || value != kKeys[keys_]) {
        rules_.broken("FLASH: wrong key");
        locked_out_ = true;
        return;
      }
      if (++keys_ == 2) {
        keys_ = 0;
        cr_ &= ~kLock;
      }
      return;
    }
    case 0x10:
      sr_ &= ~(value & (kErrors | 1u));
      return;
    case 0x14:
      return write_cr(value);
    case 0x18:
      eccr_ &= ~(value & 0xF0000000u);
      return;
    default:
      rules_.broken("FLASH: write of " + hex(offset));
  }
}

void Flash::write_cr(std::uint32_t value) {
  if ((cr_ & kLock) != 0) {
    rules_.require((value & ~kLock) == 0, "FLASH: CR written while it is locked");
    return;
  }
  rules_.require(!busy(), "FLASH: CR written while it is busy");
  rules_.require((value & ~(kProgram | kPageErase | 0x1F8u | kStart | kLock)) == 0,
                 "FLASH: CR with " + hex(value));
  if ((value & kStart) != 0) {
    rules_.require((cr_ & kPageErase) != 0 && (cr_ & 0x1F8u) == (value & 0x1F8u),
                   "FLASH: erase started in the write that chooses it (RM0440 5.3.6)");
    rules_.require((sr_ & kErrors) == 0, "FLASH: erase with errors in SR");
    const std::uint32_t page = field(value, 8, 3);
    rules_.require(page * kPageBytes >= writable_from,
                   "FLASH: erases page " + std::to_string(page));
    begin({true, page * kPageBytes}, erase_time);
  }
  cr_ = (value & ~kStart) | (cr_ & bit(30));
}

void Flash::begin(Operation operation, Ticks span) {
  rules_.require((acr_ & kDataCache) == 0, "FLASH: written with the data cache on");
  operation_ = operation;
  on_begin(operation);
  end_ = agenda_.in(span, [this] { finish(); });
}

void Flash::finish() {
  const Operation operation = *operation_;
  operation_.reset();
  changed_ = true;
  if (operation.erases) {
    std::fill_n(contents_.bytes.begin() + operation.offset, kPageBytes, std::uint8_t{0xFF});
    for (std::uint32_t i = 0; i < kPageBytes / 8; ++i) {
      contents_.damaged.reset(operation.offset / 8 + i);
    }
    return;
  }
  put(operation.offset, low_);
  put(operation.offset + 4, high_);
}

std::uint32_t Flash::load(std::uint32_t offset, unsigned size) {
  if (contents_.damaged.test(offset / 8)) {
    meet_damage(offset);
  }
  std::uint32_t value = 0;
  std::memcpy(&value, &contents_.bytes[offset], size);
  return value;
}

/// RM0440 5.3.7.
void Flash::store(std::uint32_t offset, std::uint32_t value, unsigned size) {
  const auto refuse = [this](std::uint32_t error, const char* what) {
    sr_ |= error;
    rules_.broken(std::string("FLASH: ") + what);
  };
  if ((cr_ & kLock) != 0 || (cr_ & kProgram) == 0 || busy() || (sr_ & kErrors) != 0) {
    return refuse(kSequenceError, "written without PG, locked, busy or with errors in SR");
  }
  if (size != 4) {
    return refuse(kSizeError, "written in less than words");
  }
  if (offset < writable_from) {
    return refuse(kProgramError, "written where the firmware has no business");
  }
  if (offset % 8 == 0) {
    if (first_half_) {
      return refuse(kAlignmentError, "a low word after a low word");
    }
    first_half_ = offset;
    low_ = value;
    return;
  }
  if (!first_half_ || *first_half_ + 4 != offset) {
    first_half_.reset();
    return refuse(kAlignmentError, "a high word without its low word");
  }
  const std::uint32_t unit = *first_half_;
  first_half_.reset();
  high_ = value;
  const bool erased =
      (word(unit) & word(unit + 4)) == 0xFFFFFFFFu && !contents_.damaged.test(unit / 8);
  if (!erased && (low_ | high_) != 0) {
    return refuse(kProgramError, "a double word that was not erased");
  }
  begin({false, unit}, program_time);
}

void Flash::tear(double share, std::mt19937& random) {
  if (operation_) {
    agenda_.cancel(end_);
    tear_copy(contents_, share, random);
    operation_.reset();
  }
}

void Flash::tear_copy(FlashContents& copy, double share, std::mt19937& random) const {
  if (!operation_ || share == 0) {
    return;
  }
  std::bernoulli_distribution done(share);
  if (operation_->erases) {
    std::bernoulli_distribution contradicts(0.7);
    for (std::uint32_t i = 0; i < kPageBytes; ++i) {
      for (unsigned place = 0; place < 8; ++place) {
        if (done(random)) {
          copy.bytes[operation_->offset + i] |= static_cast<std::uint8_t>(1u << place);
        }
      }
    }
    for (std::uint32_t i = 0; i < kPageBytes / 8; ++i) {
      copy.damaged.set(operation_->offset / 8 + i, contradicts(random));
    }
    return;
  }
  const std::array<std::uint32_t, 2> wanted{low_, high_};
  bool whole = true;
  for (std::uint32_t half = 0; half < 2; ++half) {
    for (unsigned place = 0; place < 32; ++place) {
      const bool programs = (wanted[half] >> place & 1) == 0;
      const bool through = programs && done(random);
      whole = whole && programs == through;
      std::uint8_t& byte = copy.bytes[operation_->offset + 4 * half + place / 8];
      byte = static_cast<std::uint8_t>(byte & ~(through ? 1u << (place % 8) : 0u));
    }
  }
  // Its code is torn too: it fits what is there only where all was done.
  copy.damaged.set(operation_->offset / 8, !whole);
}

}  // namespace virtual_g431
