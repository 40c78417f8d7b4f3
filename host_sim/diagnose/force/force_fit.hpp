#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "host_sim/diagnose/force/force_covariance.hpp"
#include "host_sim/diagnose/force/smoothing.hpp"
#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::diagnose {

/// Below this many sessions their scatter is not known, and no effect is named.
inline constexpr std::size_t kLeastSessions = 4;

/// A forward model that was fitted to the input forces of records.
struct ForceFit {
  effects::ForceTerms terms;
  std::vector<double> parameters;
  double square_N2 = 0;  ///< of the residuals of the records that it was fitted to, by the scatter
};

/// Mean squared residual of each record, by fits that never saw it.
struct HeldOut {
  std::vector<double> plain_N2;
  std::vector<double> weighted_N2;        ///< each sample by its noise
  std::vector<double> beside_scatter_N2;  ///< without what gain and friction of the session explain
  std::vector<std::vector<double>> residuals_N;
  /// Of the gain and friction that sessions have beside the fit to all of them.
  double log_likelihood = 0;
};

/// All records of a campaign and what a fit needs of them: the output force smoothed, and samples
/// thinned.
class ForceData {
  /// Of least squares beside the scatter of sessions: J'J and J'r of a record.
  struct Normal {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd gradient;

    /// One parameter stays as it is, and the others go without it.
    void fix(Eigen::Index place);
  };

 public:
  static constexpr std::size_t kMostSamples = 600;  ///< of a record, or up to twice that
  static constexpr int kIterations = 15;            ///< of a fit that starts

  explicit ForceData(std::vector<effects::ForceRecord> records);

  /// All samples of the same records, beside the scatter that a model leaves.
  [[nodiscard]] ForceData as_sampled(std::vector<effects::ForceRecord> records,
                                     const ForceFit& nominal, const ForceFit& model) const;

  [[nodiscard]] const std::vector<effects::ForceRecord>& records() const { return records_; }
  [[nodiscard]] const effects::ForceScales& scales() const { return scales_; }
  [[nodiscard]] const std::vector<effects::Kinematics>& kinematics() const { return kinematics_; }
  [[nodiscard]] double samples() const { return samples_; }
  /// Of samples that count, by record.
  [[nodiscard]] const std::vector<double>& counts() const { return counts_; }

  /// How much less of the output's noise that smoothing has left a model passes on than another,
  /// where that is white.
  [[nodiscard]] double noise_taken_N2(const ForceFit& before, const ForceFit& after) const;

  /// The parameters that noise of the output moves to those of a fit.
  [[nodiscard]] ForceFit beside_output_noise(const ForceFit& fit) const;

  /// Friction turns over as sharply and as late as a model says that has what else acts at
  /// reversals, where that is seen to be another way.
  /// @returns whether it is
  bool settle_turn_over(const ForceFit& model);

  /// From here on gain and friction of sessions scatter as this model leaves them to, and do to
  /// the force what they do by it.
  /// @param with_timing whether samples may have been read sooner or later than their time
  void learn_covariance(const ForceFit& nominal, const ForceFit& model, bool with_timing);
  /// From here on they do not scatter.
  void forget_scatter() { covariance_.forget_scatter(); }
  [[nodiscard]] const ForceCovariance& covariance() const { return covariance_; }
  /// Mean square of what that scatter does to samples, in the mean of all sessions.
  [[nodiscard]] double scatter_of_mean_N2() const;

  /// The same without samples that a model leaves far outside of the others' scatter once gain and
  /// friction of their session are refitted: at the edges of what sets in at once, samples lie on
  /// the other side than the model has them.
  [[nodiscard]] ForceData without_outliers(const ForceFit& fit) const;

  /// Residuals of a record in N, those of samples that do not count as 0.
  [[nodiscard]] std::vector<double> residuals_N(std::size_t record,
                                                const effects::ForceTerms& terms,
                                                std::span<const double> parameters) const;

  /// Of all records.
  [[nodiscard]] std::vector<std::vector<double>> residuals_N(const ForceFit& fit) const;

