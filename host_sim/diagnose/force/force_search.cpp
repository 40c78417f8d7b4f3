#include "host_sim/diagnose/force/force_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

/// Another could be in the place of an effect that is more likely by no more than that, in
/// logarithms of odds, or takes off no more than that beside it, of what is left and repeats.
constexpr double kOdds = 3;
constexpr double kAlike = 0.05;

/// One that leaves that of what the effect takes off is not asked on other sessions, nor fitted any
/// further where it starts with so much.
constexpr double kFarOff = 0.5;
constexpr double kHopeless = 0.9;

constexpr int kNominalIterations = 15;
constexpr int kAnew = 4;    ///< iterations on all samples from where the kept ones have led
constexpr int kRounds = 3;  ///< of terms that take the place of others

/// Of what a model leaves and is no noise: an effect that takes off less may imitate a part of
/// that. Friction of a tendon that pulls alone is nearly all in proportion to its force, and its
/// effects are more like each other: it takes more, but for one without which the error is a fifth
/// larger.
constexpr double kMaterialShare = 0.5;
constexpr double kMaterialShareAlone = 2;
constexpr double kLargeGain = 0.18;  ///< of ln rmse

/// Of what is left at all: without an effect that takes off that the error is 2.5 % larger.
constexpr double kLeastShare = 0.05;

/// The same of what sessions differ in and of when a channel is read: nothing else looks like that.
constexpr double kLeastShareApart = 0.003;

/// Of the noise that it takes off, as reading a channel between its samples does: so much is known
/// of how large that is.
constexpr double kOfNoiseTaken = 2;

/// Of what an effect takes off, by which its law and another law of friction beside it are not told
/// apart, nor two that shift whole sessions.
constexpr double kLawError = 0.02;

/// The same of any two laws, which are one force to that: 3 % of it.
constexpr double kSameForce = 0.001;

/// The same of a lag and a delay, of the input where all samples are compared: how a force turns
/// between those is known to neither. At the output the rate that a lag goes by has more noise than
/// the force besides.
constexpr double kInputTimeError = 0.01;
constexpr double kOutputTimeError = 0.05;

/// Least nearer_by() of two laws that are told apart: three times.
constexpr double kNearer = 1.1;

/// Of the squared error of sessions, plain as they are, which scatter: an effect may look worse by
/// that much, 2 % of the error.
constexpr double kNotWorse = 0.04;
constexpr double kWorse = 2;

constexpr double kPrior = 0.05;  ///< of an effect of the catalogue
constexpr double kMayBe = 0.5;   ///< probability of one that could be in the place of another

/// Of one that another method names, which sees more of what shifts whole sessions.
constexpr double kExcluded = 0.01;

bool is_of(ForceEffect::Of kind, ForceTerm term) {
  return definition_of(term).of == kind;
}

bool both_of(ForceEffect::Of kind, ForceTerm one, ForceTerm other) {
  return is_of(kind, one) && is_of(kind, other);
}

/// Logarithm of how many times nearer what is left is to one law than to the other, along what they
/// differ in: it lies between them where neither is the whole truth.
double nearer_by(const PairedGain& lost) {
  return std::log(std::max(std::abs(lost.slope), lost.error) /
                  std::max(std::abs(1 - lost.slope), lost.error));
}

/// Against a law that could be in the place of another: chance and the laws' own errors both count.
double log_odds_of(const PairedGain& lost) {
  const double most = std::min(std::abs(nearer_by(lost)), kOdds);
  return std::clamp(lost.log_odds, -most, most);
}

/// What the freedom of a term's parameters counts against it, as a logarithm of odds (Laplace).
double freedom_of(ForceTerm term, const ForceData& data) {
  double freedom = 0;
  for (const ForceParameter& parameter : parameters_of(term, data.scales())) {
    freedom += parameter.chosen ? std::log(static_cast<double>(parameter.starts.size()))
                                : std::log(static_cast<double>(data.records().size())) / 2;
  }
  return freedom;
}

/// Of what an effect takes off, what gain and friction that suit each session leave of it where it
/// moves them as wholes; an effect of what sessions differ in does by what it is.
constexpr double kShift = 0.05;
constexpr double kShiftOfSession = 0.2;

