#include "host_sim/statistics/centred_sample.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::statistics {

void CentredSample::assign(Family family, std::span<const Observation> sample) {
  copy(family, sample);
  largest_ = values_.empty() ? 0 : *std::max_element(values_.begin(), values_.end());
  for (double& value : values_) {
    value -= largest_;
  }
  measure_failures();
}

void CentredSample::copy(Family family, std::span<const Observation> sample) {
  values_.resize(sample.size());
  std::size_t front = 0;
  std::size_t back = sample.size();
  for (const Observation& seen : sample) {
    const double value = family == Family::normal ? seen.value : std::log(seen.value);
    values_[seen.failed ? front++ : --back] = value;
  }
  failures_ = front;
}

void CentredSample::measure_failures() {
  failed_mean_ = 0;
  failed_deviation_ = 0;
  if (failures_ == 0) {
    return;
  }
  const auto count = static_cast<double>(failures_);
  for (const double value : failed()) {
    failed_mean_ += value / count;
  }
  double squares = 0;
  for (const double value : failed()) {
    squares += (value - failed_mean_) * (value - failed_mean_);
  }
  failed_deviation_ = std::sqrt(squares / count);
}

FitProblem CentredSample::problem() const {
  if (failures_ < 2) {
    return FitProblem::too_few_failures;
  }
  return without_spread() ? FitProblem::no_spread : FitProblem::none;
}

}  // namespace host_sim::statistics