  /// What a unit of ln gain, then of friction, of a session does to the input force by a model, in
  /// N; 0 where a sample does not count. What rubs at any speed goes in proportion to itself, that
  /// of the sheath to the load, at the temperatures and the age of the whole session.
  /// @param friction_coefficient that it is a share of
  [[nodiscard]] Eigen::MatrixX2d directions_N(std::size_t record, const ForceFit& model,
                                              double friction_coefficient) const;

  /// Sum of squares of what two models differ by, beside the scatter of sessions.
  [[nodiscard]] double distance_N2(const ForceFit& one, const ForceFit& other) const;

  /// Least squares beside the scatter of sessions, within the bounds (Levenberg-Marquardt), from
  /// these parameters on.
  /// @param fold records of this number modulo kFolds stay out; none: all take part
  /// @param normals of all records at the start, where they are known
  [[nodiscard]] ForceFit fit(const effects::ForceTerms& terms, std::vector<double> start,
                             int iterations, int fold = -1,
                             const std::vector<Normal>* normals = nullptr) const;

  /// With one of these terms more, one each, from the best of its starts, after a few iterations.
  [[nodiscard]] std::vector<ForceFit> started(const ForceFit& fit,
                                              std::span<const effects::ForceTerm> more,
                                              unsigned threads) const;
  /// The same with all iterations, or fewer where it is there before.
  [[nodiscard]] ForceFit finished(const ForceFit& fit) const;
  /// By other samples of these records, or beside other scatter, from where it was.
  [[nodiscard]] ForceFit fitted_anew(const ForceFit& fit) const;
  /// With one term more and all iterations.
  [[nodiscard]] ForceFit with(const ForceFit& from, effects::ForceTerm term,
                              unsigned threads) const {
    return finished(started(from, std::span(&term, 1), threads).front());
  }
  /// Without one of its terms.
  [[nodiscard]] ForceFit without(const ForceFit& fit, std::size_t place) const;

  /// How many folds there are, kFolds where there are as many records.
  [[nodiscard]] int folds() const { return std::min(kFolds, static_cast<int>(records_.size())); }

  /// Each of these fitted again without the records of each fold in turn.
  [[nodiscard]] std::vector<std::vector<ForceFit>> fold_fits(std::span<const ForceFit> fits,
                                                             unsigned threads) const;
  [[nodiscard]] std::vector<ForceFit> fold_fits(const ForceFit& fit) const {
    return fold_fits(std::span(&fit, 1), 1).front();
  }

  [[nodiscard]] HeldOut held_out(const ForceFit& fit) const;
  /// @param seen fold_fits() of a fit
  [[nodiscard]] HeldOut held_out(const ForceFit& fit, std::span<const ForceFit> seen) const;

  /// The same where samples next to which the motion turns leave nothing.
  [[nodiscard]] HeldOut away_from_turns(HeldOut held) const;

  /// Mean square of each record's residuals, which are 0 where a sample does not count.
  [[nodiscard]] std::vector<double> mean_squares_N2(
      const std::vector<std::vector<double>>& residuals_N) const;

  /// Root mean square over records of such means.
  [[nodiscard]] double rmse_N(std::span<const double> means_N2) const;

  /// 95 % half-widths of the parameters, of records that scatter as wholes, and where a parameter
  /// lies between samples of how far they are apart at all reversals.
  /// @param times as far as they scatter
  [[nodiscard]] std::vector<double> half_widths(const ForceFit& fit, double times = 1) const;

  /// The same of sizes, given what says how each effect is: of cycles to a power of which neither
  /// is well known by itself, the change may be sure.
  [[nodiscard]] std::vector<double> half_widths_of_sizes(const ForceFit& fit,
                                                         double times = 1) const;

  /// ln of the density of a term's parameters before they are measured, normal of their usual size,
  /// times the volume that data leave of them (Laplace). Of one that is chosen each is as likely.
  [[nodiscard]] double log_occam(const ForceFit& fit, std::size_t term) const;

  /// Whether the parameters of a term are within the bounds of physics, of which zero is none where
  /// it is the least, and larger than what samples that are so far apart resolve.
  [[nodiscard]] bool is_physical(const ForceFit& fit, std::size_t term) const;

