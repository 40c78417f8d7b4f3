// The firmware of the QEMU board on the host: the same composition over the same virtual devices.
//
// usage: firmware_host SERIAL NAME=VALUE...      the words of image/options.hpp; virtual time only

#include <iostream>
#include <span>

#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/virtual_run.hpp"
#include "tests/target/firmware/host_files.hpp"

namespace board = boards::qemu_mps2;

int main(int argc, char** argv) {
  const std::span words(argv, static_cast<std::size_t>(argc));
  board::OptionReader reader;
  for (const char* word : words.subspan(words.size() < 2 ? words.size() : 2)) {
    if (const char* accepted = reader.take(word)) {
      std::cerr << "firmware_host: " << word << ": accepted: " << accepted << "\n";
      return 2;
    }
  }
  if (reader.options().profile == nullptr || reader.options().real_time) {
    std::cerr << "usage: firmware_host SERIAL profile=FILE [NAME=VALUE]...\n";
    return 2;
  }
  firmware_test::SerialFile serial(words[1]);
  const board::Failure failure =
      board::run_in_virtual_time<firmware_test::HostFile>(reader.options(), serial);
  if (failure) {
    std::cerr << "firmware_host: " << (failure.about == nullptr ? "run" : failure.about) << ": "
              << failure.what << "\n";
    return 1;
  }
  return serial.close() ? 0 : 1;
}
