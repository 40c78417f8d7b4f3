// Whatever the bytes: a recording with faults, and records in newtons as long as it is, or an
// InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/diagnose/force_records.hpp"
#include "host_sim/recording/recording_files.hpp"
#include "tests/fuzz/io/require.hpp"

namespace {

using host_sim::fuzz::require;
namespace recording = host_sim::recording;

host_sim::NominalModel nominal() {
  host_sim::NominalModel nominal;
  nominal.sheath = {.friction_coefficient = 0.128, .bend_angle_deg = 270};
  nominal.drive = {.torque_constant_Nm_per_A = 0.0325,
                   .gear_ratio = 9,
                   .gear_efficiency = 0.88,
                   .spool_radius_mm = 12.5,
                   .current_offset_A = 0.1};
  return nominal;
}

void require_channels(const recording::Recording& one) {
  for (const auto& values : one.channels) {
    require(values.empty() || values.size() == one.samples());
  }
  require(one.samples() >= recording::kFewestSamples);
  for (std::size_t i = 1; i < one.samples(); ++i) {
    require(one[hal::files::kTime][i] > one[hal::files::kTime][i - 1]);
  }
}

void require_faults(const recording::Recording& one, const std::vector<recording::Fault>& faults) {
  for (const recording::Fault& fault : faults) {
    require(fault.count > 0 && fault.first + fault.count <= one.samples());
    require(fault.words.starts_with("session 'fuzz': "));
  }
}

void require_records(const std::vector<host_sim::effects::ForceRecord>& records) {
  for (const host_sim::effects::ForceRecord& record : records) {
    const std::size_t samples = record.samples();
    require(record.used.size() == samples);
    require(record.measured.size() == samples);
    for (const auto* const values :
         {&record.input_N, &record.output_N, &record.output_rate_N_s, &record.velocity_m_s,
          &record.position_m, &record.reversal_m, &record.bend_angle_rad}) {
      require(values->size() == samples);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  recording::Recording one;
  one.session = "fuzz";
  try {
    one.channels = recording::parse_recording(hal::files::memory_source(text), "fuzz").channels;
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
    return 0;
  }
  require_channels(one);
  const auto faults = recording::faults_of({one});
  require_faults(one, faults);
  require_records(host_sim::diagnose::force_records({one}, faults, nominal(), true));
  return 0;
}
