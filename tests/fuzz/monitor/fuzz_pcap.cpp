// Whatever the bytes: frames that can be trusted, or an InputError.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/bus/pcap_reader.hpp"
#include "tests/fuzz/monitor/sound.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  std::vector<std::uint8_t> bytes(data, data + size);
  try {
    host_sim::monitor::PcapReader reader(::fmemopen(bytes.data(), bytes.size(), "rb"), "fuzz");
    while (const auto seen = reader.next()) {
      host_sim::fuzz::require_sound(*seen);
    }
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
