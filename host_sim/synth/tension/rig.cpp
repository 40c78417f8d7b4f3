#include "host_sim/synth/tension/rig.hpp"

#include <cmath>
#include <numbers>

#include "host_sim/io/interruption.hpp"

namespace host_sim::synth {
namespace {

constexpr double kDegPerRad = 180 / std::numbers::pi;
constexpr std::size_t kSamplesBetweenChecks = 4096;

/// The motor current that gives a tension at the spool.
double current_A(const Model::Drive& drive, Parts parts, const Moment& moment, double tension_N) {
  const double radius_m = drive.spool_radius_mm * 1e-3;
  double efficiency = drive.gear_efficiency;
  double constant_Nm_per_A = drive.torque_constant_Nm_per_A;
  for (const auto& part : parts) {
    efficiency = part->gear_efficiency(efficiency, moment);
    constant_Nm_per_A = part->torque_constant_Nm_per_A(constant_Nm_per_A, moment);
  }
  double torque_Nm = tension_N * radius_m / (drive.gear_ratio * efficiency);
  for (const auto& part : parts) {
    torque_Nm = part->motor_torque_Nm(torque_Nm, moment, drive.gear_ratio / radius_m);
  }
  return torque_Nm / constant_Nm_per_A + drive.current_offset_A;
}

class Session {
 public:
  Session(const Rig& rig, const Setting& setting, const SessionScatter& scatter, Parts parts)
      : rig_(rig), setting_(setting), scatter_(scatter), parts_(parts) {
    moment_.sheath_C = rig.thermal.room_C;
    moment_.winding_C = setting.winding_start_C;
    move_to(0, rig.motion, setting, moment_);
  }

  /// Goes on to a time and reads all sensors.
  void go_to(double time_s) {
    move_to(time_s, rig_.motion, setting_, moment_);
    warm_up();
    for (const auto& part : parts_) {
      part->advance(moment_);
    }
    tension_N_ = contact_.step(parts_, rig_.friction_coefficient + scatter_.friction, moment_);
    output_N_ = read(Sensor::output_tension, moment_.output_tension_N);
    input_N_ = read(Sensor::input_tension, tension_N_);
    if (rig_.drive) {
      true_current_A_ = current_A(*rig_.drive, parts_, moment_, tension_N_);
      current_A_ = read(Sensor::motor_current, true_current_A_);
    }
  }

  void sample(Channels& channels) const {
    channels[kTime].push_back(moment_.time_s);
    channels[kInputTensionColumn].push_back(input_N_);
    channels[kOutputTensionColumn].push_back(output_N_ * std::exp(scatter_.log_gain));
    channels[kTendonVelocity].push_back(moment_.velocity_m_s);
    channels[kBendAngle].push_back(moment_.bend_angle_rad * kDegPerRad);
    channels[kSheathTemperature].push_back(moment_.sheath_C);
    if (rig_.drive) {
      const Model::Drive& drive = *rig_.drive;
      channels[kMotorCurrentColumn].push_back(current_A_);
      channels[kMotorAngle].push_back(moment_.position_m * drive.gear_ratio /
                                      (drive.spool_radius_mm * 1e-3));
      channels[kWindingTemperature].push_back(moment_.winding_C);
    }
  }

 private:
  void warm_up() {
    const Thermal& thermal = rig_.thermal;
    const double friction_W = std::abs((tension_N_ - moment_.output_tension_N) * moment_.slide_m_s);
    moment_.sheath_C = temperature_after(
        moment_.sheath_C, setting_.sheath_ambient_C + thermal.sheath_K_per_W * friction_W,
        moment_.step_s, thermal.sheath_time_constant_s);
    const double winding_W = winding_heat(true_current_A_, moment_.winding_C, thermal);
    moment_.winding_C =
        temperature_after(moment_.winding_C, thermal.room_C + thermal.winding_K_per_W * winding_W,
                          moment_.step_s, thermal.winding_time_constant_s);
  }

  double read(Sensor sensor, double value) {
    for (const auto& part : parts_) {
      value = part->reading(sensor, value, moment_);
    }
    return value;
  }

  const Rig& rig_;
  const Setting& setting_;
  const SessionScatter& scatter_;
  Parts parts_;
  Moment moment_;
  Contact contact_;
  double tension_N_ = 0;
  double true_current_A_ = 0;
  double output_N_ = 0;
  double input_N_ = 0;
  double current_A_ = 0;
};

void record(Parts parts, const Rig& rig, Channels& channels) {
  for (const auto& part : parts) {
    part->record(Sensor::output_tension, channels[kOutputTensionColumn], rig.sample_rate_Hz);
    part->record(Sensor::input_tension, channels[kInputTensionColumn], rig.sample_rate_Hz);
    part->record(Sensor::motor_current, channels[kMotorCurrentColumn], rig.sample_rate_Hz);
  }
}

}  // namespace

Channels simulate(const Rig& rig, const Setting& setting, const SessionScatter& scatter,
                  Parts parts) {
  const auto samples = static_cast<std::size_t>(std::lround(rig.duration_s * rig.sample_rate_Hz));
  const auto steps = static_cast<std::size_t>(std::ceil(kLeastRate_Hz / rig.sample_rate_Hz));
  Channels channels;
  Session session(rig, setting, scatter, parts);
  session.go_to(0);
  for (std::size_t i = 0; i < samples; ++i) {
    if (i % kSamplesBetweenChecks == 0) {
      stop_if_interrupted();
    }
    session.sample(channels);
    for (std::size_t step = 1; step <= steps; ++step) {
      const double share = static_cast<double>(step) / static_cast<double>(steps);
      session.go_to((static_cast<double>(i) + share) / rig.sample_rate_Hz);
    }
  }
  record(parts, rig, channels);
  return channels;
}

}  // namespace host_sim::synth
