#include "host_sim/diagnose/force/force_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "host_sim/diagnose/force/alone.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

constexpr int kRounds = 3;  ///< of terms that take the place of others

/// A fit beside the scatter of sessions leaves more of the samples as they are than one without, by
/// no more than this share and three standard errors of what scatters: where it does, what the
/// model has no law for passes for scatter, and leads it away from all sessions alike.
constexpr double kLedAway = 0.25;
constexpr double kOfScatter = 9;

ForceSearch::Candidate candidate_of(const ForceData& data, const ForceFit& fit) {
  ForceSearch::Candidate one{data.fit(fit.terms, fit.parameters, ForceData::kIterations), {}};
  one.held = data.held_out(one.fit);
  return one;
}

bool is_led_away(const ForceData& data, const ForceFit& beside_scatter) {
  ForceData even = data;
  even.forget_scatter();
  const auto left_N2 = [&](const ForceFit& fit) {
    return std::pow(data.rmse_N(data.mean_squares_N2(data.residuals_N(fit))), 2);
  };
  const double least_N2 = left_N2(even.finished(beside_scatter));
  const double more_N2 = left_N2(beside_scatter) - least_N2;
  return more_N2 > std::max(kLedAway * least_N2, kOfScatter * data.scatter_of_mean_N2());
}

/// Puts those of what sessions differ in behind the others.
/// @returns the first of them
std::vector<effects::ForceTerm>::iterator of_sessions_last(std::vector<effects::ForceTerm>& terms) {
  return std::stable_partition(terms.begin(), terms.end(), [](effects::ForceTerm term) {
    return !is_of(effects::ForceLaw::Of::session, term);
  });
}

bool is_seen(effects::ForceTerm term, const PairedGain& gain) {
  return 2 * evidence_of(term, gain) >= kSeen * kSeen && gain.any();
}

}  // namespace

ForceSearch::ForceSearch(ForceData& data, std::span<const effects::ForceRecord> records,
                         double friction, const DiagnoseOptions& options)
    : data_(data),
      records_(records),
      options_(options),
      covariates_(force_covariates(data.records())),
      nominal_{data.fit({}, {1, friction}, ForceData::kIterations), {}} {
  for (const ForceCovariate& covariate : covariates_) {
    bins_.emplace_back(data.records(), covariate);
  }
  nominal_.held = data.held_out(nominal_.fit);
  model_ = nominal_;
}

void ForceSearch::run() {
  search();
  const bool few = data_.records().size() < kEnoughToCompare;
  if (few && is_led_away(data_, model_.fit)) {
    data_.forget_scatter();
    nominal_ = candidate_of(data_, nominal_.fit);
    model_ = nominal_;
    judged_.clear();
    added_.clear();
  }
  const ForceFit by_inliers = leave_out_outliers();
  find_left_out();
  if (by_inliers.terms.empty()) {
    nominal_ = model_;  // of what came and went nothing is left
  } else {
    model_ = {by_inliers, data_.held_out(by_inliers, inliers_->fold_fits(by_inliers))};
  }
}

void ForceSearch::search() {
  constexpr double kOfGrowing = 0.3;
  constexpr double kOfPruning = 0.1;
  report(0);
  bool of_sessions = false;
  for (int round = 0; round < 2; ++round) {
    with_timing_ = round > 0;
    if (!settle()) {
      learn_covariance();
    }
    of_sessions = grow_on();
    report(kOfGrowing * (round + 1));
  }
  if (of_sessions) {
    learn_covariance();
  }
  bool exchanged = false;
  for (int round = 0; round < kRounds; ++round) {
    if (exchanged) {
      learn_covariance();
    }
    if (reduce() || exchanged) {
      if (grow_on()) {
        learn_covariance();
      }
      reduce();
    }
    report(2 * kOfGrowing + kOfPruning * (round + 1));
    exchanged = exchange(round + 1 < kRounds);
    if (!exchanged) {
      break;
    }
  }
}

/// Effects that the model does without, and what gains most of them beside it.
void ForceSearch::find_left_out() {
  std::vector<effects::ForceTerm> terms = beside(model_.fit.terms);
  const auto of_effect = [&](effects::ForceTerm term) {
    return std::ranges::find_if(
        left_out_, [&](const LeftOut& other) { return same_effect(other.term, term); });
  };
  for (const effects::ForceTerm term : terms) {
    if (of_effect(term) == left_out_.end()) {
      left_out_.push_back({.term = term});
    }
  }
  const auto of_sessions = of_sessions_last(terms);
  std::vector<Candidate> all = with_each(model_.fit, {terms.begin(), of_sessions}, HUGE_VAL);
  hold_out(all);
  std::ranges::move(with_session_effects({of_sessions, terms.end()}), std::back_inserter(all));
  for (const Candidate& one : all) {
    const effects::ForceTerm term = one.fit.terms.back();
    double& most = of_effect(term)->probability;  // of several laws
    most = std::max(most, probability_of(term, gain_of(term, data_, model_.held, one.held), data_));
  }
}

