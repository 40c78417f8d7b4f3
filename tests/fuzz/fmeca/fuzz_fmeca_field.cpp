// Whatever the bytes: counts that give rates, or an InputError.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/fmeca/assessment.hpp"
#include "tests/fuzz/io/require.hpp"

using namespace host_sim::fmeca;
using host_sim::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const RiskTable kPaper = paper_table();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const FieldCounts counts = parse_field(hal::files::memory_source(text), "fuzz", kPaper);
    require(!counts.empty());
    for (const auto& [id, count] : counts) {
      require(count.operating_h > 0 && std::isfinite(count.operating_h));
      require(count.limit_per_h() > 0 && !std::isnan(count.limit_per_h()));
    }
    for (const Assessed& one : assess(kPaper, counts).modes) {
      require(one.occurrence >= 1 && one.occurrence <= kPaper.largest.occurrence);
    }
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