bool moves_sessions(const Judged& one) {
  const bool of_session = is_of(ForceEffect::Of::session, one.term);
  return one.gain.beside_scatter_N2 < (of_session ? kShiftOfSession : kShift) * one.gain.taken_N2;
}

}  // namespace

double probability_of(ForceTerm term, const PairedGain& gain, const ForceData& data) {
  const double log_odds =
      gain.z * gain.z / 2 + std::log(kPrior / (1 - kPrior)) - freedom_of(term, data);
  return gain.z > 0 && gain.any() ? 1 / (1 + std::exp(-log_odds)) : 0;
}

ForceSearch::ForceSearch(ForceData& data, std::span<const ForceRecord> records, double friction,
                         const DiagnoseOptions& options)
    : data_(data),
      records_(records),
      options_(options),
      covariates_(force_covariates(data.records())),
      nominal_{data.fit({}, {1, friction}, kNominalIterations), {}} {
  for (const ForceCovariate& covariate : covariates_) {
    bins_.emplace_back(data.records(), covariate);
  }
  nominal_.held = data.held_out(nominal_.fit);
  model_ = nominal_;
}

void ForceSearch::run() {
  constexpr double kOfGrowing = 0.3;
  constexpr double kOfPruning = 0.1;
  report(0);
  for (int round = 0; round < 2; ++round) {
    if (round == 0 || !settle()) {
      learn_covariance(round > 0);
    }
    while (model_.fit.terms.size() < kMostForceTerms && grow()) {
    }
    report(kOfGrowing * (round + 1));
  }
  for (int round = 0; round < kRounds; ++round) {
    while (prune() || settle()) {
    }
    report(2 * kOfGrowing + kOfPruning * (round + 1));
    if (!exchange(round + 1 < kRounds)) {
      break;
    }
  }
  leave_out_outliers();
}

/// Settles how sharp friction turns over where the model is another one, as what came or went may
/// have stood for that.
/// @returns whether it does otherwise
bool ForceSearch::settle() {
  const bool other = !model_.fit.terms.empty() && model_.fit.terms != settled_by_ &&
                     data_.settle_turn_over(model_.fit);
  settled_by_ = model_.fit.terms;
  if (other) {
    learn_covariance(true);
  }
  return other;
}

/// The model is settled: its parameters are those that outliers have no part in.
void ForceSearch::leave_out_outliers() {
  inliers_ = data_.without_outliers(model_.fit);
  if (!model_.fit.terms.empty()) {
    model_.fit = inliers_->finished(model_.fit);
    model_.held = data_.held_out(inliers_->fold_fits(model_.fit));
  }
}

bool ForceSearch::sees(std::string_view effect) const {
  const auto has_id = [&](ForceTerm term) { return definition_of(term).id == effect; };
  for (const Judged& one : judged_) {
    if (has_id(one.term) || std::ranges::any_of(one.others, has_id, &Judged::Other::term)) {
      return true;
    }
  }
  const std::vector<ForceTerm> shown = beside(model_.fit.terms);
  const ForceData& fitted_to = model_.fit.terms.empty() ? data_ : *inliers_;
  for (const ForceTerm law : kForceTerms) {
    if (!has_id(law)) {
      continue;
    }
    if (std::ranges::find(shown, law) == shown.end()) {
      return true;
    }
    const ForceFit fit = fitted_to.with(model_.fit, law, options_.threads);
    const HeldOut held = data_.held_out(fitted_to.fold_fits(fit));
    if (probability_of(law, data_.gain_of(model_.held, held, true), data_) >= kExcluded) {
      return true;
    }
  }
  return false;
}

void ForceSearch::report(double share) const {
  if (options_.progress) {
    options_.progress(share);
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
      Candidate next{data_.with(stairs.back().fit, added.term, options_.threads), {}};
      next.held = data_.held_out(next.fit);
      stairs.push_back(std::move(next));
    }
  }
  if (judged_.empty()) {
    const auto least = std::ranges::min_element(
        stairs, {}, [&](const Candidate& one) { return data_.rmse_N(one.held.plain_N2); });
    stairs.erase(least + 1, stairs.end());
  }
  return stairs;
}

