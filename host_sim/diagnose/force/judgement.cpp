#include "host_sim/diagnose/force/judgement.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/session_drift.hpp"

namespace host_sim::diagnose {
namespace {

/// Another could be in the place of an effect that is more likely by no more than that, in
/// logarithms of odds, or takes off no more than that beside it, of what is left and repeats.
constexpr double kOdds = 3;
constexpr double kAlike = 0.05;

/// Of what a model leaves and is no noise: an effect that takes off less may imitate a part of
/// that. Friction of a tendon that pulls alone is nearly all in proportion to its force, and its
/// effects, and those of when a channel is read, are more like each other: it takes more, but for
/// one without which the error is a fifth larger. What sensors show, or sessions differ in, is less
/// like the others.
constexpr double kMaterialShare = 0.5;
constexpr double kMaterialShareAlone = 2;
constexpr double kOfMaterialShareApart = 0.5;
constexpr double kLargeGain = 0.18;  ///< of ln rmse

/// Of what is left at all: without an effect that takes off that the error is 2.5 % larger.
constexpr double kLeastShare = 0.05;

/// The same of what sessions differ in, of when a channel is read, and of a sensor that shifts
/// whole sessions by no small part of what others do: nothing else looks like that.
constexpr double kLeastShareApart = 0.003;

/// Of the noise that it takes off, as reading a channel between its samples does: so much is known
/// of how large that is.
constexpr double kOfNoiseTaken = 2;

/// Of what an effect takes off, by which its law and another law of friction beside it are not told
/// apart, nor two that shift whole sessions; but for one that takes off so many times what is left
/// with it, as no error of another law would go away whole.
constexpr double kLawError = 0.02;
constexpr double kAll = 10;

/// The same of any two laws, which are one force to that: 3 % of it.
constexpr double kSameForce = 0.001;

/// The same of a lag and a delay of the input, where all samples are compared: how a force turns
/// between those is known to neither.
constexpr double kInputTimeError = 0.01;

/// Of LateOutput, which is 0 or 1: what the next terms of its series may add, and the standard
/// error above which samples do not show it.
constexpr double kLateOutputError = 0.1;
constexpr double kMostLateOutputError = 0.3;

/// Least nearer_by() of two laws that are told apart: three times.
constexpr double kNearer = 1.1;

/// Of the squared error of sessions, plain as they are, which scatter: an effect may look worse by
/// that much, 2 % of the error, and by so many standard errors.
constexpr double kNotWorse = 0.04;
constexpr double kWorse = 2;

/// The same however few sessions know it: one beside which the error is 5 % larger is no gain.
constexpr double kMostWorse = 0.1;

constexpr double kPrior = 0.05;  ///< of an effect of the catalogue
constexpr double kMayBe = 0.5;   ///< probability of one that could be in the place of another
constexpr double kLikely = 0.8;  ///< of one that stays, though it may not be named

/// Logarithm of how many times nearer what is left is to one law than to the other, along what they
/// differ in: it lies between them where neither is the whole truth.
double nearer_by(const PairedGain& lost) {
  return std::log(std::max(std::abs(lost.slope), lost.error) /
                  std::max(std::abs(1 - lost.slope), lost.error));
}

/// Of what an effect takes off, what gain and friction that suit each session leave of it where it
/// moves them as wholes; an effect of what sessions differ in does by what it is.
constexpr double kShift = 0.05;
constexpr double kShiftOfSession = 0.2;

/// What an effect takes off: of what sessions differ in what it moves them by, as their scatter is
/// left with it and hides what is taken off.
double taken_N2(const Judged& one) {
  return is_of(effects::ForceLaw::Of::session, one.term)
             ? std::max(one.gain.taken_N2, one.gain.moved_N2)
             : one.gain.taken_N2;
}

bool moves_sessions(const Judged& one) {
  const bool of_session = is_of(effects::ForceLaw::Of::session, one.term);
  return one.gain.beside_scatter_N2 < (of_session ? kShiftOfSession : kShift) * taken_N2(one);
}

/// Whether models differ in what gain and friction of each session take up, nearly all.
bool is_shift(const PairedGain& gain) {
  return gain.within_N2 < kShift * gain.moved_N2;
}

/// What is left within sessions of what shifts them as wholes is little, and another law may leave
/// as much: it counts where it is surely there, and as large as the shift says.
constexpr double kClear = 4;

bool shows_within(const PairedGain& gain) {
  return gain.z_within >= kClear && std::abs(gain.slope_within - 1) < kSeen * gain.error_within;
}

/// Whether one is what a sensor shows and the other what sessions differ in, and they differ in
/// what they do to whole sessions alone.
bool both_shift(const Judged& one, effects::ForceTerm other, const PairedGain& lost) {
  using enum effects::ForceLaw::Of;
  return moves_sessions(one) && is_shift(lost) &&
         ((is_of(sensor, one.term) && is_of(session, other)) ||
          (is_of(session, one.term) && is_of(sensor, other)));
}

}  // namespace

bool is_of(effects::ForceLaw::Of kind, effects::ForceTerm term) {
  return law_of(term).of == kind;
}

bool both_of(effects::ForceLaw::Of kind, effects::ForceTerm one, effects::ForceTerm other) {
  return is_of(kind, one) && is_of(kind, other);
}

bool same_effect(effects::ForceTerm one, effects::ForceTerm other) {
  return law_of(one).id() == law_of(other).id();
}

bool depends_on_the_same(effects::ForceTerm one, effects::ForceTerm other) {
  return law_of(one).by != effects::ForceLaw::By::nothing && law_of(one).by == law_of(other).by;
}

PairedGain gain_of(effects::ForceTerm term, const ForceData& data, const HeldOut& without,
                   const HeldOut& with) {
  PairedGain gain = paired_gain(data, without, with, true);
  if (is_of(effects::ForceLaw::Of::time, term)) {
    const PairedGain away =
        paired_gain(data, data.away_from_turns(without), data.away_from_turns(with), true);
    gain.z = std::min(gain.z, away.z);
  }
  return gain;
}

double evidence_of(effects::ForceTerm term, const PairedGain& gain) {
  const auto half_square = [](double z) { return z > 0 ? z * z / 2 : 0; };
  const bool shift = is_shift(gain);
  if (is_of(effects::ForceLaw::Of::session, term)) {
    return gain.of_sessions + (!shift || shows_within(gain) ? half_square(gain.z_within) : 0);
  }
  return std::max(half_square(gain.z), shift && gain.z >= kSeen ? gain.of_sessions : 0);
}

double seen_as_better(effects::ForceTerm term, const PairedGain& gain) {
  return is_of(effects::ForceLaw::Of::session, term)
             ? std::copysign(std::sqrt(2 * std::abs(gain.of_sessions)), gain.of_sessions)
             : gain.z;
}

double cost_of(effects::ForceTerm term, const ForceData& data) {
  double cost = 0;
  for (const effects::ForceParameter& parameter : parameters_of(term, data.scales())) {
    cost += parameter.chosen ? std::log(static_cast<double>(parameter.starts.size()))
                             : std::log(static_cast<double>(data.records().size())) / 2;
  }
  return cost;
}

double probability_of(effects::ForceTerm term, const PairedGain& gain, const ForceData& data) {
  const double evidence = evidence_of(term, gain);
  const double log_odds = evidence + std::log(kPrior / (1 - kPrior)) - cost_of(term, data);
  return evidence > 0 && gain.any() ? 1 / (1 + std::exp(-log_odds)) : 0;
}

double unseen_probability(double sigmas) {
  const double odds = kPrior / (1 - kPrior) / std::hypot(1, sigmas);
  return odds / (1 + odds);
}

bool may_be(effects::ForceTerm term, const PairedGain& gain, const ForceData& data) {
  return probability_of(term, gain, data) >= kMayBe;
}

bool within_scatter(const PairedGain& gain, double allowed_N2) {
  return gain.plain_N2 > -allowed_N2 - kWorse * gain.plain_error_N2;
}

bool Judgement::stays(std::size_t place) const {
  const Judged& one = judged_[place];
  const bool told_apart =
      one.gain.beside_scatter_N2 >= kAll * left_.beside_scatter_N2 ||
      std::ranges::all_of(judged_, [&](const Judged& other) {
        return !both_of(effects::ForceLaw::Of::friction, one.term, other.term) ||
               one.gain.beside_scatter_N2 >= kLawError * other.gain.beside_scatter_N2 ||
               (moves_sessions(one) && taken_N2(one) >= kLawError * other.gain.taken_N2);
      });
  // Beside the scatter of sessions, or as it is where it is of what they differ in, or that scatter
  // takes up nearly all of it: what shifts whole sessions.
  const bool large = !data_.records().front().pulls_alone || one.gain.mean >= kLargeGain;
  const bool of_session = is_of(effects::ForceLaw::Of::session, one.term);
  const bool of_time = is_of(effects::ForceLaw::Of::time, one.term);
  const bool apart = of_session || is_of(effects::ForceLaw::Of::sensor, one.term);
  const double share =
      (large ? kMaterialShare : kMaterialShareAlone) * (apart ? kOfMaterialShareApart : 1);
  const bool shifts =
      apart && is_shift(one.gain) && std::ranges::all_of(judged_, [&](const Judged& other) {
        return taken_N2(one) >= kLawError * other.gain.taken_N2;
      });
  const double least = of_session || of_time || shifts ? kLeastShareApart : kLeastShare;
  const double of_noise_N2 =
      of_time ? kOfNoiseTaken * data_.noise_taken_N2(one.without, model_) : 0;
  const auto material = [&](double less_N2, std::span<const double> all_N2, double left_N2) {
    return less_N2 >=
           std::max({least * std::pow(data_.rmse_N(all_N2), 2), of_noise_N2, share * left_N2});
  };
  return told_apart && data_.is_physical(model_, place) &&
         within_scatter(one.gain, of_error_N2(kNotWorse)) &&
         one.gain.plain_N2 > -of_error_N2(kMostWorse) &&
         (((moves_sessions(one) || apart) &&
           material(taken_N2(one), held_.weighted_N2, left_.repeats_N2)) ||
          material(one.gain.beside_scatter_N2, held_.beside_scatter_N2, left_.beside_scatter_N2)) &&
         probability_of(one.term, one.gain, data_) >= kLikely &&
         !(of_session && taken_N2(one) < left_.of_sessions_N2) &&
         !(of_session && may_be_drift(refits_of(data_, data_.residuals_N(model_)),
                                      refits_of(data_, data_.residuals_N(one.without)),
                                      data_.covariance().scatter()));
}

bool Judgement::leaves_bounds(const ForceFit& fit) const {
  for (std::size_t i = 0; i < fit.terms.size(); ++i) {
    const auto same = std::ranges::find(model_.terms, fit.terms[i]);
    if (!data_.is_physical(fit, i) &&
        data_.is_physical(model_, static_cast<std::size_t>(same - model_.terms.begin()))) {
      return true;
    }
  }
  return false;
}

/// Whether what is lost by another term in the place of one is too little to say anything: beside
/// the scatter of sessions, or as it is where the term shifts whole sessions.
bool Judgement::alike(const Judged& one, const PairedGain& lost) const {
  return moves_sessions(one)
             ? lost.taken_N2 < std::max(kAlike * left_.repeats_N2, kLawError * taken_N2(one))
             : lost.beside_scatter_N2 < std::max(kAlike * left_.beside_scatter_N2,
                                                 kSameForce * one.gain.beside_scatter_N2);
}

/// Whether two are the same force as the drive runs, which is one way: they differ where it starts
/// and stops alone, and there friction is anything up to what it is.
bool Judgement::is_one_way_force(effects::ForceTerm one, effects::ForceTerm other) const {
  constexpr double kOneWay = 0.02;  // of the travel, the other way
  if (!law_of(one).constant || !law_of(other).constant) {
    return false;
  }
  double travel_m = 0;
  double forwards_m = 0;
  for (const effects::ForceRecord& record : data_.records()) {
    for (std::size_t i = 1; i < record.samples(); ++i) {
      const double moved_m = record.velocity_m_s[i] * (record.time_s[i] - record.time_s[i - 1]);
      travel_m += std::abs(moved_m);
      forwards_m += std::max(moved_m, 0.0);
    }
  }
  return std::min(forwards_m, travel_m - forwards_m) < kOneWay * travel_m;
}

bool Judgement::is_worse_than_none(const Judged& one, const PairedGain& lost) const {
  return one.gain.plain_N2 - lost.plain_N2 < -of_error_N2(kNotWorse);
}

Rival Judgement::rival(const Judged& one, const ForceFit& with_other,
                       const PairedGain& lost) const {
  const effects::ForceTerm other = with_other.terms.back();
  Rival rival{other, lost, lost.log_odds, both_shift(one, other, lost)};
  if (rival.shifts) {
    rival.log_odds = log_odds_of_shifts(one, with_other, lost);
  } else if (both_of(effects::ForceLaw::Of::session, one.term, other)) {
    rival.log_odds = log_odds_between_sessions(one, other, lost);
  }
  return rival;
}

bool Judgement::takes_place(const Judged& one, const Rival& rival) {
  if (rival.shifts) {
    return rival.log_odds < 0;
  }
  return rival.log_odds < -kOdds &&
         (!same_effect(one.term, rival.term) || seen_as_better(rival.term, rival.lost) < -kSeen);
}

double Judgement::cheaper(const Judged& one, effects::ForceTerm other) const {
  return cost_of(other, data_) - cost_of(one.term, data_);
}

/// By what is seen of them within sessions, or by how those scatter.
double Judgement::log_odds_between_sessions(const Judged& one, effects::ForceTerm other,
                                            const PairedGain& lost) const {
  const bool by_scatter = alike(one, lost) || std::abs(lost.of_sessions) > std::abs(lost.log_odds);
  return (by_scatter ? lost.of_sessions : lost.log_odds) + cheaper(one, other);
}

/// By how sessions scatter with each, and what data leave of their parameters.
double Judgement::log_odds_of_shifts(const Judged& one, const ForceFit& with_other,
                                     const PairedGain& lost) const {
  const auto place = std::ranges::find(model_.terms, one.term) - model_.terms.begin();
  return lost.of_sessions + data_.log_occam(model_, static_cast<std::size_t>(place)) -
         data_.log_occam(with_other, with_other.terms.size() - 1);
}

std::optional<double> Judgement::log_odds_of(const Judged& one, const Rival& rival) const {
  if (same_effect(one.term, rival.term)) {
    return std::nullopt;
  }
  if (rival.shifts || both_of(effects::ForceLaw::Of::session, one.term, rival.term)) {
    return rival.log_odds < kOdds ? std::optional(std::max(rival.log_odds, -kOdds)) : std::nullopt;
  }
  const PairedGain& lost = rival.lost;
  const bool even = alike(one, lost) || is_one_way_force(one.term, rival.term);
  const bool between = !moves_sessions(one) && nearer_by(lost) < kNearer;
  if (!even && !between && rival.log_odds >= kOdds) {
    return std::nullopt;
  }
  // Chance and the laws' own errors both count.
  const double most = even ? 0 : std::min(std::abs(nearer_by(lost)), kOdds);
  return std::clamp(rival.log_odds, -most, most) + cheaper(one, rival.term);
}

void Judgement::beside_catalogue(effects::ForceTerm other, const PairedGain& lost,
                                 Judged& one) const {
  const double log_odds = lost.log_odds + cheaper(one, other);
  const double share = 1 / (1 + std::exp(-log_odds));
  if (log_odds < kOdds && share < one.share) {
    one.share = share;
    one.imitated_by = other;
  }
}

PairedGain Judgement::late_input(const Judged& one, const PairedGain& lost) {
  return std::abs(lost.beside_scatter_N2) < kInputTimeError * one.gain.beside_scatter_N2
             ? PairedGain{.slope = kEvenSlope}
             : lost;
}

PairedGain Judgement::late_output(const Judged& one, const LateOutput& late) {
  const double error = std::hypot(late.error, kLateOutputError);
  const double of_model = one.term == effects::ForceTerm::delay ? 1 : 0;
  const double off_model = std::abs(late.as_delay - of_model) / error;
  const double off_other = std::abs(late.as_delay - (1 - of_model)) / error;
  const double log_odds = (off_other * off_other - off_model * off_model) / 2;
  if (!(late.error < kMostLateOutputError) || std::min(off_model, off_other) > kSeen ||
      std::abs(log_odds) < kOdds) {
    return {.slope = kEvenSlope};
  }
  return {.z = std::copysign(std::sqrt(2 * std::abs(log_odds)), log_odds),
          .slope = log_odds > 0 ? 1.0 : 0.0,
          .error = error,
          .log_odds = log_odds,
          .taken_N2 = one.gain.taken_N2,
          .beside_scatter_N2 = one.gain.beside_scatter_N2};
}

double Judgement::of_error_N2(double share) const {
  return share * std::pow(data_.rmse_N(held_.plain_N2), 2);
}

}  // namespace host_sim::diagnose
