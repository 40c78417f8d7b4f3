#include "tests/diagnose/audit/records.hpp"

#include <cmath>
#include <numbers>

namespace host_sim::diagnose::testing {
namespace {

constexpr double kStroke_m = 0.02;
constexpr double kSwing = 0.4;

}  // namespace

effects::ForceRecord record_of(const std::string& name, const Run& run) {
  effects::ForceRecord record;
  record.session = name;
  record.pulls_alone = true;
  record.input_N_per_A = 21;
  const int samples = static_cast<int>(run.duration_s * kRate_Hz);
  for (int k = 0; k < samples; ++k) {
    const double time_s = (k + 0.3) / kRate_Hz;
    const double turn_rad = 2 * std::numbers::pi * run.frequency_Hz * time_s;
    const double load_rad = 1.37 * turn_rad + 0.4;
    const double position_m = kStroke_m * std::sin(turn_rad);
    const double velocity_m_s =
        kStroke_m * 2 * std::numbers::pi * run.frequency_Hz * std::cos(turn_rad);
    const double direction = velocity_m_s < 0 ? -1 : 1;
    const double input_N = run.mean_N * (1 + kSwing * std::sin(load_rad));
    const double rate_N_s =
        run.mean_N * kSwing * 1.37 * 2 * std::numbers::pi * run.frequency_Hz * std::cos(load_rad);
    const double kept = std::exp(-kMu * run.bend_angle_rad * direction);
    record.time_s.push_back(time_s);
    record.cycle.push_back(run.start_cycle + run.frequency_Hz * time_s);
    record.velocity_m_s.push_back(velocity_m_s);
    record.bend_angle_rad.push_back(run.bend_angle_rad);
    record.input_N.push_back(input_N);
    record.output_N.push_back(input_N * kept);
    record.output_rate_N_s.push_back(rate_N_s * kept);
    record.position_m.push_back(position_m);
    record.rotor_rad.push_back(720 * position_m);
    record.sheath_temperature_C.push_back(run.sheath_C + run.warming_C * time_s / run.duration_s);
    record.winding_temperature_C.push_back(run.winding_C + 2 * time_s / run.duration_s);
    record.used.push_back(true);
    record.measured.push_back(true);
  }
  record.reversal_m = reversals_m(record);
  return record;
}

std::vector<effects::ForceRecord> records_of(const std::vector<Run>& runs) {
  std::vector<effects::ForceRecord> records;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::string name = "s";
    name += std::to_string(i);
    records.push_back(record_of(name, runs[i]));
  }
  return records;
}

std::vector<Run> crossed() {
  std::vector<Run> runs;
  int order = 0;
  for (const double bend_angle_rad : {1.5, 3.0, 6.0}) {
    for (const double frequency_Hz : {0.25, 1.0}) {
      for (const double mean_N : {30.0, 90.0}) {
        for (const double sheath_C : {15.0, 30.0, 45.0}) {
          runs.push_back({.bend_angle_rad = bend_angle_rad,
                          .frequency_Hz = frequency_Hz,
                          .mean_N = mean_N,
                          .sheath_C = sheath_C,
                          .winding_C = 25.0 + 7 * ((order * 5) % 11),
                          .start_cycle = 100.0 * ((order * 23) % 36)});
          ++order;
        }
      }
    }
  }
  return runs;
}

std::vector<Run> one_pose() {
  std::vector<Run> runs;
  for (int i = 0; i < 9; ++i) {
    runs.push_back({.start_cycle = 400.0 * i});
  }
  return runs;
}

NoiseModel usual_noise(const std::vector<effects::ForceRecord>& records) {
  NoiseModel noise{.sample_sd_N = {}, .session_gain_sd = 0.01, .session_friction_sd = 0.006};
  for (const effects::ForceRecord& record : records) {
    std::vector<double>& sd_N = noise.sample_sd_N.emplace_back(record.input_N);
    for (double& value : sd_N) {
      value *= 0.01;
    }
  }
  return noise;
}

}  // namespace host_sim::diagnose::testing
