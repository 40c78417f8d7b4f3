// Whatever the bytes: sessions that stay in their folder, or an InputError.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/recording/recording_files.hpp"
#include "tests/fuzz/io/require.hpp"

namespace {

using host_sim::fuzz::require;
using host_sim::recording::SessionRow;

void require_within(const std::filesystem::path& file) {
  require(!file.empty() && !file.is_absolute());
  int depth = 0;
  for (const auto& part : file) {
    depth += part == ".." ? -1 : part == "." || part.empty() ? 0 : 1;
  }
  require(depth >= 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto rows = host_sim::recording::parse_sessions(hal::files::memory_source(text), "fuzz");
    require(!rows.empty());
    std::set<std::string> sessions;
    for (const SessionRow& row : rows) {
      require(!row.session.empty() && sessions.insert(row.session).second);
      require(!row.specimen.empty());
      require(row.start_cycle >= 0 && std::isfinite(row.start_cycle));
      require_within(row.file);
    }
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
