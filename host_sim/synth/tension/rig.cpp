#include "host_sim/synth/tension/rig.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "host_sim/synth/tension/recorder.hpp"

namespace host_sim::synth {

using enum hal::files::ProfileColumnId;

namespace {

constexpr double kCopperPerKelvin = 0.00393;

}  // namespace

double temperature_after(double now_C, double end_C, double step_s, double time_constant_s) {
  return now_C + (end_C - now_C) * -std::expm1(-step_s / time_constant_s);
}

double winding_heat(double current_A, double winding_C, const Thermal& thermal) {
  const double resistance_ohm =
      thermal.winding_resistance_ohm * (1 + kCopperPerKelvin * (winding_C - thermal.room_C));
  return current_A * current_A * resistance_ohm;
}

namespace {

// Far beyond what can be recorded, so that values that run away end there.
constexpr double kMostFriction = 1e3;
constexpr double kMost_N = 1e12;

constexpr int kPieces = 16;
constexpr int kBits = 40;
constexpr std::uintmax_t kMostSteps = 60;

double stiffness_of(TensionParts parts) {
  double compliance_m_N = 0;
  for (const auto& part : parts) {
    compliance_m_N += 1 / part->stiffness_N_m();
  }
  return 1 / compliance_m_N;
}

double friction(TensionParts parts, const Covariates& covariates, double mu, double tension_N) {
  for (const auto& part : parts) {
    mu = part->friction(mu, covariates, tension_N);
  }
  return std::clamp(mu, 0.0, kMostFriction);
}

double along_sheath_N(TensionParts parts, const Covariates& covariates, double mu,
                      double exponent_rad) {
  double tension_N = covariates.output_tension_N;
  const double piece_rad = exponent_rad / kPieces;
  for (int i = 0; i < kPieces; ++i) {
    const double here = friction(parts, covariates, mu, tension_N);
    const double middle_N = tension_N * std::exp(here * piece_rad / 2);
    tension_N *= std::exp(friction(parts, covariates, mu, middle_N) * piece_rad);
  }
  return tension_N;
}

double state_after(TensionParts parts, double before, double direction, double slide_m) {
  double state = direction;
  for (const auto& part : parts) {
    state = part->friction_state(state, before, slide_m);
  }
  return state;
}

/// Where `excess` changes its sign between 0 and `end`; 0 where it is not negative there, `end`
/// where it is not positive there.
template <class Excess>
double root_between_0_and(double end, const Excess& excess) {
  const double at_low = excess(0.0);
  if (at_low >= 0) {
    return 0;
  }
  const double at_high = excess(end);
  if (at_high <= 0) {
    return end;
  }
  std::uintmax_t most_steps = kMostSteps;
  const boost::math::tools::eps_tolerance<double> tolerance(kBits);
  const auto bracket =
      boost::math::tools::toms748_solve(excess, 0.0, end, at_low, at_high, tolerance, most_steps);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace

double tension_at_drive_N(TensionParts parts, const Covariates& covariates, double mu,
                          double friction_state) {
  double angle_rad = covariates.bend_angle_rad;
  bool along_sheath = false;
  for (const auto& part : parts) {
    angle_rad = part->bend_angle_rad(angle_rad, covariates);
    along_sheath = along_sheath || part->along_sheath();
  }
  const double exponent_rad = std::max(0.0, angle_rad) * friction_state;
  const double output_N = covariates.output_tension_N;
  double tension_N =
      along_sheath ? along_sheath_N(parts, covariates, mu, exponent_rad)
                   : output_N * std::exp(friction(parts, covariates, mu, output_N) * exponent_rad);
  for (const auto& part : parts) {
    tension_N = part->input_tension_N(tension_N, friction_state, covariates);
  }
  return std::clamp(tension_N, 0.0, kMost_N);
}

double Contact::step(TensionParts parts, double mu, Covariates& covariates) {
  const double direction = covariates.direction;
  const double travel_m = std::max(0.0, direction * covariates.travel_m);
  const double stiffness = stiffness_of(parts);
  if (!std::isfinite(stiffness)) {
    covariates.slide_m_s = covariates.velocity_m_s;
    state_ = state_after(parts, state_, direction, direction * travel_m);
    return tension_at_drive_N(parts, covariates, mu, state_);
  }
  if (covariates.step_s <= 0) {
    covariates.slide_m_s = 0;
    return tension_N_ = tension_at_drive_N(parts, covariates, mu, state_);
  }
  const auto sliding_N = [&](double slid_m) {
    covariates.slide_m_s = direction * slid_m / covariates.step_s;
    return tension_at_drive_N(parts, covariates, mu,
                              state_after(parts, state_, direction, direction * slid_m));
  };
  // Pulling, the tension rises with the stretch until the contact slides; letting go, it falls.
  const double slid_m = root_between_0_and(travel_m, [&](double slide_m) {
    const double stretched_N = tension_N_ + direction * stiffness * (travel_m - slide_m);
    return direction * (sliding_N(slide_m) - stretched_N);
  });
  if (slid_m > 0) {
    tension_N_ = sliding_N(slid_m);
    state_ = state_after(parts, state_, direction, direction * slid_m);
    return tension_N_;
  }
  covariates.slide_m_s = 0;
  const double stuck_N = tension_N_ + direction * stiffness * travel_m;
  const double slips_back_N = tension_at_drive_N(parts, covariates, mu, -direction);
  tension_N_ = direction > 0 ? std::max(stuck_N, slips_back_N) : std::min(stuck_N, slips_back_N);
  return tension_N_;
}

namespace {

/// The motor current that gives a tension at the spool.
double current_A(const Model::Drive& drive, TensionParts parts, const Covariates& covariates,
                 double tension_N) {
  const double radius_m = drive.spool_radius_m();
  double efficiency = drive.gear_efficiency;
  double constant_Nm_per_A = drive.torque_constant_Nm_per_A;
  for (const auto& part : parts) {
    efficiency = part->gear_efficiency(efficiency, covariates);
    constant_Nm_per_A = part->torque_constant_Nm_per_A(constant_Nm_per_A, covariates);
  }
  double torque_Nm = tension_N * radius_m / (drive.gear_ratio * efficiency);
  for (const auto& part : parts) {
    torque_Nm = part->motor_torque_Nm(torque_Nm, covariates, drive.gear_ratio / radius_m);
  }
  return torque_Nm / constant_Nm_per_A + drive.current_offset_A;
}

class Session {
 public:
  Session(const Rig& rig, const Setting& setting, const SessionScatter& scatter, TensionParts parts,
          const Instants& instants, Channels& channels)
      : rig_(rig),
        setting_(setting),
        scatter_(scatter),
        parts_(parts),
        channels_(channels),
        recorder_(rig, instants, channels) {
    covariates_.sheath_C = rig.thermal.room_C;
    covariates_.winding_C = setting.winding_start_C;
    move_to(0, rig.motion, setting, covariates_);
  }

  void run() {
    recorder_.run([&](double time_s) { go_to(time_s); }, [&] { sample(); });
  }

 private:
  /// Goes on to a time and reads all sensors.
  void go_to(double time_s) {
    move_to(time_s, rig_.motion, setting_, covariates_);
    warm_up();
    for (const auto& part : parts_) {
      part->advance(covariates_);
    }
    tension_N_ = contact_.step(parts_, rig_.friction_coefficient + scatter_.friction, covariates_);
    recorder_.output.pass(time_s, read(Sensor::output_tension, covariates_.output_tension_N) *
                                      std::exp(scatter_.log_gain));
    recorder_.input.pass(time_s, read(Sensor::input_tension, tension_N_));
    if (rig_.drive) {
      true_current_A_ = current_A(*rig_.drive, parts_, covariates_, tension_N_);
      recorder_.current.pass(time_s, read(Sensor::motor_current, true_current_A_));
    }
  }

  /// What is read in time, beside the ends of the sheath.
  void sample() {
    recorder_.sample(covariates_);
    channels_[kSheathTemperature].push_back(covariates_.sheath_C);
    if (rig_.drive) {
      channels_[kWindingTemperature].push_back(covariates_.winding_C);
    }
  }

  void warm_up() {
    const Thermal& thermal = rig_.thermal;
    const double friction_W =
        std::abs((tension_N_ - covariates_.output_tension_N) * covariates_.slide_m_s);
    covariates_.sheath_C = temperature_after(
        covariates_.sheath_C, setting_.sheath_ambient_C + thermal.sheath_K_per_W * friction_W,
        covariates_.step_s, thermal.sheath_time_constant_s);
    const double winding_W = winding_heat(true_current_A_, covariates_.winding_C, thermal);
    covariates_.winding_C = temperature_after(covariates_.winding_C,
                                              thermal.room_C + thermal.winding_K_per_W * winding_W,
                                              covariates_.step_s, thermal.winding_time_constant_s);
  }

  double read(Sensor sensor, double value) {
    for (const auto& part : parts_) {
      value = part->reading(sensor, value, covariates_);
    }
    return value;
  }

  const Rig& rig_;
  const Setting& setting_;
  const SessionScatter& scatter_;
  TensionParts parts_;
  Channels& channels_;
  Recorder recorder_;
  Covariates covariates_;
  Contact contact_;
  double tension_N_ = 0;
  double true_current_A_ = 0;
};

void record(TensionParts parts, const Rig& rig, Channels& channels) {
  for (const auto& part : parts) {
    part->record(Sensor::output_tension, channels[kOutputTensionColumn], rig.sample_rate_Hz);
    part->record(Sensor::input_tension, channels[kInputTensionColumn], rig.sample_rate_Hz);
    part->record(Sensor::motor_current, channels[kMotorCurrentColumn], rig.sample_rate_Hz);
    part->record(Sensor::velocity, channels[kTendonVelocity], rig.sample_rate_Hz);
  }
}

}  // namespace

std::size_t samples_of(const Rig& rig) {
  return static_cast<std::size_t>(std::lround(rig.duration_s * rig.sample_rate_Hz));
}

Channels simulate(const Rig& rig, const Setting& setting, const SessionScatter& scatter,
                  TensionParts parts, const Instants& instants) {
  Channels channels;
  Session(rig, setting, scatter, parts, instants, channels).run();
  record(parts, rig, channels);
  return channels;
}

}  // namespace host_sim::synth
