#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/effects/tension/force_model.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/reference/constants.hpp"

namespace host_sim::diagnose {

inline constexpr reference::Constants kWire{177.4, 0.2, 1.53e5, 1.38, 5.94};

/// A sheath of half a turn, whose friction coefficient is 0.1.
inline NominalModel nominal() {
  NominalModel nominal;
  nominal.sheath = {.friction_coefficient = 0.1, .bend_angle_deg = 180};
  return nominal;
}

/// A joint that is driven both ways, by its own equations.
struct Joint {
  double friction = 0.02;    ///< of the load, as much at 10 N
  double load_exponent = 0;  ///< by which that falls
  double giving = 0;         ///< of the friction, more of it at twice the load of 28 N
  double load_N = 40;        ///< amplitude of what turns over
  double still_N = 0;        ///< load that stays
  double offset_N = 0;       ///< of the force that drives it
  double gain = 1;
  double turn_over_m_s = 1e-3;
  double preload_N = 0;
  double viscous_N_s_m = 0;
  double one_way = 0;         ///< of the friction, more of it one way and less the other
  double cogging_N = 0;       ///< not in the catalogue of the forward model
  double noise_N = 0.5;       ///< of either end
  double relative_noise = 0;  ///< of the input, beside that
  double gain_scatter = 0.01;
  bool velocity_reversed = false;
  double spring_N = 0;       ///< at the end of the stroke, whichever way it goes
  double shaped_N = 0;       ///< at the end of the stroke, with the motion and, back, against it
  bool shape_turns = false;  ///< from session to session
  bool rotor_known = true;
  double drift_N = 0;   ///< of the input force, from as much below to as much above in 5 s
  double moved_kg = 0;  ///< by the input force
  double jitter_s = 0;  ///< standard deviation of when the friction is read
  double late_s = 0;    ///< by which friction follows, by two filters of a half of it each
  int samples = 500;    ///< of 5 s
};

inline std::vector<effects::ForceRecord> measured(const Joint& joint, unsigned seed,
                                                  int sessions = 12) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<effects::ForceRecord> records;
  for (int j = 0; j < sessions; ++j) {
    effects::ForceRecord record;
    record.session = "s" + std::to_string(j);
    record.rotor_known = joint.rotor_known;
    const double gain = joint.gain + joint.gain_scatter * normal(engine);
    const double omega = 2 * std::numbers::pi * (0.3 + 0.1 * j);
    double once_N = 0;
    double twice_N = 0;
    for (int i = 0; i < joint.samples; ++i) {
      const double t = 5.0 * i / joint.samples;
      const double x = 0.05 * std::sin(omega * t);
      const double v = 0.05 * omega * std::cos(omega * t);
      const double load_N =
          joint.still_N + joint.load_N * std::sin(2 * std::numbers::pi * 0.7 * t + j);
      const double read_s = joint.jitter_s > 0 ? t + joint.jitter_s * normal(engine) : t;
      const double read_m_s = 0.05 * omega * std::cos(omega * read_s);
      const double of_load_N = joint.friction * 10 *
                               std::pow(std::abs(load_N) / 10, 1 - joint.load_exponent) *
                               (1 + joint.giving * (std::abs(load_N) / 28 - 1));
      const double slip = std::tanh(read_m_s / joint.turn_over_m_s);
      double friction_N = slip * (1 + joint.one_way * slip) * (of_load_N + joint.preload_N) +
                          joint.viscous_N_s_m * v;
      if (joint.late_s > 0) {
        constexpr int kSteps = 200;
        const double last_N = friction_N;
        for (int step = 1; step <= kSteps; ++step) {
          const double then_s = t + (step - kSteps) * 5.0 / joint.samples / kSteps;
          const double then =
              std::tanh(0.05 * omega * std::cos(omega * then_s) / joint.turn_over_m_s);
          const double now_N = then * (of_load_N + joint.preload_N) + joint.viscous_N_s_m * v;
          const double share = i == 0 ? 1 : 5.0 / joint.samples / kSteps / (joint.late_s / 2);
          once_N += share * (now_N - once_N);
          twice_N += share * (once_N - twice_N);
        }
        friction_N = i == 0 ? last_N : twice_N;
      }
      const double spring_N = joint.spring_N * x / 0.05;
      const double drift_N = joint.drift_N * (t / 2.5 - 1);
      const double inertia_N = -joint.moved_kg * omega * omega * x;
      const double shaped_N =
          joint.shaped_N * x / 0.05 * (v < 0 ? -1 : 1) * (joint.shape_turns && j % 2 == 1 ? -1 : 1);
      record.time_s.push_back(t);
      record.position_m.push_back(x);
      record.velocity_m_s.push_back(joint.velocity_reversed ? -v : v);
      record.output_N.push_back(load_N + joint.noise_N * normal(engine));
      record.output_rate_N_s.push_back(joint.load_N * 2 * std::numbers::pi * 0.7 *
                                       std::cos(2 * std::numbers::pi * 0.7 * t + j));
      record.input_N.push_back(
          gain * (load_N + friction_N + joint.cogging_N * std::sin(900 * x) + spring_N + shaped_N +
                  drift_N + inertia_N + joint.offset_N) +
          joint.noise_N * normal(engine) +
          (joint.relative_noise > 0 ? joint.relative_noise * load_N * normal(engine) : 0));
      record.bend_angle_rad.push_back(std::numbers::pi);
      record.used.push_back(true);
      record.measured.push_back(true);
    }
    record.reversal_m = reversals_m(record);
    records.push_back(std::move(record));
  }
  return records;
}

/// One session at a temperature of the sheath.
inline effects::ForceRecord measured_at(double temperature_C, const Joint& joint, unsigned seed) {
  effects::ForceRecord record = measured(joint, seed, 1).front();
  record.session = "s" + std::to_string(seed);
  record.sheath_temperature_C.assign(record.samples(), temperature_C);
  return record;
}

}  // namespace host_sim::diagnose