/// Laws of effects of which none is taken, and no other that it cannot be beside.
std::vector<ForceTerm> ForceSearch::beside(const ForceTerms& taken) const {
  std::vector<ForceTerm> terms;
  for (const ForceTerm term : kForceTerms) {
    const auto same = [&](ForceTerm one) {
      return definition_of(one).id == definition_of(term).id ||
             both_of(ForceEffect::Of::time, one, term);
    };
    const bool wanted =
        std::ranges::find(options_.without, definition_of(term).id) == options_.without.end();
    if (wanted && !definition_of(term).outside && is_shown(term, data_.records()) &&
        std::ranges::none_of(taken, same) && !parameters_of(term, data_.scales()).empty()) {
      terms.push_back(term);
    }
  }
  return terms;
}

/// The model with one of these more, those that start best and stay within physics, the least
/// squares first.
/// @param most_N2 that a term may start with
std::vector<ForceSearch::Candidate> ForceSearch::with_each(const ForceFit& from,
                                                           const std::vector<ForceTerm>& terms,
                                                           double most_N2) const {
  constexpr std::size_t kFinished = 5;
  const auto by_squares = [](const Candidate& one) { return one.fit.square_N2; };
  std::vector<Candidate> all;
  for (ForceFit& fit : data_.started(from, terms, options_.threads)) {
    if (fit.square_N2 <= most_N2) {
      all.push_back({std::move(fit), {}});
    }
  }
  std::ranges::sort(all, {}, by_squares);
  all.resize(std::min(all.size(), kFinished));
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
  const auto folds = static_cast<std::size_t>(data_.folds());
  std::vector<std::vector<ForceFit>> seen(all.size(), std::vector<ForceFit>(folds));
  statistics::parallel_for(
      all.size() * folds,
      [&](std::size_t i) {
        seen[i / folds][i % folds] =
            data_.fold_fit(all[i / folds].fit, static_cast<int>(i % folds));
      },
      options_.threads);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].held = data_.held_out(seen[i]);
  }
}

/// Adds the term of the least error on sessions that the fit never saw, of those that are seen
/// there.
bool ForceSearch::grow() {
  constexpr std::size_t kTried = 4;
  std::vector<Candidate> all = with_each(model_.fit, beside(model_.fit.terms), HUGE_VAL);
  all.resize(std::min(all.size(), kTried));
  hold_out(all);
  std::erase_if(all, [&](const Candidate& one) {
    const PairedGain gain = data_.gain_of(model_.held, one.held, true);
    return gain.z < kSeen || !gain.any();
  });
  const auto best = std::ranges::min_element(
      all, {}, [&](const Candidate& one) { return data_.rmse_N(one.held.beside_scatter_N2); });
  if (best == all.end()) {
    return false;
  }
  model_ = std::move(*first_law_as_good(all, best));
  added_.push_back({model_.fit.terms.back(), model_});
  return true;
}

/// Of laws of one effect the first one in the catalogue, unless another is seen to be better.
std::vector<ForceSearch::Candidate>::iterator ForceSearch::first_law_as_good(
    std::vector<Candidate>& all, std::vector<Candidate>::iterator best) const {
  auto first = best;
  for (auto one = all.begin(); one != all.end(); ++one) {
    const ForceTerm term = one->fit.terms.back();
    if (term < first->fit.terms.back() &&
        definition_of(term).id == definition_of(best->fit.terms.back()).id &&
        data_.gain_of(one->held, best->held, false).z < kSeen) {
      first = one;
    }
  }
  return first;
}

double ForceSearch::not_worse_N2() const {
  return kNotWorse * rmse_N() * rmse_N();
}

