#include "host_sim/statistics/location_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "host_sim/statistics/distribution.hpp"

namespace host_sim::statistics {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// ln of a probability or density as a function of one deviate or two, and its derivatives.
struct LogTerm {
  double value = 0;
  double low = 0, high = 0;
  double low_low = 0, low_high = 0, high_high = 0;
};

/// The parts of ln (F(high) - F(low)) that all distributions share.
/// @param at_low,at_high densities there over that probability; 0 at an infinite end
/// @param rise_low,rise_high derivatives of ln density there
LogTerm between(double value, double at_low, double at_high, double rise_low, double rise_high) {
  return {.value = value,
          .low = -at_low,
          .high = at_high,
          .low_low = -rise_low * at_low - at_low * at_low,
          .low_high = at_low * at_high,
          .high_high = rise_high * at_high - at_high * at_high};
}

struct Normal {
  static double offset_near(const CentredSample&, double, double) { return 0; }

  static LogTerm density(double z) {
    return {.value = log_normal_density(z), .low = -z, .low_low = -1};
  }

  static LogTerm between(double low, double high) {
    if (std::isinf(high)) {
      return statistics::between(log_normal_survival(low), normal_hazard(low), 0, -low, 0);
    }
    if (std::isinf(low)) {
      return statistics::between(log_normal_survival(-high), 0, normal_hazard(-high), 0, -high);
    }
    const double ln_p = log_probability(low, high);
    return statistics::between(ln_p, std::exp(log_normal_density(low) - ln_p),
                               std::exp(log_normal_density(high) - ln_p), -low, -high);
  }

 private:
  static double log_probability(double low, double high) {
    if (low + high < 0) {
      return log_probability(-high, -low);
    }
    if (low < 0) {
      return std::log1p(-std::exp(log_normal_survival(-low)) - std::exp(log_normal_survival(high)));
    }
    const double above_low = log_normal_survival(low);
    return above_low + std::log(-std::expm1(log_normal_survival(high) - above_low));
  }
};

struct SmallestExtreme {
  /// That of the sample if what broke did so at the ends of its intervals, so that no hazard
  /// overflows; values are not above 0.
  static double offset_near(const CentredSample& sample, double slope, double unit) {
    double hazards = 0;
    const auto add = [&](double value) { hazards += std::exp(slope * value / unit); };
    std::ranges::for_each(sample.failed(), add);
    std::ranges::for_each(sample.suspended(), add);
    for (const CentredSample::Ends& ends : sample.between()) {
      add(ends.high);
    }
    return std::log(hazards / static_cast<double>(sample.failures())) -
           slope * sample.failed_mean() / unit;
  }

  static LogTerm density(double z) {
    const double hazard = std::exp(z);
    return {.value = z - hazard, .low = 1 - hazard, .low_low = -hazard};
  }

  static LogTerm between(double low, double high) {
    const double hazard_low = std::exp(low);
    if (std::isinf(high)) {
      return statistics::between(-hazard_low, hazard_low, 0, 1 - hazard_low, 0);
    }
    const double hazard_high = std::exp(high);
    const double more = std::isinf(low) ? hazard_high : hazard_low * std::expm1(high - low);
    const double p = -std::expm1(-more);  // of those that were alive at `low`
    const double at_high = more < kNothingLeft ? hazard_high * std::exp(-more) / p : 0;
    return statistics::between(-hazard_low + std::log(p), hazard_low / p, at_high, 1 - hazard_low,
                               at_high > 0 ? 1 - hazard_high : 0);
  }

 private:
  static constexpr double kNothingLeft = 700;
};

/// One slope for all samples, and an offset for each: the deviate of a value is
/// slope * (value - centre) / unit - offset.
struct Olsen {
  double slope = 1;
  std::vector<double> offsets;
};

/// Gradient and Hessian; offsets of different samples do not mix.
struct Derivatives {
  struct OfOffset {
    double first = 0, second = 0, with_slope = 0;
  };
  double slope = 0, slope_slope = 0;
  std::vector<OfOffset> offsets;
};

/// What one value or two give, with the derivatives of the deviate: -1 by the offset, the scaled
/// value by the slope.
void add(const LogTerm& term, double low, double high, Derivatives& to,
         Derivatives::OfOffset& offset) {
  offset.first -= term.low + term.high;
  offset.second += term.low_low + 2 * term.low_high + term.high_high;
  offset.with_slope -= term.low_low * low + term.low_high * (low + high) + term.high_high * high;
  to.slope += term.low * low + term.high * high;
  to.slope_slope +=
      term.low_low * low * low + 2 * term.low_high * low * high + term.high_high * high * high;
}

/// Root mean square distance of what failed, and of the suspended beyond it, from the mean.
double unit_of(std::span<const CentredSample> samples) {
  double squares = 0;
  double count = 0;
  for (const CentredSample& sample : samples) {
    const double distance = sample.spread();
    squares += distance * distance;
    ++count;
  }
  const double unit = std::sqrt(squares / count);
  return unit > 0 ? unit : 1;
}

template <typename Law>
class Likelihood {
 public:
  Likelihood(std::span<const CentredSample> samples, double unit) : samples_(samples), unit_(unit) {
    for (const CentredSample& sample : samples) {
      exact_ += static_cast<double>(sample.failed().size());
    }
  }

