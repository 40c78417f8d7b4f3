#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host_sim/diagnose/force/force_fit.hpp"
#include "host_sim/diagnose/force/late_output.hpp"
#include "host_sim/diagnose/force/paired_gain.hpp"
#include "host_sim/diagnose/force/structure.hpp"

namespace host_sim::diagnose {

/// What it takes to be seen on sessions that the fit never saw, in standard errors.
inline constexpr double kSeen = 3;

/// An effect that is not in a model.
struct LeftOut {
  effects::ForceTerm term{};
  double probability = 0;  ///< of what it gains beside the model
  double unseen = 0;       ///< that it is there and too small to be seen
};

/// A term in a model, by what the model does without it.
struct Judged {
  effects::ForceTerm term{};
  PairedGain gain;
  ForceFit without;
  HeldOut held_without;
  struct Other {
    effects::ForceTerm term{};
    double log_odds = 0;  ///< against it
  };
  std::vector<Other> others = {};  ///< that could stand in its place
  /// The same of what the catalogue does not have, and the probability that it is not that.
  std::optional<effects::ForceTerm> imitated_by = {};
  double share = 1;
};

/// Whether one, or both, are laws of such effects.
bool is_of(effects::ForceLaw::Of kind, effects::ForceTerm term);
bool both_of(effects::ForceLaw::Of kind, effects::ForceTerm one, effects::ForceTerm other);

/// Whether both are laws of one effect.
bool same_effect(effects::ForceTerm one, effects::ForceTerm other);

/// Whether both are laws of friction by one covariate.
bool depends_on_the_same(effects::ForceTerm one, effects::ForceTerm other);

/// How much less a model with a term leaves than one without it, on sessions that neither saw. Next
/// to where the motion turns over, filters and what rubs within micrometres are as an effect of
/// time that is not there: one gains without those samples as well, or does not.
PairedGain gain_of(effects::ForceTerm term, const ForceData& data, const HeldOut& without,
                   const HeldOut& with);

/// For a term, as a logarithm of odds: the standard errors of the gain, and where that is seen and
/// shifts whole sessions the likelihood of what they differ by; of what those differ in that and
/// the standard errors within sessions, where that is no small part or clear.
double evidence_of(effects::ForceTerm term, const PairedGain& gain);

/// Standard errors by which another law of one effect is better, of what sessions differ in by how
/// those scatter.
/// @param gain of the other one over this one
double seen_as_better(effects::ForceTerm term, const PairedGain& gain);

/// What a term's parameters count against it, as a logarithm of odds (Laplace).
double cost_of(effects::ForceTerm term, const ForceData& data);

/// That the effect of a term is there: Laplace, evidence against as many parameters, of so many
/// sessions, and of what is tried one by one each as likely before.
double probability_of(effects::ForceTerm term, const PairedGain& gain, const ForceData& data);

/// That an effect is there of which nothing is seen: its size has a normal prior of zero mean.
/// @param sigmas standard errors that a usual one makes, which is the standard deviation of that
double unseen_probability(double sigmas);

/// That what could be in the place of a cause is there at all.
bool may_be(effects::ForceTerm term, const PairedGain& gain, const ForceData& data);

/// Whether the error is larger, sample by sample, by no more than is allowed and sessions scatter.
bool within_scatter(const PairedGain& gain, double allowed_N2 = 0);

/// Another term in the place of one.
struct Rival {
  effects::ForceTerm term{};
  PairedGain lost;      ///< by it
  double log_odds = 0;  ///< of the model, against one with it
  bool shifts = false;  ///< one moves whole sessions alone, as a sensor does, and so does the other
};

/// What it takes to stay in a model, and what could stand in the place of that.
class Judgement {
 public:
  /// @param judged terms of the model, in order; kept by reference, as all of these
  Judgement(const ForceData& data, const ForceFit& model, const HeldOut& held,
            const Structure& left, std::span<const Judged> judged)
      : data_(data), model_(model), held_(held), left_(left), judged_(judged) {}

  /// Whether a term is likely, material, within the bounds of physics and more than
  /// samples resolve.
  [[nodiscard]] bool stays(std::size_t place) const;

  /// Whether a term is beyond its bounds in a model that is within them in this one.
  [[nodiscard]] bool leaves_bounds(const ForceFit& fit) const;

  /// Whether the error is larger than without any term in the place of one.
  /// @param lost by another term in that place
  [[nodiscard]] bool is_worse_than_none(const Judged& one, const PairedGain& lost) const;

  /// @param with_other the model with another term in the place of one, as its last
  [[nodiscard]] Rival rival(const Judged& one, const ForceFit& with_other,
                            const PairedGain& lost) const;

  /// Whether the other does better.
  [[nodiscard]] static bool takes_place(const Judged& one, const Rival& rival);

  /// Against another effect; none where it is told that it is not that, or is the same.
  [[nodiscard]] std::optional<double> log_odds_of(const Judged& one, const Rival& rival) const;

  /// What is no effect of the catalogue takes no place, but may be as likely as one that has it.
  void beside_catalogue(effects::ForceTerm other, const PairedGain& lost, Judged& one) const;

  /// What is lost by a lag of the input in the place of a delay, or the other way about: nothing is
  /// known of it before they are seen to differ.
  /// @param lost of all samples
  [[nodiscard]] static PairedGain late_input(const Judged& one, const PairedGain& lost);

  /// The same of the output, where all samples are asked for it.
  [[nodiscard]] static PairedGain late_output(const Judged& one, const LateOutput& late);

 private:
  /// A share of the squared error of the model, plain as it is.
  [[nodiscard]] double of_error_N2(double share) const;
  [[nodiscard]] bool alike(const Judged& one, const PairedGain& lost) const;
  [[nodiscard]] bool is_one_way_force(effects::ForceTerm one, effects::ForceTerm other) const;
  [[nodiscard]] double log_odds_between_sessions(const Judged& one, effects::ForceTerm other,
                                                 const PairedGain& lost) const;
  [[nodiscard]] double log_odds_of_shifts(const Judged& one, const ForceFit& with_other,
                                          const PairedGain& lost) const;
  [[nodiscard]] double cheaper(const Judged& one, effects::ForceTerm other) const;

  const ForceData& data_;
  const ForceFit& model_;
  const HeldOut& held_;
  const Structure& left_;
  std::span<const Judged> judged_;
};

}  // namespace host_sim::diagnose
