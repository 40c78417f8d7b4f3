// Whatever the bytes: frames that can be written and read again, or an InputError.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "hal/files/candump.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "tests/fuzz/io/require.hpp"

namespace {

using hal::files::LoggedFrame;
using host_sim::fuzz::require;

void require_sound(const LoggedFrame& frame) {
  require(!frame.interface.empty() && frame.interface.size() < 16);
  require(frame.id < 0x2000'0000);
  require(frame.extended || frame.kind == LoggedFrame::Kind::kError || frame.id < 0x800);
  require(frame.length <= (frame.kind == LoggedFrame::Kind::kFd ? 64 : 8));
  const auto past_end = frame.data.begin() + frame.length;
  require(std::all_of(past_end, frame.data.end(), [](std::byte b) { return b == std::byte{0}; }));
}

void require_same_again(const LoggedFrame& frame) {
  const auto classic = frame.classic();
  if (!classic) {
    return;
  }
  const std::string text = hal::files::candump_line(frame.time_us, frame.interface, *classic);
  LoggedFrame again = hal::files::parse_candump_line(
      {"again", 1, std::string_view(text).substr(0, text.size() - 1)});
  again.direction = frame.direction;
  require(again == frame);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    hal::files::CandumpReader reader(hal::files::memory_source(text), "fuzz");
    while (const auto frame = reader.next()) {
      require_sound(*frame);
      require_same_again(*frame);
    }
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