  [[nodiscard]] double operator()(const Olsen& at) const {
    double sum = exact_ * std::log(at.slope / unit_);
    for_each_term(at,
                  [&sum](std::size_t, const LogTerm& term, double, double) { sum += term.value; });
    return sum;
  }

  [[nodiscard]] Derivatives derivatives(const Olsen& at) const {
    Derivatives result;
    result.offsets.resize(samples_.size());
    result.slope = exact_ / at.slope;
    result.slope_slope = -exact_ / (at.slope * at.slope);
    for_each_term(at, [&result](std::size_t i, const LogTerm& term, double low, double high) {
      add(term, low, high, result, result.offsets[i]);
    });
    return result;
  }

 private:
  /// Calls visit(sample, term, scaled low end, scaled high end), an end that is infinite as 0.
  template <typename Visit>
  void for_each_term(const Olsen& at, const Visit& visit) const {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const CentredSample& sample = samples_[i];
      const auto scaled = [&](double value) { return (value - sample.failed_mean()) / unit_; };
      const auto deviate = [&](double v) { return at.slope * v - at.offsets[i]; };
      for (const double value : sample.failed()) {
        const double v = scaled(value);
        visit(i, Law::density(deviate(v)), v, 0.0);
      }
      for (const double value : sample.suspended()) {
        const double v = scaled(value);
        visit(i, Law::between(deviate(v), kNoEnd), v, 0.0);
      }
      for (const CentredSample::Ends& ends : sample.between()) {
        const double high = scaled(ends.high);
        const bool left = std::isinf(ends.low);
        const double low = left ? 0 : scaled(ends.low);
        visit(i, Law::between(left ? -kNoEnd : deviate(low), deviate(high)), low, high);
      }
    }
  }

  std::span<const CentredSample> samples_;
  double unit_;
  double exact_ = 0;
};

/// The step of all offsets, and of the slope unless it is held.
Olsen newton_step(const Derivatives& d, bool hold_slope) {
  Olsen step{.slope = 0, .offsets = std::vector<double>(d.offsets.size())};
  if (!hold_slope) {
    double gradient = d.slope;
    double bend = d.slope_slope;
    for (const Derivatives::OfOffset& offset : d.offsets) {
      gradient -= offset.with_slope * offset.first / offset.second;
      bend -= offset.with_slope * offset.with_slope / offset.second;
    }
    step.slope = -gradient / bend;
  }
  for (std::size_t i = 0; i < d.offsets.size(); ++i) {
    step.offsets[i] =
        -(d.offsets[i].first + d.offsets[i].with_slope * step.slope) / d.offsets[i].second;
  }
  return step;
}

Olsen moved(const Olsen& from, const Olsen& step, double share) {
  Olsen to = from;
  to.slope += share * step.slope;
  for (std::size_t i = 0; i < to.offsets.size(); ++i) {
    to.offsets[i] += share * step.offsets[i];
  }
  return to;
}

/// Part of the step that keeps the slope positive and does not lower the likelihood by more than
/// rounding does.
template <typename Law>
double usable_share(const Likelihood<Law>& likelihood, const Olsen& from, const Olsen& step) {
  constexpr double kSmallest = 1e-9;
  constexpr double kRounding = 1e-10;  // of differences between close ends
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

bool negligible(const Olsen& step, const Olsen& at) {
  constexpr double kTolerance = 1e-8;  // squared by the step itself
  for (std::size_t i = 0; i < at.offsets.size(); ++i) {
    // Written so that what is not a number is not negligible.
    if (!(std::abs(step.offsets[i]) <= kTolerance * (1 + std::abs(at.offsets[i])))) {
      return false;
    }
  }
  return std::abs(step.slope) <= kTolerance * at.slope;
}

template <typename Law>
LocationScaleFit ascend(std::span<const CentredSample> samples, double held_scale) {
  constexpr int kIterations = 100;
  const double unit = unit_of(samples);
  const bool held = held_scale > 0;
  const Likelihood<Law> likelihood(samples, unit);
  Olsen at{.slope = held ? unit / held_scale : 1, .offsets = {}};
  for (const CentredSample& sample : samples) {
    at.offsets.push_back(Law::offset_near(sample, at.slope, unit));
  }
  LocationScaleFit fit;
  for (int i = 0; i < kIterations && !fit.converged; ++i) {
    const Olsen step = newton_step(likelihood.derivatives(at), held);
    fit.converged = negligible(step, at);
    const double share = fit.converged ? 1 : usable_share(likelihood, at, step);
    if (share == 0) {
      break;
    }
    at = moved(at, step, share);
  }
  fit.scale = unit / at.slope;
  fit.log_likelihood = likelihood(at);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    fit.location.push_back(samples[i].failed_mean() + fit.scale * at.offsets[i]);
  }
  return fit;
}

LocationScaleFit ascend(std::span<const CentredSample> samples, Standard standard,
                        double held_scale) {
  return standard == Standard::normal ? ascend<Normal>(samples, held_scale)
                                      : ascend<SmallestExtreme>(samples, held_scale);
}

}  // namespace

LocationScaleFit fit_location_scale(std::span<const CentredSample> samples, Standard standard) {
  return ascend(samples, standard, 0);
}

LocationScaleFit fit_locations(std::span<const CentredSample> samples, Standard standard,
                               double scale) {
  return ascend(samples, standard, scale);
}

}  // namespace host_sim::statistics
