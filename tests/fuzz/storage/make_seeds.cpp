// make_storage_seeds <folder>: seeds for the fuzzers, made by the stores themselves.
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "firmware/storage/file_store.hpp"
#include "firmware/storage/flash_store.hpp"
#include "hal/fake/flash.hpp"
#include "tests/storage/lives.hpp"
#include "tests/storage/memory_files.hpp"

namespace {

using namespace storage_test;
using Flash = hal::fake::Flash<8, 640, 8>;
constexpr storage::FlashLayout kLayout{{0, 4}, {4, 2}, {6, 2}, lifemodel::kBlockBytes};
using FileStore = storage::FileStore<2, MemoryCalls>;

void write(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
}

template <class Store>
void live(Store& store, std::uint32_t steps) {
  for (std::uint32_t step = 0; step < steps; ++step) {
    (void)store.save(records_of<2>(step));
    (void)store.save_parameters(step % 2, block_of(step));
    (void)store.append(entry_of(step));
  }
}

void flash_image(const std::filesystem::path& path, std::uint32_t steps) {
  Flash flash;
  storage::FlashStore<Flash, 2, kLayout> store(flash);
  live(store, steps);
  std::vector<std::byte> seed{std::byte{0}};
  seed.insert(seed.end(), flash.content().begin(), flash.content().end());
  write(path, seed);
}

void files(const std::filesystem::path& path, std::uint32_t steps) {
  MemoryFiles memory("/store");
  {
    auto opened = FileStore::open("/store", MemoryCalls(memory));
    live(std::get<FileStore>(opened), steps);
  }
  std::vector<std::byte> seed(2);
  for (const char* name : {"life", "life.previous"}) {
    const auto& content = memory.content(name);
    seed[name == std::string("life") ? 0 : 1] = static_cast<std::byte>(content.size() / 12);
    seed.insert(seed.end(), content.begin(), content.end());
  }
  const auto& log = memory.content("authority.log");
  seed.insert(seed.end(), log.begin(), log.end());
  write(path, seed);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  write(folder / "fuzz_record" / "record", storage::encode(record_of(1, 200, 3, 20)));
  write(folder / "fuzz_record" / "entry", storage::encode(entry_of(7)));
  flash_image(folder / "fuzz_flash_image" / "first", 1);
  flash_image(folder / "fuzz_flash_image" / "round", 31);
  files(folder / "fuzz_file_store" / "first", 2);
  files(folder / "fuzz_file_store" / "more", 5);
}