/// Grows as long as that gains.
/// @returns whether by anything that sessions differ in
bool ForceSearch::grow_on() {
  bool of_sessions = false;
  while (model_.fit.terms.size() < kMostForceTerms && grow()) {
    of_sessions = of_sessions || is_of(effects::ForceLaw::Of::session, model_.fit.terms.back());
  }
  return of_sessions;
}

/// Takes out what does not stay.
/// @returns whether friction turns over otherwise then, which may have hidden others
bool ForceSearch::reduce() {
  bool settled = false;
  bool other = true;
  while (other) {
    const bool less = prune();
    const bool anew = !less && settle();
    settled = settled || anew;
    other = less || anew;
  }
  return settled;
}

/// Settles how sharp friction turns over where the model is another one, as what came or went may
/// have stood for that.
/// @returns whether it does otherwise
bool ForceSearch::settle() {
  const bool other = !model_.fit.terms.empty() && model_.fit.terms != settled_by_ &&
                     data_.settle_turn_over(model_.fit);
  settled_by_ = model_.fit.terms;
  if (other) {
    learn_covariance();
  }
  return other;
}

/// The parameters of a model that is settled are those that outliers have no part in. A term that
/// is none by those goes.
/// @returns the model by them
ForceFit ForceSearch::leave_out_outliers() {
  for (;;) {
    inliers_ = data_.without_outliers(model_.fit);
    if (model_.fit.terms.empty()) {
      return model_.fit;
    }
    ForceFit fit = inliers_->finished(model_.fit);
    const std::vector<double> half = inliers_->half_widths_of_sizes(fit);
    std::size_t place = 0;
    while (place < fit.terms.size() && inliers_->is_physical(fit, place) &&
           !inliers_->may_be_none(fit, place, half)) {
      ++place;
    }
    if (place == fit.terms.size()) {
      return inliers_->beside_output_noise(fit);
    }
    model_ = candidate_of(data_, data_.without(model_.fit, place));
    reduce();
    exchange(false);
  }
}

void ForceSearch::report(double share) const {
  if (options_.progress) {
    options_.progress(share);
  }
}

/// What was scatter to the nominal model may have a cause by the one that was found. What every
/// model would leave where the force changes fast is noise only once those are in it that act
/// there.
void ForceSearch::learn_covariance() {
  data_.learn_covariance(nominal_.fit, model_.fit, with_timing_);
  model_ = candidate_of(data_, model_.fit);
  nominal_ = model_.fit.terms.empty() ? model_ : by_own_scatter(nominal_.fit);
  for (Added& added : added_) {
    added.grown.reset();
  }
}

/// A model beside the scatter that itself leaves, or none where that leads it away.
ForceSearch::Candidate ForceSearch::by_own_scatter(const ForceFit& fit) const {
  ForceData data = data_;
  data.learn_covariance(nominal_.fit, fit, with_timing_);
  Candidate beside = candidate_of(data, fit);
  if (!is_led_away(data, beside.fit)) {
    return beside;
  }
  data.forget_scatter();
  return candidate_of(data, fit);
}

std::vector<ForceSearch::Candidate> ForceSearch::stairs() const {
  std::vector<Candidate> stairs{nominal_};
  bool all_so_far = true;
  for (const Added& added : added_) {
    const effects::ForceTerms& before = stairs.back().fit.terms;
    const bool stays =
        judged_.empty() || std::ranges::find(judged_, added.term, &Judged::term) != judged_.end();
    if (!stays || std::ranges::find(before, added.term) != before.end()) {
      all_so_far = false;
      continue;
    }
    if (all_so_far && added.grown) {
      stairs.push_back(*added.grown);
    } else {
      all_so_far = false;
      stairs.push_back(by_own_scatter(data_.with(stairs.back().fit, added.term, options_.threads)));
    }
  }
  if (judged_.empty()) {
    const auto least = std::ranges::min_element(
        stairs, {}, [&](const Candidate& one) { return data_.rmse_N(one.held.plain_N2); });
    stairs.erase(least + 1, stairs.end());
  }
  if (stairs.back().fit.terms == model_.fit.terms) {
    stairs.back() = model_;
  }
  return stairs;
}

