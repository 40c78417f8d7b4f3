#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace host_sim::effects {

/// How the tendon was driven, sample by sample as it was read.
struct Motion {
  std::vector<double> time_s;
  std::vector<double> velocity_m_s;
};

/// One session in newtons: every sample in order, forces signed. Vectors are of one length, but for
/// those that may be empty where nothing measured them.
struct ForceRecord {
  std::string session;
  std::vector<double> time_s;
  std::vector<double> input_N;
  std::vector<double> output_N;
  std::vector<double> output_rate_N_s;  ///< d T_out/dt
  std::vector<double> velocity_m_s;
  std::vector<double> position_m;
  std::vector<double> reversal_m;  ///< where it turned since the sample before; else its position
  /// All that was read; null where that is the samples of the record.
  std::shared_ptr<const Motion> motion;
  std::size_t motion_step = 1;  ///< samples of it from one of the record to the next
  std::vector<double> bend_angle_rad;
  std::vector<double> sheath_temperature_C;   ///< empty where no session varies in it
  std::vector<double> winding_temperature_C;  ///< the same
  std::vector<double> rotor_rad;              ///< may be empty
  std::vector<double> cycle;                  ///< of the tendon's life; may be empty
  std::vector<bool> measured;                 ///< whether its channels could be read
  std::vector<bool> used;       ///< of these, whether it counts; motion goes on where it does not
  std::size_t input_hold = 1;   ///< samples of the log that each value stayed for
  std::size_t output_hold = 1;  ///< the same
  double input_N_per_A = 0;     ///< of a motor current, which the input force is of; 0: a load cell
  bool rotor_known = false;     ///< the position is that of the rotor and not an integral
  bool pulls_alone = false;     ///< one tendon, whose force has one sign

  [[nodiscard]] std::size_t samples() const { return time_s.size(); }
  /// Mean time between samples. @pre one or more
  [[nodiscard]] double step_s() const {
    return (time_s.back() - time_s.front()) /
           static_cast<double>(std::max<std::size_t>(samples() - 1, 1));
  }
};

/// Leaves these samples of a record, in order. @pre one or more
void keep(ForceRecord& record, const std::vector<std::size_t>& samples);

/// Over the samples of a session. @pre one or more
double mean_of(std::span<const double> values);

/// What terms are measured by, of all records together.
struct ForceScales {
  double speed_m_s = 0;   ///< nine tenths of all samples are slower
  double stroke_m = 0;    ///< between the 1 % and the 99 % quantile of the position
  double position_m = 0;  ///< the middle between these
  double force_N = 0;     ///< root mean square of the output force
  double input_N = 0;     ///< of the input force, which a drive that runs free has nearly alone
  /// Of velocity: below it the direction of friction is not settled, by what it was measured with.
  double turn_over_m_s = 0;
  /// How late what rubs follows the motion, as filters of both forces have it.
  double forces_late_s = 0;
  double step_s = 0;              ///< mean time between samples
  double cycles = 0;              ///< the last of the tendon's life
  std::vector<double> poses_rad;  ///< mean bend angles of sessions that differ by a degree, rising

  /// Wavelength of friction by position: what rubs at one end of the stroke need not at the other,
  /// and waves as long as the stroke would have it so.
  [[nodiscard]] double wavelength_m() const { return 1.25 * stroke_m; }
  [[nodiscard]] double larger_N() const { return std::max(force_N, input_N); }
};
ForceScales scales_of(std::span<const ForceRecord> records);

/// What each sample of a record has by its motion, whatever the parameters.
struct Kinematics {
  std::vector<double> turned_over;               ///< how far its speed turns friction over, -1 .. 1
  std::vector<std::size_t> pose;                 ///< the nearest of ForceScales::poses_rad
  std::vector<double> place_sine, place_cosine;  ///< of its place in ForceScales::wavelength_m()
  double middle_sine = 0, middle_cosine = 1;     ///< the same of the middle of the record
};

/// Where the motion turns between samples, on the parabola of their speeds, as reversal_m.
std::vector<double> reversals_m(const ForceRecord& record);

/// Samples next to which, on one side, the motion turns.
std::vector<bool> next_to_turns(const ForceRecord& record);

/// Kinematics::turned_over of a record.
std::vector<double> turned_over(const ForceRecord& record, const ForceScales& scales);

Kinematics kinematics_of(const ForceRecord& record, const ForceScales& scales);

/// A record as it is so much later, between samples.
struct LaterRecord {
  ForceRecord record;
  std::optional<Kinematics> kinematics;  ///< none: those that it has
};

/// Output forces that are read later; earlier, below 0, the motion with them, so that the input
/// force alone is late.
/// @pre two samples or more
LaterRecord read_later(const ForceRecord& record, const Kinematics& kinematics,
                       const ForceScales& scales, double later_s);

}  // namespace host_sim::effects
