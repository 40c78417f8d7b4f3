#include "host_sim/diagnose/force/force_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kStandsIn = 0.05;  ///< of ln rmse, for another in the place of an effect
constexpr int kNominalIterations = 15;
constexpr int kRounds = 3;  ///< of terms that take the place of others

}  // namespace

ForceSearch::ForceSearch(ForceData& data, double friction, std::vector<std::string> without,
                         unsigned threads)
    : data_(data),
      without_(std::move(without)),
      threads_(threads),
      nominal_{data.fit({}, {1, friction}, kNominalIterations), {}} {
  nominal_.held = data.held_out(nominal_.fit);
  model_ = nominal_;
}

void ForceSearch::run() {
  for (int round = 0; round < 2; ++round) {
    learn_covariance(round > 0);
    while (model_.fit.terms.size() < kMostForceTerms && grow()) {
    }
  }
  for (int round = 0; round < kRounds; ++round) {
    while (prune()) {
    }
    if (!exchange(round + 1 < kRounds)) {
      break;
    }
  }
}

/// What was scatter to the nominal model may have a cause by the one that was found. What every
/// model would leave where the force changes fast is noise only once those are in it that act
/// there.
void ForceSearch::learn_covariance(bool with_timing) {
  data_.learn_covariance(nominal_.fit, model_.fit, with_timing);
  for (Candidate* const one : {&nominal_, &model_}) {
    one->fit = data_.fit(one->fit.terms, one->fit.parameters, kNominalIterations);
    one->held = data_.held_out(one->fit);
  }
  for (Added& added : added_) {
    added.grown.reset();
  }
}

std::vector<ForceSearch::Candidate> ForceSearch::stairs() const {
  std::vector<Candidate> stairs{nominal_};
  bool all_so_far = true;
  for (const Added& added : added_) {
    const ForceTerms& before = stairs.back().fit.terms;
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
      Candidate next{
          data_.finished(
              data_.started(stairs.back().fit, std::span(&added.term, 1), threads_).front()),
          {}};
      next.held = data_.held_out(next.fit);
      stairs.push_back(std::move(next));
    }
  }
  return stairs;
}

/// Laws of effects of which none is taken, and no other that it cannot be beside.
std::vector<ForceTerm> ForceSearch::outside(const ForceTerms& taken) const {
  std::vector<ForceTerm> terms;
  for (unsigned i = 0; i < kForceTermCount; ++i) {
    const auto term = static_cast<ForceTerm>(i);
    const auto same = [&](ForceTerm one) {
      return definition_of(one).id == definition_of(term).id ||
             (definition_of(one).in_time && definition_of(term).in_time);
    };
    const bool wanted = std::ranges::find(without_, definition_of(term).id) == without_.end();
    if (wanted && is_shown(term, data_.records()) && std::ranges::none_of(taken, same) &&
        !parameters_of(term, data_.scales()).empty()) {
      terms.push_back(term);
    }
  }
  return terms;
}

/// The model with one of these more, those that start best, the least squares first.
std::vector<ForceSearch::Candidate> ForceSearch::with_each(
    const ForceFit& from, const std::vector<ForceTerm>& terms) const {
  constexpr std::size_t kFinished = 5;
  const auto by_squares = [](const Candidate& one) { return one.fit.square_N2; };
  std::vector<Candidate> all;
  for (ForceFit& fit : data_.started(from, terms, threads_)) {
    all.push_back({std::move(fit), {}});
  }
  std::ranges::sort(all, {}, by_squares);
  all.resize(std::min(all.size(), kFinished));
  statistics::parallel_for(
      all.size(), [&](std::size_t i) { all[i].fit = data_.finished(all[i].fit); }, threads_);
  std::ranges::sort(all, {}, by_squares);
  return all;
}

void ForceSearch::hold_out(std::vector<Candidate>& all) const {
  const auto folds = static_cast<std::size_t>(data_.folds());
  std::vector<std::vector<ForceFit>> seen(all.size(), std::vector<ForceFit>(folds));
  statistics::parallel_for(
      all.size() * folds,
      [&](std::size_t i) {
        seen[i / folds][i % folds] =
            data_.fold_fit(all[i / folds].fit, static_cast<int>(i % folds));
      },
      threads_);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].held = data_.held_out(seen[i]);
  }
}

/// Adds the term of the least error on sessions that the fit never saw, if it is worth it.
bool ForceSearch::grow() {
  constexpr std::size_t kTried = 3;
  std::vector<Candidate> all = with_each(model_.fit, outside(model_.fit.terms));
  all.resize(std::min(all.size(), kTried));
  hold_out(all);
  const auto best = std::ranges::min_element(
      all, {}, [&](const Candidate& one) { return data_.rmse_N(one.held.beside_scatter_N2); });
  if (best == all.end() || data_.gain_of(model_.held, best->held).z < kSeen ||
      std::log(data_.rmse_N(model_.held.beside_scatter_N2) /
               data_.rmse_N(best->held.beside_scatter_N2)) < kWorthTrying) {
    return false;
  }
  model_ = std::move(*best);
  added_.push_back({model_.fit.terms.back(), model_});
  return true;
}

/// Judges each term, and takes out the one that matters least if it does not stay.
bool ForceSearch::prune() {
  judged_.assign(model_.fit.terms.size(), {});
  std::vector<Candidate> all(model_.fit.terms.size());
  statistics::parallel_for(
      all.size(), [&](std::size_t i) { all[i].fit = data_.without(model_.fit, i); }, threads_);
  hold_out(all);
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < all.size(); ++i) {
    judged_[i] = {.term = model_.fit.terms[i],
                  .gain = data_.gain_of(all[i].held, model_.held),
                  .without = all[i].fit,
                  .others = {}};
    if (!(judged_[i].stays() && !data_.at_bound(model_.fit, i)) &&
        (!least || judged_[i].gain.mean < judged_[*least].gain.mean)) {
      least = i;
    }
  }
  if (!least) {
    return false;
  }
  model_ = std::move(all[*least]);
  return true;
}

/// Finds what could stand in the place of each term. Where that does better it takes the place,
/// as long as that is allowed, and all are judged anew.
bool ForceSearch::exchange(bool allowed) {
  for (std::size_t place = 0; place < judged_.size(); ++place) {
    for (Candidate& one : in_place_of(place)) {
      const PairedGain lost = data_.gain_of(one.held, model_.held);
      if (allowed && lost.mean < -kWorthTrying && lost.z < -kSeen) {
        added_.push_back({one.fit.terms.back(), std::nullopt});
        model_ = std::move(one);
        return true;
      }
      const bool other_effect =
          definition_of(one.fit.terms.back()).id != definition_of(judged_[place].term).id;
      if (other_effect && (lost.mean < kStandsIn || lost.z < kSeen)) {
        judged_[place].others.push_back(one.fit.terms.back());
      }
    }
  }
  return false;
}

/// The model with another term in the place of one, where it fits nearly as well or better.
std::vector<ForceSearch::Candidate> ForceSearch::in_place_of(std::size_t place) const {
  std::vector<ForceTerm> others = outside(judged_[place].without.terms);
  std::erase(others, judged_[place].term);
  std::vector<Candidate> all = with_each(judged_[place].without, others);
  std::erase_if(all, [&](const Candidate& one) {
    return std::log(one.fit.square_N2 / model_.fit.square_N2) / 2 > 2 * kStandsIn;
  });
  hold_out(all);
  return all;
}

}  // namespace host_sim::diagnose