/// Laws of effects of which none is taken, and no other that it cannot be beside.
std::vector<effects::ForceTerm> ForceSearch::beside(const effects::ForceTerms& taken) const {
  std::vector<effects::ForceTerm> terms;
  for (const effects::ForceTerm term : effects::kForceTerms) {
    const auto same = [&](effects::ForceTerm one) {
      return same_effect(one, term) || both_of(effects::ForceLaw::Of::time, one, term);
    };
    const bool wanted =
        std::ranges::find(options_.without, law_of(term).id()) == options_.without.end();
    if (wanted && !law_of(term).outside && is_shown(term, data_.records()) &&
        std::ranges::none_of(taken, same) && !parameters_of(term, data_.scales()).empty()) {
      terms.push_back(term);
    }
  }
  return terms;
}

/// The model with one of these more, those that start best and stay within physics, the least
/// squares first.
/// @param most_N2 that a term may start with
/// @param like a model to start near to, which is as good as to start best
std::vector<ForceSearch::Candidate> ForceSearch::with_each(
    const ForceFit& from, const std::vector<effects::ForceTerm>& terms, double most_N2,
    const ForceFit* like) const {
  constexpr std::size_t kFinished = 5;
  constexpr std::size_t kNearest = 2;
  const auto by_squares = [](const Candidate& one) { return one.fit.square_N2; };
  std::vector<Candidate> all;
  for (ForceFit& fit : data_.started(from, terms, options_.threads)) {
    if (fit.square_N2 <= most_N2) {
      all.push_back({std::move(fit), {}});
    }
  }
  std::ranges::sort(all, {}, by_squares);
  std::size_t kept = std::min(all.size(), kFinished);
  if (like != nullptr) {
    const std::size_t nearest = std::min(all.size() - kept, kNearest);
    std::ranges::partial_sort(
        all.begin() + static_cast<std::ptrdiff_t>(kept),
        all.begin() + static_cast<std::ptrdiff_t>(kept + nearest), all.end(), {},
        [&](const Candidate& one) { return data_.distance_N2(one.fit, *like); });
    kept += nearest;
  }
  all.resize(kept);
  statistics::parallel_for(
      all.size(), [&](std::size_t i) { all[i].fit = data_.finished(all[i].fit); },
      options_.threads);
  std::erase_if(all, [&](const Candidate& one) {
    return !data_.is_physical(one.fit, one.fit.terms.size() - 1);
  });
  std::ranges::sort(all, {}, by_squares);
  return all;
}

void ForceSearch::hold_out(std::vector<Candidate>& all) const {
  std::vector<ForceFit> fits;
  for (const Candidate& one : all) {
    fits.push_back(one.fit);
  }
  const auto seen = data_.fold_fits(fits, options_.threads);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].held = data_.held_out(all[i].fit, seen[i]);
  }
}

/// Adds the term of the least error on sessions that the fit never saw, of those that are seen
/// there, or two of which neither is without the other.
bool ForceSearch::grow() {
  constexpr std::size_t kTried = 4;
  std::vector<effects::ForceTerm> terms = beside(model_.fit.terms);
  const auto of_sessions = of_sessions_last(terms);
  std::vector<Candidate> all = with_each(model_.fit, {terms.begin(), of_sessions}, HUGE_VAL);
  all.resize(std::min(all.size(), kTried));
  hold_out(all);
  const auto unseen = std::stable_partition(all.begin(), all.end(), [&](const Candidate& one) {
    return is_seen_beside(model_.held, one);
  });
  const std::vector<Candidate> hidden(unseen, all.end());
  all.erase(unseen, all.end());
  auto best = std::ranges::min_element(
      all, {}, [&](const Candidate& one) { return data_.rmse_N(one.held.beside_scatter_N2); });
  if (all.empty()) {
    all = with_session_effects({of_sessions, terms.end()});
    best = std::ranges::max_element(all, {}, [&](const Candidate& one) {
      const effects::ForceTerm term = one.fit.terms.back();
      return evidence_of(term, paired_gain(data_, model_.held, one.held, true)) -
             cost_of(term, data_);
    });
  }
  if (best == all.end()) {
    return std::ranges::any_of(hidden, [&](const Candidate& one) { return grow_by_two(one); });
  }
  add(*first_law_as_good(all, best));
  return true;
}

/// Whether what was added last is.
bool ForceSearch::is_seen_beside(const HeldOut& before, const Candidate& grown) const {
  const effects::ForceTerm term = grown.fit.terms.back();
  return is_seen(term, gain_of(term, data_, before, grown.held));
}

void ForceSearch::add(Candidate grown) {
  model_ = std::move(grown);
  added_.push_back({model_.fit.terms.back(), model_});
}

