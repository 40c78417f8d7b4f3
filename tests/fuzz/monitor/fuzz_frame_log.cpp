// Whatever the bytes: frames whose line in a record gives the same frame again, or an InputError.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/bus/frame_log.hpp"
#include "tests/fuzz/monitor/sound.hpp"

namespace {

using host_sim::monitor::CandumpLogReader;
using host_sim::monitor::SeenFrame;

void require_same_again(const SeenFrame& seen) {
  const std::string line = host_sim::monitor::log_line(seen, "can0");
  CandumpLogReader reader(hal::files::memory_source(line), "again");
  const auto again = reader.next();
  host_sim::fuzz::require(again && again->time_ns == seen.time_ns && again->frame == seen.frame &&
                          again->remote_request == seen.remote_request &&
                          again->flexible_data_rate == seen.flexible_data_rate &&
                          again->fd_flags == seen.fd_flags && again->fd_data == seen.fd_data &&
                          again->error.has_value() == seen.error.has_value() && !reader.next());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    CandumpLogReader reader(hal::files::memory_source(text), "fuzz");
    while (const auto seen = reader.next()) {
      host_sim::fuzz::require_sound(*seen);
      require_same_again(*seen);
    }
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
