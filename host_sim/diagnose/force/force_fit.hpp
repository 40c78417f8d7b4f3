#pragma once

#include <span>
#include <vector>

#include "host_sim/diagnose/force/force_model.hpp"

namespace host_sim::diagnose {

/// A forward model that was fitted to the input forces of records.
struct ForceFit {
  ForceTerms terms;
  std::vector<double> parameters;
  double square_N2 = 0;  ///< sum of squared residuals of the records that it was fitted to
};

/// All records of a campaign and what a fit needs of them.
class ForceData {
 public:
  explicit ForceData(std::vector<ForceRecord> records);

  [[nodiscard]] const std::vector<ForceRecord>& records() const { return records_; }
  [[nodiscard]] const ForceScales& scales() const { return scales_; }
  [[nodiscard]] double samples() const { return samples_; }

  /// Residuals of a record in N, those of samples that do not count as 0.
  [[nodiscard]] std::vector<double> residuals_N(std::size_t record, const ForceTerms& terms,
                                                std::span<const double> parameters) const;

  /// Least squares within the bounds (Levenberg-Marquardt), from these parameters on.
  /// @param fold records of this number modulo kFolds stay out; none: all take part
  [[nodiscard]] ForceFit fit(const ForceTerms& terms, std::vector<double> start, int iterations,
                             int fold = -1) const;

  /// With one term more, the best of all its starts.
  [[nodiscard]] ForceFit with(const ForceFit& fit, ForceTerm more) const;
  /// Without one of its terms.
  [[nodiscard]] ForceFit without(const ForceFit& fit, std::size_t place) const;

  /// Fitted again without the records of each fold in turn.
  [[nodiscard]] std::vector<ForceFit> fold_fits(const ForceFit& fit) const;

  /// Mean squared residual of each record, by fits that never saw it.
  [[nodiscard]] std::vector<double> held_out_N2(const ForceFit& fit) const;

  /// Root mean square over records of such means.
  [[nodiscard]] double rmse_N(std::span<const double> means_N2) const;

  /// 95 % half-widths of the parameters, of records that scatter as wholes (sandwich).
  [[nodiscard]] std::vector<double> half_widths(const ForceFit& fit) const;

  /// Whether a parameter lies at a bound of physics, by more than its own zero.
  [[nodiscard]] bool at_bound(const ForceFit& fit, std::size_t term) const;

  static constexpr int kFolds = 5;

  [[nodiscard]] static bool is_held_out(std::size_t record, int fold) {
    return static_cast<int>(record % kFolds) == fold;
  }

 private:
  void settle_turn_over();
  struct Normal;
  [[nodiscard]] Normal normal_of(const ForceTerms& terms, std::span<const double> parameters,
                                 int fold) const;
  [[nodiscard]] double square_of(const ForceTerms& terms, std::span<const double> parameters,
                                 int fold) const;

  std::vector<ForceRecord> records_;
  ForceScales scales_;
  std::vector<double> counts_;  ///< of samples that count, by record
  double samples_ = 0;
};

/// How much less one model leaves than another, record by record: the mean of ln(rmse_b/rmse_a) and
/// that mean over its standard error.
struct PairedGain {
  double mean = 0;
  double z = 0;
};
PairedGain paired_gain(std::span<const double> before_N2, std::span<const double> after_N2);

}  // namespace host_sim::diagnose
