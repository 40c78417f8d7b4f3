#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/blind/scoring/record.hpp"

namespace blind {

/// How many of some campaigns something holds for.
struct Proportion {
  std::size_t holds = 0;
  std::size_t of = 0;

  void add(bool one) {
    holds += one ? 1 : 0;
    ++of;
  }
  /// NaN of none.
  [[nodiscard]] double value() const;

  /// Bounds of 95 % together, by Clopper and Pearson, The use of confidence or fiducial limits
  /// illustrated in the case of the binomial, Biometrika 26, 1934. 0 and 1 of none.
  [[nodiscard]] double lower() const;
  [[nodiscard]] double upper() const;

  /// What `some` campaigns have to reach at least: fewer come out of them in one draw of ten at
  /// most, where each holds with this proportion.
  [[nodiscard]] std::size_t least_of(std::size_t some) const;
};

/// "96.0 % (93.1 .. 97.9, 288 of 300)", or "-" of none.
std::string text_of(const Proportion& proportion);

/// Answers by the probability that they were given with, in ten bins of equal width.
class Calibration {
 public:
  struct Bin {
    std::size_t answers = 0;
    std::size_t right = 0;
    double sum_of_probabilities = 0;
  };

  /// @param probability 0 .. 1
  void add(double probability, bool right);

  /// Expected calibration error: over the bins, the mean of the distance between the share that is
  /// right and the mean probability, weighted by answers; 0 of none. Reference: Naeini, Cooper and
  /// Hauskrecht, Obtaining well calibrated probabilities using Bayesian binning, AAAI 2015.
  [[nodiscard]] double error() const;

  [[nodiscard]] const std::array<Bin, 10>& bins() const { return bins_; }

 private:
  std::array<Bin, 10> bins_{};
};

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
  Proportion one_named_at_5;                 ///< the same: it is named, and nothing else
  std::map<std::string, Detection> effects;  ///< by id, over all sizes

  Proportion named_right;     ///< of all campaigns with a name: each name is right
  Proportion two_first;       ///< of campaigns with two: both together are the first candidate
  Proportion two_first_at_5;  ///< the same, where an oracle sees each of them
  Proportion two_named;
  Proportion three_first, three_named;  ///< the same of campaigns with three
  Proportion outside_unknown, outside_named;
  Proportion held_back_unknown, held_back_named;  ///< of these, what is held back from tuning
  std::map<std::string, Proportion> outside;      ///< unknown, by id

  Proportion covered;   ///< of all campaigns: the 95 % set holds the truth
  double set_size = 0;  ///< mean
  Calibration calibration;

  std::vector<double> parameter_errors;  ///< relative, rising
  Proportion parameters_covered;         ///< of campaigns that hide one effect
  Proportion parameters_covered_of_several;

  std::vector<double> relative_gains;  ///< of the true model's, where named right; rising

  /// Campaigns by truth and first candidate; of several effects by how much of them is in it.
  std::map<std::pair<std::string, std::string>, std::size_t> confusion;
};

Scores scores_of(const std::vector<Record>& records);

/// The value below which a share of sorted numbers lies; NaN of none. @pre 0 <= share <= 1
double quantile(const std::vector<double>& sorted, double share);

}  // namespace blind
