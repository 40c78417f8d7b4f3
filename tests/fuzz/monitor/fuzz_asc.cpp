// Whatever the bytes: frames that can be trusted, or an InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/bus/asc_reader.hpp"
#include "tests/fuzz/monitor/sound.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    host_sim::monitor::AscReader reader(hal::files::memory_source(text), "fuzz");
    while (const auto seen = reader.next()) {
      host_sim::fuzz::require_sound(*seen);
    }
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
