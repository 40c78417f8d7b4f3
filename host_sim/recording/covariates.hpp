#pragma once

#include <vector>

#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

/// What effects are written in terms of, sample by sample. Each vector has one value for each kept
/// sample, or is empty where the channels that it needs were not recorded.
struct Covariates {
  std::vector<double> time_s;
  std::vector<double> cycle;              ///< start_cycle plus the reversals since over two
  std::vector<double> direction;          ///< s: 1 while pulling, -1 while letting go
  std::vector<double> velocity_m_s;       ///< v, smoothed
  std::vector<double> bend_angle_rad;     ///< phi: of the recording, else of the nominal sheath
  std::vector<double> input_tension_N;    ///< of the load cell
  std::vector<double> current_A;          ///< motor current less the nominal offset
  std::vector<double> current_tension_N;  ///< T_in that the current stands for (nominal drive)
  std::vector<double> output_tension_N;
  std::vector<double> travel_m;    ///< tendon travel since the last reversal
  std::vector<double> position_m;  ///< motor angle times spool radius over gear ratio, or the
                                   ///< integral of velocity where no angle was recorded
  std::vector<double> motor_angle_rad;
  std::vector<double> log_tension_rate_1_s;  ///< d ln T_in / dt, central differences over 5 samples
  std::vector<double> log_output_rate_1_s;   ///< d ln T_out / dt, which has no jumps: smoothed
  std::vector<double> sheath_temperature_C;
  std::vector<double> winding_temperature_C;

  /// Variances of the noise of ln T_in and ln T_out; empty where it is not known.
  std::vector<double> input_noise;
  std::vector<double> output_noise;

  /// mu of this recording by itself, see settled_friction(); 0 where it does not show.
  double settled_friction = 0;

  [[nodiscard]] std::size_t samples() const { return time_s.size(); }
  /// T_in of the load cell where there is one, else of the current.
  [[nodiscard]] const std::vector<double>& tension_in_N() const {
    return input_tension_N.empty() ? current_tension_N : input_tension_N;
  }
};

/// Covariates of one recording. Channels that are constant by their fault count as not recorded.
/// Left out are the samples that another fault touches, those before direction and travel are known
/// (see motion.hpp), those of a tension that is not positive, and pieces of fewer than 5 samples;
/// all of them where no input tension, no output tension or no velocity remains.
///
/// A position that is integrated from velocity (trapezoids) is 0 in the middle of its range and
/// bridges gaps. Motor current needs `nominal.drive`; so does the position of a motor angle, which
/// without it is integrated too.
/// @param faults of this session and of any others
/// @throws InputError where the drive is missing, or where no bend angle is known
Covariates covariates_of(const Recording& recording, const std::vector<Fault>& faults,
                         const NominalModel& nominal);

/// Sums over samples that have travelled kSettledTravel_m or more since a reversal, of x = -phi s
/// and y = ln T_out/T_in: where y = gain + mu x, whatever acts at reversals. Zero where those are
/// fewer than a quarter of all.
struct SettledSums {
  double square = 0;   ///< of x about its mean in the recording
  double product = 0;  ///< of x and y about their means

  explicit SettledSums(const Covariates& covariates);
};

/// Friction coefficient of the settled samples, 0 where they are none or of one direction.
double settled_friction(const Covariates& covariates);

/// A friction coefficient that was found, where it is within a factor of four of the nominal one;
/// else the nominal.
inline double plausible_friction(double found, double nominal) {
  constexpr double kMostFactor = 4;
  return found > nominal / kMostFactor && found < nominal * kMostFactor ? found : nominal;
}

}  // namespace host_sim::recording
