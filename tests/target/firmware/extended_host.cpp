// The firmware with an extended model on the host, as firmware_host is without; and what it plays.
//
// usage: extended_host SERIAL NAME=VALUE...       plays as the board does, in virtual time
//        extended_host --write PROFILE BLOCK      writes a profile and the block of
//                                                 extended_paper_model()

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <span>
#include <string_view>

#include "firmware/boards/qemu_mps2/extended/swinging_drive.hpp"
#include "firmware/boards/qemu_mps2/image/virtual_run.hpp"
#include "tests/target/firmware/host_files.hpp"
#include "tests/target/model/paper_model.hpp"
#include "tests/target/signals.hpp"

namespace board = boards::qemu_mps2;

namespace {

constexpr std::uint32_t kSamples = 30'000;

bool write(const char* path, std::span<const std::byte> bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  return out.flush().good();
}

/// 1 to 4 A, a random walk of the one tendon and noise of the other.
bool write_profile(const char* path) {
  std::array<std::byte, 16 + 4 * board::kTendons * kSamples> bytes{};
  lifemodel::ByteWriter out(bytes);
  for (const std::uint32_t word : {board::ProfileHeader::kMagic, board::ProfileHeader::kVersion,
                                   std::uint32_t{board::kTendons}, 1'000u}) {
    out.u32(word);
  }
  target::Random random(30);
  std::int32_t walk = 2 << 24;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    walk += random.below(1 << 22) - (1 << 21);
    walk = std::clamp(walk, 1 << 24, 4 << 24);
    out.i32(walk);
    out.i32((1 << 24) + random.below(3 << 24));
  }
  return write(path, bytes);
}

int write_inputs(const char* profile, const char* block) {
  std::array<std::byte, lifemodel::kMostExtendedBytes> bytes{};
  return write_profile(profile) && write(block, encode(target::extended_paper_model(), bytes)) ? 0
                                                                                               : 1;
}

int play(std::span<char*> words) {
  board::OptionReader reader;
  for (const char* word : words.subspan(2)) {
    if (const char* accepted = reader.take(word)) {
      std::cerr << "extended_host: " << word << ": accepted: " << accepted << "\n";
      return 2;
    }
  }
  firmware_test::SerialFile serial(words[1]);
  const board::Failure failure =
      board::run_in_virtual_time<firmware_test::HostFile, board::SwingingDrive>(reader.options(),
                                                                                serial);
  if (failure) {
    std::cerr << "extended_host: " << failure.what << "\n";
  }
  return !failure && serial.close() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::span words(argv, static_cast<std::size_t>(argc));
  if (words.size() == 4 && std::string_view(words[1]) == "--write") {
    return write_inputs(words[2], words[3]);
  }
  return words.size() > 2 ? play(words) : 2;
}
