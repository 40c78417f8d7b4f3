#pragma once

#include <cmath>

namespace host_sim::reference {

/// Neumaier's compensated sum: the error stays near one rounding of the result, whatever the number
/// of terms.
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    carry_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + carry_; }

 private:
  double sum_ = 0.0;
  double carry_ = 0.0;
};

}  // namespace host_sim::reference
