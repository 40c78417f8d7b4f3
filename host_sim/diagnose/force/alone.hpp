#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hal/files/profile_columns.hpp"
#include "host_sim/effects/tension/force_record.hpp"

/// One session by gain and friction that suit it alone, and words for what is doubtful about it.
namespace host_sim::diagnose {

/// Of sessions: what more than that show is not told of single ones.
inline constexpr double kFewOfAll = 0.25;
/// Of ln gain: beyond it units and parameters are asked for.
inline constexpr double kDoubtfulLogGain = 0.3;
/// Of fewer sessions it is not known which of them is unlike the others.
inline constexpr std::size_t kEnoughToCompare = 10;

/// What suits one session alone: T_in = gain T_out + s (of_size |T_out| + constant), where s is the
/// direction of the motion.
struct Alone {
  double gain = 0;       ///< if all friction is that of a sheath, in proportion to the load
  double most_gain = 0;  ///< if none is
  double friction = 0;   ///< force against the motion, mean, over the mean size of T_out
  double by_output = 0;  ///< of the squared error by friction alone, what the gain takes off
  double shown = 0;      ///< of the squared error without friction, what that takes off
  double square_N2 = 0;
  double mean_angle_rad = 0;
  double scale = 1;           ///< of the motion of the rotor over that by the velocity
  double along = 0;           ///< correlation of the two
  bool starts_again = false;  ///< whether the angle of the rotor jumps by whole turns
};

/// None where too few samples count.
/// @param input_later, velocity_later samples by which these are taken to be late
std::optional<Alone> alone(const effects::ForceRecord& record, std::ptrdiff_t input_later = 0,
                           std::ptrdiff_t velocity_later = 0);

/// The name of a column of recordings.
std::string column(hal::files::ProfileColumnId id);

/// Of what the input force was measured by.
std::string input_column(const effects::ForceRecord& record);

/// @pre one value or more
double median_of(std::vector<double> values);

/// Between what units of a force, or of a motion, a factor lies, as words behind it; empty where
/// none are known.
std::string unit_prose(double factor);
std::string motion_unit_prose(double factor);

}  // namespace host_sim::diagnose
