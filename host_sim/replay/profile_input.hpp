#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "hal/files/profile.hpp"
#include "host_sim/extension/tension.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/replay/virtual_board.hpp"
#include "lifemodel/extension/corrector.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace host_sim {

/// Finds samples that are missing between two that are there.
class SampleClock {
 public:
  explicit SampleClock(double period_s) : period_s_(period_s) {}

  /// Samples that are missing before this time.
  std::uint32_t missing_before(double time_s) {
    std::uint32_t missing = 0;
    if (ticks_ != 0) {
      const double periods = (time_s - time_s_) / period_s_;
      if (periods > 1.5) {
        missing = static_cast<std::uint32_t>(std::min(std::round(periods) - 1, 4e9));
        ++gaps_;
      }
    } else {
      first_s_ = time_s;
    }
    ++ticks_;
    time_s_ = time_s;
    return missing;
  }

  [[nodiscard]] double duration_s() const { return ticks_ == 0 ? 0 : time_s_ - first_s_; }
  [[nodiscard]] std::uint64_t samples() const { return ticks_; }
  [[nodiscard]] std::uint64_t gaps() const { return gaps_; }
  /// True where the profile was not recorded at the rate of the model.
  [[nodiscard]] bool other_rate() const { return ticks_ > 2 && 2 * gaps_ > ticks_; }
  [[nodiscard]] double rate_Hz() const {
    return duration_s() > 0 ? static_cast<double>(ticks_ - 1) / duration_s() : 0;
  }

 private:
  double period_s_;
  double first_s_ = 0;
  double time_s_ = 0;
  std::uint64_t ticks_ = 0;
  std::uint64_t gaps_ = 0;
};

/// Turns rows of a profile into input tension, once by the conversions of the target and once in
/// double precision.
class ProfileInput {
 public:
  /// @param model with the extensions that act on the profile alone
  /// @param start_cycle that the sheath has seen before
  /// Preconditions: the model has a drive where the profile holds motor current; `parameters` are
  /// those of the model and outlive this object.
  ProfileInput(const hal::files::ProfileReader& profile, const Model& model,
               const lifemodel::ExtendedParameters& parameters, std::uint32_t start_cycle);

  /// Samples are missing before the next row.
  void gap();
  /// Whether the profile tells how the tendon moves: by its velocity, or by the angle of the motor
  /// where the model has the drive between them.
  [[nodiscard]] bool has_motion() const { return has_velocity_ || radius_m_ > 0; }

  /// Sets the tensions of the next row; raises flags as the target would.
  void take(const hal::files::ProfileRow& row, lifemodel::Flags& flags);

  [[nodiscard]] lifemodel::Tension tension() const { return tension_; }
  /// Of the tendon; 0 where the profile does not tell, and with the first angle after a gap.
  [[nodiscard]] app::Velocity velocity() const { return velocity_; }
  /// The row as the sensor of a board would give it.
  [[nodiscard]] BoardSample sample() const;
  /// What became of the row on its way into that sample.
  [[nodiscard]] lifemodel::Flags sample_flags() const { return sample_flags_; }
  [[nodiscard]] double tension_N() const { return tension_N_; }

 private:
  /// What the extended equations read besides the load, as the target gets it and exactly.
  struct Extended {
    Extended(const Model& model, const lifemodel::ExtendedParameters& parameters,
             std::uint32_t start_cycle);
    lifemodel::extension::Corrector corrector;
    ExtendedInput exact;
    lifemodel::extension::Covariates covariates;
    host_sim::Covariates exact_covariates;
    bool pulled = true;  ///< before the last turn
  };

  void take_motion(const hal::files::ProfileRow& row);
  void take_output(const hal::files::ProfileRow& row);
  void take_surroundings(const hal::files::ProfileRow& row);
  void take_extended(const hal::files::ProfileRow& row);
  [[nodiscard]] lifemodel::Direction direction() const;
  [[nodiscard]] lifemodel::Tension converted(lifemodel::Flags& flags);

  hal::files::InputKind kind_;
  bool has_bend_angle_;
  bool has_velocity_;
  double radius_m_ = 0;  ///< of the spool behind the gear, where the angle tells the motion
  double rate_Hz_;
  double ultimate_tension_N_;
  double friction_coefficient_;
  double model_bend_rad_;
  const lifemodel::Parameters& parameters_;
  std::optional<Extended> extended_;
  reference::Drive drive_{};
  reference::Direction direction_ = reference::Direction::kPulling;
  std::optional<double> angle_rad_;  ///< of the sample before
  app::Velocity velocity_;
  lifemodel::Flags sample_flags_;
  lifemodel::Tension measured_;
  lifemodel::MotorCurrent current_;
  lifemodel::Angle bend_;
  lifemodel::Tension tension_;
  double tension_N_ = 0;
};

}  // namespace host_sim
