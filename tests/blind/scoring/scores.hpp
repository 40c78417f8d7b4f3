#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/blind/records/record.hpp"
#include "tests/blind/scoring/calibration.hpp"
#include "tests/blind/scoring/proportion.hpp"

namespace blind {

/// Of campaigns with one effect: the first candidate is the truth, or in a class with it.
struct Detection {
  Proportion first, of_class;
};

/// The scores of a run, of those records that the analysis did not refuse.
struct Scores {
  std::size_t refused = 0;

  Proportion none_named;    ///< of campaigns that hide nothing: something is named
  Proportion none_alarmed;  ///< the same: the verdict is not none

  Detection one;                             ///< over all sizes
  Detection one_at_3, one_at_5;              ///< where an oracle sees it at so many sigmas
  std::map<std::string, Detection> effects;  ///< by id, over all sizes

  Proportion named_right;     ///< of all campaigns with a name: each name is right
  Proportion two_first;       ///< of campaigns with two: both together are the first candidate
  Proportion two_first_at_5;  ///< the same, where an oracle sees each of them
  Proportion two_named;
  Proportion outside_unknown, outside_named;
  std::map<std::string, Proportion> outside;  ///< unknown, by id

  Proportion covered;   ///< of all campaigns: the 95 % set holds the truth
  double set_size = 0;  ///< mean
  Calibration calibration;

  std::vector<double> parameter_errors;  ///< relative, rising
  Proportion parameters_covered;

  std::vector<double> relative_gains;  ///< of the true model's, where named right; rising

  /// Campaigns by truth and first candidate.
  std::map<std::pair<std::string, std::string>, std::size_t> confusion;
};

Scores scores_of(const std::vector<Record>& records);

/// The value below which a share of sorted numbers lies; NaN of none. @pre 0 <= share <= 1
double quantile(const std::vector<double>& sorted, double share);

}  // namespace blind