/// Whether a term is certain, material, within the bounds of physics and more than samples resolve.
bool ForceSearch::stays(std::size_t place) const {
  const Judged& one = judged_[place];
  const bool told_apart = std::ranges::all_of(judged_, [&](const Judged& other) {
    return !both_of(ForceEffect::Of::friction, one.term, other.term) ||
           one.gain.beside_scatter_N2 >= kLawError * other.gain.beside_scatter_N2 ||
           (moves_sessions(one) && one.gain.taken_N2 >= kLawError * other.gain.taken_N2);
  });
  // Beside the scatter of sessions, or as it is where it is of what they differ in, or that scatter
  // takes up nearly all of it: what shifts whole sessions.
  const HeldOut& held = model_.held;
  const bool large = !data_.records().front().pulls_alone || one.gain.mean >= kLargeGain;
  const double share = large ? kMaterialShare : kMaterialShareAlone;
  const bool of_session = is_of(ForceEffect::Of::session, one.term);
  const bool of_time = is_of(ForceEffect::Of::time, one.term);
  const double least = of_session || of_time ? kLeastShareApart : kLeastShare;
  const double of_noise_N2 =
      of_time ? kOfNoiseTaken * data_.noise_taken_N2(one.without, model_.fit) : 0;
  const auto material = [&](double taken_N2, std::span<const double> all_N2, double left_N2) {
    return taken_N2 >=
           std::max({least * std::pow(data_.rmse_N(all_N2), 2), of_noise_N2, share * left_N2});
  };
  return told_apart && data_.is_physical(model_.fit, place) &&
         one.gain.plain_N2 > -not_worse_N2() - kWorse * one.gain.plain_error_N2 &&
         (((moves_sessions(one) || of_session) &&
           material(one.gain.taken_N2, held.weighted_N2, left_.repeats_N2)) ||
          material(one.gain.beside_scatter_N2, held.beside_scatter_N2, left_.beside_scatter_N2)) &&
         probability_of(one.term, one.gain, data_) >= kNamed;
}

/// Whether a term is beyond its bounds that is within them in the model.
bool ForceSearch::leaves_bounds(const ForceFit& fit) const {
  for (std::size_t i = 0; i < fit.terms.size(); ++i) {
    const auto same = std::ranges::find(model_.fit.terms, fit.terms[i]);
    if (!data_.is_physical(fit, i) &&
        data_.is_physical(model_.fit, static_cast<std::size_t>(same - model_.fit.terms.begin()))) {
      return true;
    }
  }
  return false;
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
                  .gain = data_.gain_of(all[i].held, model_.held, true),
                  .without = all[i].fit,
                  .held_without = all[i].held};
  }
  // One of two that are alike takes the place of the other, but not beyond its bounds.
  const auto by_what_is_lost = [&](std::size_t i) {
    const bool certain = probability_of(judged_[i].term, judged_[i].gain, data_) >= kNamed;
    return std::tuple(leaves_bounds(all[i].fit), certain, judged_[i].gain.mean);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!stays(i) && (!least || by_what_is_lost(i) < by_what_is_lost(*least))) {
      least = i;
    }
  }
  if (!least) {
    return false;
  }
  model_ = std::move(all[*least]);
  return true;
}

/// Whether what is lost by another term in the place of one is too little to say anything: beside
/// the scatter of sessions, or as it is where the term shifts whole sessions.
bool ForceSearch::alike(const Judged& one, const PairedGain& lost) const {
  return moves_sessions(one)
             ? lost.taken_N2 < std::max(kAlike * left_.repeats_N2, kLawError * one.gain.taken_N2)
             : lost.beside_scatter_N2 < std::max(kAlike * left_.beside_scatter_N2,
                                                 kSameForce * one.gain.beside_scatter_N2);
}

/// What is lost by another model, which differs from this one between the samples that are kept.
PairedGain ForceSearch::lost_as_sampled(const ForceFit& other) const {
  const ForceData all =
      data_.as_sampled({records_.begin(), records_.end()}, nominal_.fit, model_.fit);
  const std::array<const ForceFit*, 2> models{&other, &model_.fit};
  std::array<HeldOut, 2> held;
  statistics::parallel_for(
      models.size(),
      [&](std::size_t i) {
        held[i] = all.held_out(all.fit(models[i]->terms, models[i]->parameters, kAnew));
      },
      options_.threads);
  return all.gain_of(held[0], held[1], false);
}

