#include "tests/diagnose/audit/sessions.hpp"

#include <cmath>
#include <numbers>

namespace host_sim::diagnose::testing {
namespace {

constexpr double kStroke_m = 0.02;
constexpr double kSwing = 0.4;

/// Travel since the last turn of sin(turns), which are at odd quarters.
double travel_m(double position_m, double velocity_m_s, double turns_rad) {
  if (turns_rad < std::numbers::pi / 2) {
    return position_m;
  }
  return velocity_m_s > 0 ? position_m + kStroke_m : kStroke_m - position_m;
}

}  // namespace

Session session_of(const std::string& name, const Run& run) {
  Session session{.name = name, .covariates = {}};
  recording::Covariates& c = session.covariates;
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
    c.time_s.push_back(time_s);
    c.cycle.push_back(run.start_cycle + run.frequency_Hz * time_s);
    c.direction.push_back(direction);
    c.velocity_m_s.push_back(velocity_m_s);
    c.bend_angle_rad.push_back(run.bend_angle_rad);
    c.current_A.push_back(input_N / 21);
    c.current_tension_N.push_back(input_N);
    c.output_tension_N.push_back(input_N * std::exp(-kMu * run.bend_angle_rad * direction));
    c.travel_m.push_back(travel_m(position_m, velocity_m_s, turn_rad));
    c.position_m.push_back(position_m);
    c.motor_angle_rad.push_back(720 * position_m);
    c.log_tension_rate_1_s.push_back(rate_N_s / input_N);
    c.log_output_rate_1_s.push_back(rate_N_s / input_N);
    c.sheath_temperature_C.push_back(run.sheath_C + run.warming_C * time_s / run.duration_s);
    c.winding_temperature_C.push_back(run.winding_C + 2 * time_s / run.duration_s);
  }
  return session;
}

std::vector<Session> sessions_of(const std::vector<Run>& runs) {
  std::vector<Session> sessions;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::string name = "s";
    name += std::to_string(i);
    sessions.push_back(session_of(name, runs[i]));
  }
  return sessions;
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

effects::Baseline baseline() {
  return {.friction_coefficient = kMu,
          .sheath_reference_C = 20,
          .winding_reference_C = 25,
          .poses_rad = {}};
}

}  // namespace host_sim::diagnose::testing
