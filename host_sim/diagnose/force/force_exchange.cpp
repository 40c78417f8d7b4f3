#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "host_sim/diagnose/force/force_search.hpp"
#include "host_sim/diagnose/force/late_output.hpp"
#include "host_sim/statistics/parallel.hpp"

/// What could stand in the place of an effect that was found.
namespace host_sim::diagnose {
namespace {

/// One that leaves that of what the effect takes off is not asked on other sessions, nor fitted any
/// further where it starts with so much.
constexpr double kFarOff = 0.5;
constexpr double kHopeless = 0.9;

}  // namespace

/// What is lost by another model, which differs from this one between the samples that are kept.
PairedGain ForceSearch::lost_as_sampled(const ForceFit& other) const {
  const ForceData all = as_sampled();
  const std::array<const ForceFit*, 2> models{&other, &model_.fit};
  std::array<HeldOut, 2> held;
  statistics::parallel_for(
      models.size(), [&](std::size_t i) { held[i] = all.held_out(all.fitted_anew(*models[i])); },
      options_.threads);
  return paired_gain(all, held[0], held[1], false);
}

/// What is lost by a lag in the place of a delay, or the other way about: nothing is known of that
/// where either is too short beside the time between samples.
PairedGain ForceSearch::lost_in_time(const Judged& one, const Candidate& other) const {
  constexpr double kOfStep = 0.1;
  const auto late_s = [&](const ForceFit& fit, effects::ForceTerm term) {
    const auto place = std::ranges::find(fit.terms, term) - fit.terms.begin();
    return parameters_at(static_cast<std::size_t>(place), fit.terms, fit.parameters, data_.scales())
        .front();
  };
  const double one_s = late_s(model_.fit, one.term);
  const double other_s = late_s(other.fit, other.fit.terms.back());
  if (std::min(std::abs(one_s), std::abs(other_s)) < kOfStep * records_.front().step_s()) {
    return PairedGain{.slope = kEvenSlope};
  }
  if (one_s < 0 && other_s < 0) {
    return Judgement::late_input(one, lost_as_sampled(other.fit));
  }
  if (one_s < 0 || other_s < 0) {
    return paired_gain(data_, other.held, model_.held, false);
  }
  const ForceFit& lagging = one.term == effects::ForceTerm::lag ? model_.fit : other.fit;
  return Judgement::late_output(one, late_output(as_sampled(), records_, lagging));
}

/// Finds what could stand in the place of each term. Where that does better it takes the place,
/// as long as that is allowed, and all are judged anew.
bool ForceSearch::exchange(bool allowed) {
  const Judgement judgement = this->judgement();
  for (std::size_t place = 0; place < judged_.size(); ++place) {
    Judged& judged = judged_[place];
    for (Candidate& one : in_place_of(place)) {
      const effects::ForceTerm other = one.fit.terms.back();
      const PairedGain lost = both_of(effects::ForceLaw::Of::time, judged.term, other)
                                  ? lost_in_time(judged, one)
                                  : paired_gain(data_, one.held, model_.held, false);
      if (judgement.is_worse_than_none(judged, lost) ||
          !may_be(other, gain_of(other, data_, judged.held_without, one.held), data_)) {
        continue;
      }
      if (law_of(other).outside) {
        judgement.beside_catalogue(other, lost, judged);
        continue;
      }
      const Rival rival = judgement.rival(judged, one.fit, lost);
      if (allowed && Judgement::takes_place(judged, rival)) {
        added_.push_back({other, std::nullopt});
        model_ = std::move(one);
        return true;
      }
      if (const auto log_odds = judgement.log_odds_of(judged, rival)) {
        judged.others.push_back({other, *log_odds});
      }
    }
  }
  return false;
}

/// The model with a delay in the place of a lag, or the other way about, from as late on: noise of
/// the output, which those do not pass on alike, would lead other starts elsewhere.
ForceFit ForceSearch::as_late(std::size_t place, effects::ForceTerm otherwise) const {
  ForceFit other = judged_[place].without;
  other.terms.push_back(otherwise);
  other.parameters.push_back(
      parameters_at(place, model_.fit.terms, model_.fit.parameters, data_.scales()).front());
  return data_.finished(other);
}

/// The model with another term in the place of one, where it fits nearly as well or better.
std::vector<ForceSearch::Candidate> ForceSearch::in_place_of(std::size_t place) const {
  std::vector<effects::ForceTerm> others = beside(judged_[place].without.terms);
  std::erase(others, judged_[place].term);
  for (const effects::ForceTerm term : effects::kForceTerms) {
    if (law_of(term).outside && is_shown(term, data_.records()) &&
        !depends_on_the_same(judged_[place].term, term)) {
      others.push_back(term);
    }
  }
  const auto timed =
      std::stable_partition(others.begin(), others.end(), [&](effects::ForceTerm other) {
        return !both_of(effects::ForceLaw::Of::time, judged_[place].term, other);
      });
  const std::vector<effects::ForceTerm> late(timed, others.end());
  others.erase(timed, others.end());
  const double taken_N2 = judged_[place].without.square_N2 - model_.fit.square_N2;
  std::vector<Candidate> all = with_each(judged_[place].without, others,
                                         model_.fit.square_N2 + kHopeless * taken_N2, &model_.fit);
  for (const effects::ForceTerm other : late) {
    all.push_back({as_late(place, other), {}});
  }
  std::erase_if(all, [&](const Candidate& one) {
    return one.fit.square_N2 - model_.fit.square_N2 > kFarOff * taken_N2;
  });
  hold_out(all);
  return all;
}

}  // namespace host_sim::diagnose
