// Whatever the maps (the first line, between |) and the table (the rest): channels that are whole
// and finite, or an error of one line. Of odd sizes rows without a value are passed over.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/recording/import_columns.hpp"
#include "tests/fuzz/io/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace host_sim;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string_view first = text.substr(0, text.find('\n'));
  const std::string_view table = text.substr(first.size());
  try {
    recording::ColumnsOptions options;
    options.ignore_missing = size % 2 != 0;
    for (std::size_t at = 0; at <= first.size();) {
      const std::size_t end = std::min(first.find('|', at), first.size());
      options.maps.push_back(hal::files::column_map(first.substr(at, end - at)));
      at = end + 1;
    }
    if (!recording::conflict_of(options).empty()) {
      return 0;
    }
    recording::RecordedCampaign campaign;
    recording::import_columns(hal::files::memory_source(table), "fuzz", "session", options,
                              campaign);
    fuzz::require(campaign.recordings.size() == 1);
    for (const auto& channel : campaign.recordings.front().channels) {
      fuzz::require(channel.empty() || channel.size() == campaign.recordings.front().samples());
      for (const double value : channel) {
        fuzz::require(std::isfinite(value));
      }
    }
  } catch (const std::invalid_argument& error) {
    fuzz::require_one_line(error.what());
  } catch (const hal::files::InputError& error) {
    fuzz::require_one_line(error.what());
  }
  return 0;
}
