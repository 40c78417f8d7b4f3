// Any content of the flash, with units that cannot be read: a start that ends, records whose CRC
// fits and no others, and a store that takes the next save.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "firmware/storage/flash_store.hpp"
#include "hal/fake/flash.hpp"
#include "tests/storage/lives.hpp"

namespace {

using Flash = hal::fake::Flash<8, 640, 8>;
constexpr std::size_t kTendons = 2;
constexpr storage::FlashLayout kLayout{{0, 4}, {4, 2}, {6, 2}, lifemodel::kBlockBytes};
using Store = storage::FlashStore<Flash, kTendons, kLayout>;

/// Whether the flash holds these bytes at the start of a slot of a page.
bool holds(const Flash& flash, std::span<const std::byte> bytes, storage::PageRange pages) {
  for (std::uint32_t page = pages.first; page < pages.end(); ++page) {
    const auto content = flash.content().subspan(page * Flash::kPageBytes, Flash::kPageBytes);
    for (std::size_t at = 0; at + bytes.size() <= content.size(); at += bytes.size()) {
      if (std::ranges::equal(content.subspan(at, bytes.size()), bytes)) {
        return true;
      }
    }
  }
  return false;
}

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

/// The life of each tendon one step on.
std::array<storage::LifeRecord, kTendons> next_of(const Store& store) {
  std::array<storage::LifeRecord, kTendons> records;
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    records[tendon] = store.load(tendon).value_or(storage::LifeRecord{});
    records[tendon].tendon = static_cast<std::uint8_t>(tendon);
  }
  return records;
}

}  // namespace

/// One byte says which units are spoilt, the rest is the image; the end of it stays erased.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  Flash flash;
  flash.load(std::as_bytes(std::span(data + 1, size - 1)));
  for (std::uint32_t at = data[0] * 8u; data[0] % 4 != 0 && at < Flash::kBytes; at += 997) {
    flash.spoil(at);
  }
  Store store(flash);
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    const auto record = store.load(tendon);
    require(!record || holds(flash, storage::encode(*record), kLayout.life) ||
            (record->history == storage::WireHistory{} &&
             holds(flash, storage_test::former_bytes(*record), kLayout.life)));
    require(!record || record->tendon == tendon);
    require(!record || record->sequence <= store.sequence());
    (void)store.load_parameters(tendon);
  }
  for (std::uint32_t i = 0; const auto entry = store.log(i); ++i) {
    require(holds(flash, storage::encode(*entry), kLayout.log));
  }
  const auto records = next_of(store);
  const auto before = store.sequence();
  const hal::Error error = store.save(records);
  const Store again(flash);
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    require(again.load(tendon) == store.load(tendon));
  }
  require(error == hal::Error::full || error == hal::Error::none);
  require(error == hal::Error::full || store.sequence() > before);
  return 0;
}