/// Adds a term that takes much off and is not seen, as what it leaves scatters, together with one
/// beside which it is, and that is seen beside it: of those the one of the least error.
bool ForceSearch::grow_by_two(const Candidate& first) {
  constexpr std::size_t kTried = 3;
  constexpr double kMuch = 0.1;  // of the squared error
  const auto left_N2 = [&](const Candidate& one) {
    return std::pow(data_.rmse_N(one.held.beside_scatter_N2), 2);
  };
  if (first.fit.terms.size() == kMostForceTerms || left_N2(first) > (1 - kMuch) * left_N2(model_)) {
    return false;
  }
  std::vector<effects::ForceTerm> terms = beside(first.fit.terms);
  std::vector<Candidate> all =
      with_each(first.fit, {terms.begin(), of_sessions_last(terms)}, HUGE_VAL);
  all.resize(std::min(all.size(), kTried));
  hold_out(all);
  std::erase_if(all, [&](const Candidate& one) { return !is_seen_beside(first.held, one); });
  std::ranges::sort(all, {}, left_N2);
  for (Candidate& both : all) {
    const ForceFit second = data_.without(both.fit, first.fit.terms.size() - 1);
    const effects::ForceTerm term = first.fit.terms.back();
    if (is_seen(term, gain_of(term, data_, data_.held_out(second), both.held))) {
      add(first);
      add(std::move(both));
      return true;
    }
  }
  return false;
}

/// What sessions differ in is a part of what they scatter by until it is in the model: each such
/// effect is fitted as if nothing scattered, and asked beside what then does.
std::vector<ForceSearch::Candidate> ForceSearch::with_session_effects(
    std::span<const effects::ForceTerm> terms) const {
  std::vector<Candidate> all(terms.size());
  statistics::parallel_for(
      terms.size(),
      [&](std::size_t i) {
        const ForceFit started = data_.started(model_.fit, terms.subspan(i, 1), 1).front();
        ForceData data = data_;
        data.forget_scatter();
        const ForceFit even = data.finished(started);
        data.learn_covariance(nominal_.fit, even, with_timing_);
        const ForceFit with = data.fitted_anew(even);
        const ForceFit before = data.fitted_anew(model_.fit);
        if (data.is_physical(with, with.terms.size() - 1) &&
            is_seen(with.terms.back(),
                    paired_gain(data, data.held_out(before), data.held_out(with), true))) {
          all[i] = {with, data_.held_out(with)};
        }
      },
      options_.threads);
  std::erase_if(all, [](const Candidate& one) { return one.fit.terms.empty(); });
  return all;
}

/// Of laws of one effect the first one in the catalogue, unless another is seen to be better.
std::vector<ForceSearch::Candidate>::iterator ForceSearch::first_law_as_good(
    std::vector<Candidate>& all, std::vector<Candidate>::iterator best) const {
  auto first = best;
  for (auto one = all.begin(); one != all.end(); ++one) {
    const effects::ForceTerm term = one->fit.terms.back();
    if (term < first->fit.terms.back() && same_effect(term, best->fit.terms.back()) &&
        seen_as_better(term, paired_gain(data_, one->held, best->held, false)) < kSeen) {
      first = one;
    }
  }
  return first;
}

/// Judges each term, and takes out the one that matters least if it does not stay.
bool ForceSearch::prune() {
  judged_.assign(model_.fit.terms.size(), {});
  std::vector<Candidate> all(model_.fit.terms.size());
  statistics::parallel_for(
      all.size(), [&](std::size_t i) { all[i].fit = data_.without(model_.fit, i); },
      options_.threads);
  hold_out(all);
  left_ = structure_of(data_, bins_, model_.fit);
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < all.size(); ++i) {
    judged_[i] = {.term = model_.fit.terms[i],
                  .gain = gain_of(model_.fit.terms[i], data_, all[i].held, model_.held),
                  .without = all[i].fit,
                  .held_without = all[i].held};
  }
  const Judgement judgement = this->judgement();
  // One of two that are alike takes the place of the other, but not beyond its bounds.
  const auto by_what_is_lost = [&](std::size_t i) {
    const bool certain = probability_of(judged_[i].term, judged_[i].gain, data_) >= kNamed;
    return std::tuple(judgement.leaves_bounds(all[i].fit), certain, judged_[i].gain.mean);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!judgement.stays(i) && (!least || by_what_is_lost(i) < by_what_is_lost(*least))) {
      least = i;
    }
  }
  if (!least) {
    return false;
  }
  model_ = std::move(all[*least]);
  return true;
}

}  // namespace host_sim::diagnose
