// Whatever the bytes: failure modes that can be ranked, or an InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/fmeca/assessment.hpp"
#include "tests/fuzz/io/require.hpp"

using namespace host_sim::fmeca;
using host_sim::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const RiskTable table = parse_table(text, "fuzz");
    const Assessment assessment = assess(table, {});
    require(assessment.modes.size() == table.modes.size() && !table.modes.empty());
    int last = 1000;
    for (const Assessed& one : assessment.modes) {
      require(one.risk >= 1 && one.risk <= 100 && one.level < table.levels.size());
      require(one.rpn.value_or(one.risk) <= last);
      last = one.rpn.value_or(one.risk);
      for (const auto& name : one.mode->warned_by) {
        require(!what_is(name).words.empty());
      }
    }
    require(!fmeca_json(assessment).empty() && !fmeca_table(assessment).empty());
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
