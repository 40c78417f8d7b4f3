// Any bytes as the files of a store: refused with a reason, or opened with what can be trusted, and
// then the next save is there after a restart.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <variant>
#include <vector>

#include "firmware/storage/file_store.hpp"
#include "tests/storage/memory_files.hpp"

namespace {

using storage_test::MemoryCalls;
using storage_test::MemoryFiles;
using Store = storage::FileStore<2, MemoryCalls>;
using Bytes = std::span<const std::byte>;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

void put(MemoryFiles& files, const char* name, Bytes content) {
  MemoryCalls calls(files);
  const std::string path = std::string("/store/") + name;
  const int fd = calls.open(path.c_str(), O_WRONLY | O_CREAT);
  (void)calls.write(fd, content.data(), content.size(), 0);
  (void)calls.close(fd);
}

void open_and_save(MemoryFiles& files) {
  auto opened = Store::open("/store", MemoryCalls(files));
  if (const auto* error = std::get_if<storage::FileError>(&opened)) {
    require(!error->path.empty() && !error->what.empty());
    return;
  }
  std::array<storage::LifeRecord, 2> records;
  hal::Error error = hal::Error::none;
  {
    Store store = std::get<Store>(std::move(opened));
    for (std::size_t tendon = 0; tendon < 2; ++tendon) {
      records[tendon] = store.load(tendon).value_or(storage::LifeRecord{});
      records[tendon].tendon = static_cast<std::uint8_t>(tendon);
    }
    for (std::uint32_t i = 0; store.log(i); ++i) {
    }
    error = store.save(records);
    require(error == hal::Error::none || error == hal::Error::full);
    records[0].sequence = store.sequence();
  }
  if (error == hal::Error::none) {
    auto again = Store::open("/store", MemoryCalls(files));
    require(std::holds_alternative<Store>(again));
    require(std::get<Store>(again).sequence() == records[0].sequence);
    require(std::get<Store>(again).load(1)->epoch_damage == records[1].epoch_damage);
  }
}

/// A file of the right magic and with a CRC that fits, so that the fuzzer gets past them.
std::vector<std::byte> framed(Bytes bytes) {
  std::vector<std::byte> result(bytes.begin(), bytes.end());
  if (result.size() >= 8) {
    lifemodel::ByteWriter(result).u32(storage::file_image::kMagic);
    lifemodel::ByteWriter(std::span(result).last(4))
        .u32(lifemodel::crc32(std::span(result).first(result.size() - 4)));
  }
  return result;
}

}  // namespace

/// Two bytes say where to cut the rest into the newest file, the one before and the log.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) {
    return 0;
  }
  const auto rest = std::as_bytes(std::span(data + 2, size - 2));
  const std::size_t first = std::min<std::size_t>(data[0] * 12u, rest.size());
  const std::size_t second = std::min<std::size_t>(data[1] * 12u, rest.size() - first);
  for (const bool with_crc : {false, true}) {
    MemoryFiles files("/store");
    const auto newest = rest.first(first);
    put(files, "life", with_crc ? framed(newest) : std::vector(newest.begin(), newest.end()));
    put(files, "life.previous", rest.subspan(first, second));
    put(files, "authority.log", rest.subspan(first + second));
    open_and_save(files);
  }
  return 0;
}
