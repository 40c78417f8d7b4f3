#pragma once

#include <array>
#include <cstddef>

namespace blind {

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

}  // namespace blind
