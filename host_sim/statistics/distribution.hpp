#pragma once

#include <optional>
#include <span>
#include <vector>

namespace host_sim::statistics {

/// What is known of a life.
struct Observation {
  double value = 0;    ///< above 0; of a suspended specimen what its life is longer than
  bool failed = true;  ///< else suspended
  /// Of a specimen that was found broken: its life is longer than this and at most `value`; 0 where
  /// it was broken when first looked at. None where the life is known.
  std::optional<double> from = {};
  /// Its life was dropped as one of the lowest of its sample (failed, at most `value`) or of the
  /// highest (not failed, longer than `value`), where `value` is the lowest or highest life kept:
  /// the density of what is kept is that of a sample of which so many are censored there.
  bool trimmed = false;

  /// Whether its life is known.
  [[nodiscard]] bool exact() const { return failed && !from; }
};
using Sample = std::vector<Observation>;

enum class Family { normal, lognormal, weibull };

/// A life distribution with two parameters:
///   normal     location: mean, scale: standard deviation
///   lognormal  the same of the natural logarithm
///   weibull    scale: characteristic life alpha, shape: beta, eq. (15)
struct Distribution {
  Family family = Family::weibull;
  double first = 1;   ///< mean, mean of ln, or alpha
  double second = 1;  ///< standard deviation, that of ln, or beta

  [[nodiscard]] double cdf(double x) const;
  [[nodiscard]] double log_density(double x) const;
  [[nodiscard]] double log_survival(double x) const;
  /// Where `p`, 0 .. 1, have failed.
  [[nodiscard]] double quantile(double p) const;
  [[nodiscard]] double mean() const;
};

/// Sum over the failures of the log density, over the suspended of the log survival, and over those
/// found broken of the log of the probability to break in between.
double log_likelihood(const Distribution& distribution, std::span<const Observation> sample);

/// Quantile of 97.5 % of the standard normal distribution: half the width of an interval of 95 %.
inline constexpr double kNormal95 = 1.959963984540054;

/// The same of Student's t distribution.
double student95(double degrees_of_freedom);

/// Four standard deviations of normal values, as the median of their magnitudes has them: one value
/// in 16,000 is further off.
/// @param magnitudes one or more
double outlier_limit(std::vector<double> magnitudes);

/// ln phi(z), the standard normal density.
double log_normal_density(double z);

/// ln Q(z), with Q the upper tail of the standard normal distribution; accurate for every z.
double log_normal_survival(double z);

/// phi(z) / Q(z), the hazard of the standard normal distribution; accurate for every z.
double normal_hazard(double z);

/// Order of lives in which specimens that failed at a life come before those suspended there, and
/// those that were dropped because they failed before it come first.
bool rises_failures_first(const Observation& left, const Observation& right);

/// Kaplan and Meier's estimate of the share that has failed. Of lives that were dropped as the
/// lowest it knows that they ended before the first step. assign() again reuses the memory.
class KaplanMeier {
 public:
  /// A distinct life at which something failed.
  struct Step {
    double value = 0;
    double before = 0;  ///< share failed just before, 0 .. 1
    double after = 0;   ///< and with this life
  };

  /// @pre no life is known only to lie between two ends, but of those that were dropped
  void assign(std::span<const Observation> sample);
  /// The same of a sample in order of lives; of equal lives the earlier leaves the risk set first.
  void assign_in_order(std::span<const Observation> sample);

  [[nodiscard]] std::span<const Step> steps() const { return steps_; }
  [[nodiscard]] double size() const { return size_; }
  /// Share that failed before anything is known of where.
  [[nodiscard]] double dropped() const { return dropped_; }
  [[nodiscard]] double last() const { return last_; }  ///< largest observation
  /// All have failed at the last observation, so that the estimate continues beyond it as 1.
  [[nodiscard]] bool complete() const { return !steps_.empty() && steps_.back().after == 1; }

 private:
  Sample sorted_;
  std::vector<Step> steps_;
  double size_ = 0;
  double dropped_ = 0;
  double last_ = 0;
};

}  // namespace host_sim::statistics