  /// Whether the 95 % intervals of a term's parameters hold that it has no effect: no size of it
  /// is other than zero, or one that samples resolve is not surely more than they do.
  /// @param half half_widths_of_sizes() of the fit
  [[nodiscard]] bool may_be_none(const ForceFit& fit, std::size_t term,
                                 std::span<const double> half) const;

  static constexpr int kFolds = 5;

  [[nodiscard]] static bool is_held_out(std::size_t record, int fold) {
    return static_cast<int>(record % kFolds) == fold;
  }

 private:
  /// Of the parameters.
  struct Covariance {
    Eigen::MatrixXd of_records;  ///< that scatter as wholes, by how far each moves them
    Eigen::MatrixXd of_noise;    ///< of least squares, as noisy as those are in the mean
    Eigen::MatrixXd of_gain;     ///< that the nominal model has, known however few the records are
  };
  [[nodiscard]] Covariance covariance_of(const ForceFit& fit) const;
  /// @param bound places of parameters that stay as they are
  [[nodiscard]] Covariance covariance_of(const ForceFit& fit, std::vector<Normal> normals,
                                         std::span<const Eigen::Index> bound) const;
  [[nodiscard]] std::vector<double> half_widths_by(const Covariance& covariance,
                                                   const ForceFit& fit, double times) const;
  [[nodiscard]] Eigen::VectorXd step_from(const ForceFit& fit) const;
  [[nodiscard]] double freedom_of(const ForceFit& fit) const;

  /// Standard deviation of ln gain: more than that off is told as a doubt about units.
  static constexpr double kLogGain = 0.3;

  /// In the place of a fold: one record in three, where those are enough to choose a start by.
  static constexpr int kSome = -2;
  [[nodiscard]] bool is_left_out(std::size_t record, int fold) const {
    constexpr std::size_t kEnough = 12;
    return fold == kSome ? records_.size() >= kEnough && record % 3 != 0
                         : is_held_out(record, fold);
  }

  void take_records(std::vector<effects::ForceRecord> records, std::size_t most);
  void take_means(HeldOut& held) const;
  void settle_turn_over();
  void turn_over_by(const ForceFit& model, double least_N2);
  void turn_over_late_by(const ForceFit& model);
  double take_best_of(std::span<const effects::ForceScales> all, const ForceFit& model,
                      double least_N2);
  void take_scales(const effects::ForceScales& scales);
  /// @param square_N2 of the residuals of all sessions
  [[nodiscard]] double gain_weight_N2(double square_N2) const;
  void settle_resolution();
  [[nodiscard]] ForceFit beyond_steps(ForceFit best) const;
  /// Residuals of a record by predicted input forces.
  [[nodiscard]] std::vector<double> left_N(std::size_t record, std::vector<double> input_N) const;
  [[nodiscard]] Normal normal_of(std::size_t record, const effects::ForceTerms& terms,
                                 std::span<const double> parameters) const;
  /// Of each record, empty where it stays out.
  [[nodiscard]] std::vector<Normal> normals_of(const effects::ForceTerms& terms,
                                               std::span<const double> parameters, int fold) const;
  /// With what is known of the gain.
  [[nodiscard]] Normal sum_of(const std::vector<Normal>& normals,
                              std::span<const double> parameters, int fold) const;
  [[nodiscard]] double square_of(const effects::ForceTerms& terms,
                                 std::span<const double> parameters, int fold) const;

  std::vector<effects::ForceRecord> records_;
  effects::ForceScales scales_;
  std::vector<effects::Kinematics> kinematics_;  ///< of each record
  ForceCovariance covariance_;
  std::vector<OutputNoise> noise_;  ///< that smoothing has left, of each record
  double gain_weight_N2_ = 0;       ///< of the square of ln gain, beside the residuals
  std::vector<double> counts_;      ///< of samples that count, by record
  double resolution_m_ = 0;  ///< standard deviation of a place between samples, of all reversals
  double samples_ = 0;
};

}  // namespace host_sim::diagnose
