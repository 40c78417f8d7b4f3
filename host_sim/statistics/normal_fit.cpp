#include "host_sim/statistics/normal_fit.hpp"

#include <cmath>

#include "host_sim/statistics/normal_tail.hpp"

namespace host_sim::statistics {
namespace {

/// The parameters in which the likelihood is concave (Olsen 1978): the deviate of a value is
/// slope * (value - centre) / unit - offset.
struct Olsen {
  double offset;  ///< mean over standard deviation
  double slope;   ///< 1 over standard deviation
};

struct Derivatives {
  double offset = 0, slope = 0;
  double offset_offset = 0, offset_slope = 0, slope_slope = 0;

  /// Of a term of the log likelihood with derivatives `first` and `second` in its deviate.
  void add(double value, double first, double second) {
    offset -= first;
    slope += first * value;
    offset_offset += second;
    offset_slope -= second * value;
    slope_slope += second * value * value;
  }
};

/// Root mean square distance from the mean of the failures, of them and of the suspended beyond it.
double spread(const CentredSample& sample) {
  double squares = 0;
  double count = 0;
  const auto add = [&](double value) {
    squares += (value - sample.failed_mean()) * (value - sample.failed_mean());
    ++count;
  };
  for (const double value : sample.failed()) {
    add(value);
  }
  for (const double value : sample.suspended()) {
    if (value > sample.failed_mean()) {
      add(value);
    }
  }
  return std::sqrt(squares / count);
}

/// The likelihood in units of the spread of the sample.
class NormalLikelihood {
 public:
  explicit NormalLikelihood(const CentredSample& sample)
      : sample_(sample), failures_(static_cast<double>(sample.failures())), unit_(spread(sample)) {}

  [[nodiscard]] double operator()(Olsen at) const {
    double sum = failures_ * std::log(at.slope / unit_);
    for (const double value : sample_.failed()) {
      sum += log_normal_density(deviate(value, at));
    }
    for (const double value : sample_.suspended()) {
      sum += log_normal_survival(deviate(value, at));
    }
    return sum;
  }

  [[nodiscard]] Derivatives derivatives(Olsen at) const {
    Derivatives result;
    result.slope = failures_ / at.slope;
    result.slope_slope = -failures_ / (at.slope * at.slope);
    for (const double value : sample_.failed()) {
      result.add(scaled(value), -deviate(value, at), -1);
    }
    for (const double value : sample_.suspended()) {
      const double z = deviate(value, at);
      const double hazard = normal_hazard(z);
      result.add(scaled(value), -hazard, -hazard * (hazard - z));
    }
    return result;
  }

  [[nodiscard]] Distribution distribution(Olsen at) const {
    return {.family = Family::normal,
            .first = sample_.largest() + sample_.failed_mean() + unit_ * at.offset / at.slope,
            .second = unit_ / at.slope};
  }

 private:
  [[nodiscard]] double scaled(double value) const {
    return (value - sample_.failed_mean()) / unit_;
  }
  [[nodiscard]] double deviate(double value, Olsen at) const {
    return at.slope * scaled(value) - at.offset;
  }

  const CentredSample& sample_;
  double failures_;
  double unit_;
};

Olsen newton_step(const Derivatives& d) {
  const double determinant = d.offset_offset * d.slope_slope - d.offset_slope * d.offset_slope;
  return {.offset = (d.offset_slope * d.slope - d.slope_slope * d.offset) / determinant,
          .slope = (d.offset_slope * d.offset - d.offset_offset * d.slope) / determinant};
}

Olsen moved(Olsen from, Olsen step, double share) {
  return {.offset = from.offset + share * step.offset, .slope = from.slope + share * step.slope};
}

/// Part of the step that keeps the slope positive and does not lower the likelihood by more than
/// rounding does.
double usable_share(const NormalLikelihood& likelihood, Olsen from, Olsen step) {
  constexpr double kSmallest = 1e-9;
  constexpr double kRounding = 1e-13;
  const double before = likelihood(from);
  const double lowest = before - kRounding * (1 + std::abs(before));
  double share = 1;
  while (share > kSmallest) {
    const Olsen next = moved(from, step, share);
    if (next.slope > 0 && likelihood(next) >= lowest) {
      return share;
    }
    share /= 2;
  }
  return 0;
}

bool negligible(Olsen step, Olsen at) {
  constexpr double kTolerance = 1e-8;  // squared by the step itself
  return std::abs(step.offset) <= kTolerance * (1 + std::abs(at.offset)) &&
         std::abs(step.slope) <= kTolerance * at.slope;
}

}  // namespace

Fit fit_normal(const CentredSample& sample) {
  constexpr int kIterations = 100;
  const NormalLikelihood likelihood(sample);
  Olsen at{.offset = 0, .slope = 1};
  for (int i = 0; i < kIterations; ++i) {
    const Olsen step = newton_step(likelihood.derivatives(at));
    if (negligible(step, at)) {
      at = moved(at, step, 1);
      return {.distribution = likelihood.distribution(at), .log_likelihood = likelihood(at)};
    }
    const double share = usable_share(likelihood, at, step);
    if (share == 0) {
      break;
    }
    at = moved(at, step, share);
  }
  return {.distribution = {}, .problem = FitProblem::not_converged};
}

}  // namespace host_sim::statistics