/// What is lost by a lag in the place of a delay or the other way about: nothing is known of that
/// before they are seen to differ.
PairedGain ForceSearch::lost_in_time(const Judged& one, const Candidate& other) const {
  const auto is_of_input = [&](const ForceFit& fit, ForceTerm term) {
    const auto place = std::ranges::find(fit.terms, term) - fit.terms.begin();
    return parameters_at(static_cast<std::size_t>(place), fit.terms, fit.parameters, data_.scales())
               .front() < 0;
  };
  const bool of_input =
      is_of_input(model_.fit, one.term) && is_of_input(other.fit, other.fit.terms.back());
  const PairedGain lost =
      of_input ? lost_as_sampled(other.fit) : data_.gain_of(other.held, model_.held, false);
  const double least_N2 =
      (of_input ? kInputTimeError : kOutputTimeError) * one.gain.beside_scatter_N2;
  return std::abs(lost.beside_scatter_N2) < least_N2 ? PairedGain{.slope = kEvenSlope} : lost;
}

/// What is no effect of the catalogue takes no place, but may be as likely as one that has it.
void ForceSearch::beside_catalogue(ForceTerm imitated_by, double log_odds, Judged& one) {
  const double share = 1 / (1 + std::exp(-log_odds));
  if (log_odds < kOdds && share < one.share) {
    one.share = share;
    one.imitated_by = imitated_by;
  }
}

/// Finds what could stand in the place of each term. Where that does better it takes the place,
/// as long as that is allowed, and all are judged anew.
bool ForceSearch::exchange(bool allowed) {
  for (std::size_t place = 0; place < judged_.size(); ++place) {
    for (Candidate& one : in_place_of(place)) {
      const ForceTerm term = judged_[place].term;
      const ForceTerm other = one.fit.terms.back();
      const PairedGain lost = both_of(ForceEffect::Of::time, term, other)
                                  ? lost_in_time(judged_[place], one)
                                  : data_.gain_of(one.held, model_.held, false);
      if (judged_[place].gain.plain_N2 - lost.plain_N2 < -not_worse_N2()) {
        continue;  // worse than none
      }
      const PairedGain own = data_.gain_of(judged_[place].held_without, one.held, true);
      if (probability_of(other, own, data_) < kMayBe) {
        continue;  // not there by itself
      }
      if (definition_of(other).outside) {
        beside_catalogue(other, lost.log_odds, judged_[place]);
        continue;
      }
      const bool other_law = definition_of(other).id == definition_of(term).id;
      if (allowed && lost.log_odds < -kOdds && (!other_law || lost.z < -kSeen)) {
        added_.push_back({other, std::nullopt});
        model_ = std::move(one);
        return true;
      }
      const bool even = alike(judged_[place], lost);
      const bool between = !moves_sessions(judged_[place]) && nearer_by(lost) < kNearer;
      if (!other_law && (even || between || lost.log_odds < kOdds)) {
        judged_[place].others.push_back(
            {other,
             (even ? 0 : log_odds_of(lost)) + freedom_of(other, data_) - freedom_of(term, data_)});
      }
    }
  }
  return false;
}

/// The model with another term in the place of one, where it fits nearly as well or better.
std::vector<ForceSearch::Candidate> ForceSearch::in_place_of(std::size_t place) const {
  std::vector<ForceTerm> others = beside(judged_[place].without.terms);
  std::erase(others, judged_[place].term);
  for (const ForceTerm term : kForceTerms) {
    if (definition_of(term).outside && is_shown(term, data_.records())) {
      others.push_back(term);
    }
  }
  const double taken_N2 = judged_[place].without.square_N2 - model_.fit.square_N2;
  std::vector<Candidate> all =
      with_each(judged_[place].without, others, model_.fit.square_N2 + kHopeless * taken_N2);
  std::erase_if(all, [&](const Candidate& one) {
    return one.fit.square_N2 - model_.fit.square_N2 > kFarOff * taken_N2;
  });
  hold_out(all);
  return all;
}

}  // namespace host_sim::diagnose
