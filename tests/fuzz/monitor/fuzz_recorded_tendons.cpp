// Whatever frames at whatever times: tendons that the table of a fleet takes, or an InputError.
// Input: see Frames.

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "hal/files/input_error.hpp"
#include "host_sim/fleet/fleet_table.hpp"
#include "host_sim/monitor/tendons/recorded_tendons.hpp"
#include "tests/fuzz/io/require.hpp"
#include "tests/fuzz/monitor/frames.hpp"

namespace {

using namespace host_sim;

void check(const monitor::RecordedTendon& recorded) noexcept {
  fleet::TendonRow row;
  row.tendon.name = recorded.name;
  row.tendon.damage = recorded.damage;
  row.tendon.damage_per_h = recorded.damage_per_h;
  row.tendon.rate_log_sd = recorded.rate_log_sd;
  row.age_h = recorded.age_h;
  const std::string table = fleet::fleet_table_text({row}, {});
  const auto rows = fleet::parse_fleet_table(hal::files::memory_source(table), "fuzz");
  fuzz::require(rows.size() == 1 && rows[0].tendon.name == recorded.name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Frames frames({data, size});
  try {
    std::set<std::string> names;
    for (const auto& recorded : monitor::recorded_tendons([&] { return frames.next(); }, "fuzz")) {
      fuzz::require(names.insert(recorded.name).second);
      check(recorded);
    }
  } catch (const hal::files::InputError& error) {
    fuzz::require_one_line(error.what());
  }
  return 0;
}
