// Any bytes, and any words under a CRC that fits: either refused, or a record that encodes to the
// same bytes.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "firmware/storage/life_record.hpp"
#include "firmware/storage/log_entry.hpp"

namespace {

void check_record(std::span<const std::byte> bytes) {
  const auto record = storage::decode(bytes);
  if (record && bytes.size() == storage::kRecordBytes &&
      !std::ranges::equal(storage::encode(*record), bytes)) {
    std::abort();
  }
  if (record && record->epoch_damage > record->lifetime_damage) {
    std::abort();
  }
  if (!record && record.error() == storage::RecordError::none) {
    std::abort();
  }
}

void check_entry(std::span<const std::byte> bytes) {
  if (bytes.size() < storage::kEntryBytes) {
    return;
  }
  const auto part = bytes.first<storage::kEntryBytes>();
  const auto entry = storage::decode_entry(part);
  if (entry && !std::ranges::equal(storage::encode(*entry), part)) {
    std::abort();
  }
}

std::vector<std::byte> with_crc(std::span<const std::byte> bytes, std::size_t size) {
  std::vector<std::byte> framed(bytes.begin(), bytes.end());
  framed.resize(size);
  const auto body = std::span(framed).first(size - 4);
  lifemodel::ByteWriter(std::span(framed).last(4)).u32(lifemodel::crc32(body));
  return framed;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  check_record(bytes);
  check_entry(bytes);
  check_record(with_crc(bytes, storage::kRecordBytes));
  check_record(with_crc(bytes, storage::kFormerRecordBytes));
  check_entry(with_crc(bytes, storage::kEntryBytes));
  return 0;
}
