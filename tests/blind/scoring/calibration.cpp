#include "tests/blind/scoring/calibration.hpp"

#include <algorithm>
#include <cmath>

namespace blind {

void Calibration::add(double probability, bool right) {
  const double last = static_cast<double>(bins_.size() - 1);
  const double place =
      std::clamp(std::floor(probability * static_cast<double>(bins_.size())), 0.0, last);
  Bin& bin = bins_[static_cast<std::size_t>(place)];
  ++bin.answers;
  bin.right += right ? 1 : 0;
  bin.sum_of_probabilities += probability;
}

double Calibration::error() const {
  double distance = 0;
  double answers = 0;
  for (const Bin& bin : bins_) {
    distance += std::abs(static_cast<double>(bin.right) - bin.sum_of_probabilities);
    answers += static_cast<double>(bin.answers);
  }
  return answers > 0 ? distance / answers : 0;
}

}  // namespace blind
