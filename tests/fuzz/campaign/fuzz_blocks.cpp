// Whatever the bytes of blocks.csv, for a campaign of three specimens: each with its blocks, or an
// InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "tests/fuzz/campaign/check.hpp"

namespace {

std::vector<host_sim::SpecimenRow> specimens() {
  return host_sim::parse_specimens(
      hal::files::memory_source("specimen,lot,cycles,status,input_tension_mean_N,"
                                "input_tension_amplitude_N\n"
                                "a,1,10,failed,,\nb,1,3,suspended,,\nc,1,5,failed,25,25\n"),
      "specimens");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const host_sim::CampaignFile kPaper = host_sim::fuzz::paper_campaign();
  static const std::vector<host_sim::SpecimenRow> kSpecimens = specimens();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    host_sim::fuzz::check(host_sim::assemble(
        kPaper, kSpecimens, host_sim::parse_blocks(hal::files::memory_source(text), "fuzz")));
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
