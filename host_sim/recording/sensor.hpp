#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/recording/signal.hpp"

namespace host_sim::recording {

/// The q-quantile of `values` (at least one), for q in [0, 1], without interpolation.
double quantile(std::vector<double> values, double q);

/// The smallest step from one value to the next that is not zero; 0 where all are equal.
double resolution(std::span<const double> values);

/// Standard deviation of the noise of a sensor, from the median of |x[i-1] - 2 x[i] + x[i+1]|,
/// which is 0.6745 sqrt(6) of it for independent normal noise. Steps do not disturb it, nor does
/// motion that is slow against the sample rate. Zero for fewer than three values, and where most
/// values repeat or lie on a line.
double noise_sigma(std::span<const double> values);

/// How the values of one channel behave.
struct Sensor {
  double lowest = 0;
  double highest = 0;
  double noise_sigma = 0;  ///< see noise_sigma()
  double resolution = 0;   ///< see resolution()
  /// How many equal values in a row noise does not leave by chance; 0 where the sensor shows too
  /// little noise to judge by. It is judged by the tenth of the samples around which the values
  /// change least, outside of rows of 8 and more equal ones. Independent noise turns back from two
  /// thirds of them: 8 where 40 % turn back and at most 5 % repeat, 50 where 25 % and at most 30 %
  /// do.
  std::size_t longest_by_chance = 0;

  [[nodiscard]] double span() const { return highest - lowest; }
};

/// @param values at least one
Sensor sensor_of(std::span<const double> values);

/// Rows of at least `least` samples of equal value, in order.
std::vector<Stretch> still_stretches(std::span<const double> values, std::size_t least);

/// For how many samples each value stays, of a sensor that is read less often than it is logged; 1
/// where it is not. Of twenty values or more four fifths stay for so many, or one more or less, and
/// half of what they change by is more than two of its least steps: rest and a coarse scale do not
/// look like that.
std::size_t hold_of(std::span<const double> values);

/// How far `values` go up after having been lower, within the stretch.
double rise_in(std::span<const double> values, const Stretch& stretch);

/// How far `values` go down after having been higher, within the stretch.
double fall_in(std::span<const double> values, const Stretch& stretch);

/// The larger of the excursions that come back: up and as far down again, or down and up.
double swing_in(std::span<const double> values, const Stretch& stretch);

}  // namespace host_sim::recording
