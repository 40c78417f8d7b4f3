// Whatever the bytes: a campaign file whose uses can be calculated with, or an InputError.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "tests/fuzz/campaign/check.hpp"

using host_sim::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const host_sim::CampaignFile file = host_sim::parse_campaign_file(text, "fuzz");
    require(!file.name.empty());
    for (const host_sim::Campaign::Use& use : file.uses) {
      require(!use.name.empty());
      double shares = 0;
      for (const auto& part : use.parts) {
        host_sim::fuzz::check(part.load);
        require(part.share > 0);
        shares += part.share;
      }
      require(std::abs(shares - 1) < 1e-8);
    }
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
