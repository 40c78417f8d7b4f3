#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"
#include "host_sim/diagnose/force/judgement.hpp"

namespace host_sim::diagnose {

inline constexpr std::size_t kMostForceTerms = 5;

/// Grows a model of the input force by effects of the catalogue as long as they gain on sessions
/// that the fit never saw, and takes those out again without which it does as well.
class ForceSearch {
 public:
  struct Candidate {
    ForceFit fit;
    HeldOut held;
  };

  /// @param records that the data are of, with all samples; kept by reference
  /// @param friction coefficient that the nominal model starts with
  ForceSearch(ForceData& data, std::span<const effects::ForceRecord> records, double friction,
              const DiagnoseOptions& options);

  /// Where what few sessions seem to scatter by leads the model away they are taken to be alike,
  /// and nothing stands.
  void run();

  [[nodiscard]] const Candidate& nominal() const { return nominal_; }
  [[nodiscard]] const Candidate& model() const { return model_; }
  [[nodiscard]] double nominal_rmse_N() const { return data_.rmse_N(nominal_.held.plain_N2); }
  [[nodiscard]] double rmse_N() const { return data_.rmse_N(model_.held.plain_N2); }
  /// The terms of the model, in order.
  [[nodiscard]] const std::vector<Judged>& judged() const { return judged_; }
  [[nodiscard]] const std::vector<LeftOut>& left_out() const { return left_out_; }

  /// Of the parameters of the model.
  [[nodiscard]] std::vector<double> half_widths(double times) const {
    return inliers_->half_widths(model_.fit, times);
  }
  /// Of each of its terms, whether it may be none by those.
  [[nodiscard]] std::vector<bool> may_be_none(double times) const {
    const std::vector<double> half = inliers_->half_widths_of_sizes(model_.fit, times);
    std::vector<bool> none;
    for (std::size_t i = 0; i < model_.fit.terms.size(); ++i) {
      none.push_back(inliers_->may_be_none(model_.fit, i, half));
    }
    return none;
  }

  [[nodiscard]] const std::vector<ForceCovariate>& covariates() const { return covariates_; }
  [[nodiscard]] const std::vector<CovariateBins>& bins() const { return bins_; }

  /// From the nominal model on, one term more each: those that stay in the order in which they
  /// came, or where none stays those that came as far as that gains.
  [[nodiscard]] std::vector<Candidate> stairs() const;

 private:
  struct Added {
    effects::ForceTerm term{};
    std::optional<Candidate> grown;  ///< from the one added before; none: it took a place
  };

  void search();
  void report(double share) const;
  bool settle();
  void find_left_out();
  ForceFit leave_out_outliers();
  void learn_covariance();
  [[nodiscard]] Candidate by_own_scatter(const ForceFit& fit) const;
  [[nodiscard]] std::vector<effects::ForceTerm> beside(const effects::ForceTerms& taken) const;
  [[nodiscard]] std::vector<Candidate> with_each(const ForceFit& from,
                                                 const std::vector<effects::ForceTerm>& terms,
                                                 double most_N2,
                                                 const ForceFit* like = nullptr) const;
  void hold_out(std::vector<Candidate>& all) const;
  bool grow_on();
  bool grow();
  bool grow_by_two(const Candidate& first);
  void add(Candidate grown);
  [[nodiscard]] bool is_seen_beside(const HeldOut& before, const Candidate& grown) const;
  [[nodiscard]] std::vector<Candidate> with_session_effects(
      std::span<const effects::ForceTerm> terms) const;
  [[nodiscard]] std::vector<Candidate>::iterator first_law_as_good(
      std::vector<Candidate>& all, std::vector<Candidate>::iterator best) const;
  bool reduce();
  bool prune();
  [[nodiscard]] Judgement judgement() const {
    return {data_, model_.fit, model_.held, left_, judged_};
  }
  [[nodiscard]] ForceData as_sampled() const {
    return data_.as_sampled({records_.begin(), records_.end()}, nominal_.fit, model_.fit);
  }
  [[nodiscard]] PairedGain lost_as_sampled(const ForceFit& other) const;
  [[nodiscard]] PairedGain lost_in_time(const Judged& one, const Candidate& other) const;
  bool exchange(bool allowed);
  [[nodiscard]] ForceFit as_late(std::size_t place, effects::ForceTerm otherwise) const;
  [[nodiscard]] std::vector<Candidate> in_place_of(std::size_t place) const;

  ForceData& data_;
  std::span<const effects::ForceRecord> records_;
  const DiagnoseOptions& options_;
  std::vector<ForceCovariate> covariates_;
  std::vector<CovariateBins> bins_;  ///< of each covariate
  Candidate nominal_;
  Candidate model_;
  std::vector<Judged> judged_;
  std::vector<LeftOut> left_out_;
  Structure left_;  ///< by the model that they are judged in
  std::vector<Added> added_;
  bool with_timing_ = false;          ///< noise of when samples were read is learned, too
  effects::ForceTerms settled_by_;    ///< by which friction turns over as it does
  std::optional<ForceData> inliers_;  ///< of the model
};

}  // namespace host_sim::diagnose
