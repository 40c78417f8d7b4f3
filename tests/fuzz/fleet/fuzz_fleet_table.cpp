// Whatever the bytes: tendons that can be planned for, or an InputError.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/fleet/break_risk.hpp"
#include "host_sim/fleet/fleet_table.hpp"
#include "tests/fuzz/io/require.hpp"

namespace {

using namespace host_sim;

void check(const fleet::Tendon& tendon) {
  fuzz::require(tendon.damage >= 0 && std::isfinite(tendon.damage));
  fuzz::require(tendon.damage_per_h >= 0 && std::isfinite(tendon.damage_per_h));
  fuzz::require(tendon.hours_per_day >= 0 && tendon.hours_per_day <= 24);
  const fleet::LawBelief law{
      .shape = 5.94, .log_shape_sd = 0.1, .log_life_sd = 0.1, .exponent_sd = 0.1};
  const fleet::BreakRisk risk(law, tendon);
  const double within = risk.within(90 * tendon.hours_per_day);
  fuzz::require(within >= 0 && within <= 1);
  fuzz::require(risk.within_at_fit(90 * tendon.hours_per_day) <= 1);
  fuzz::require(risk.hours_to(0.1) >= 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    std::set<std::string> names;
    for (const fleet::TendonRow& row :
         fleet::parse_fleet_table(hal::files::memory_source(text), "fuzz")) {
      fuzz::require(names.insert(row.tendon.name).second);
      check(row.tendon);
    }
  } catch (const hal::files::InputError& error) {
    fuzz::require_one_line(error.what());
  }
  return 0;
}
