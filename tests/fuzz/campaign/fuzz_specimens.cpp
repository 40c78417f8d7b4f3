// Whatever the bytes: specimens that can be calculated with, or an InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "tests/fuzz/campaign/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const host_sim::CampaignFile kPaper = host_sim::fuzz::paper_campaign();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    host_sim::fuzz::check(host_sim::assemble(
        kPaper, host_sim::parse_specimens(hal::files::memory_source(text), "fuzz"), {}));
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
