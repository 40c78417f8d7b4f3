#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/hypotheses.hpp"

namespace host_sim::diagnose::lives {

/// What the probabilities say, before the residual of the extended model was tested.
struct Decision {
  Verdict verdict = Verdict::none;
  std::vector<std::string> effects;   ///< named, or the most probable, each with its own
  std::vector<double> probabilities;  ///< probability to take part
  const Hypothesis* best = nullptr;   ///< the most probable that has these effects and no other
  std::vector<Candidate> candidates;  ///< by falling probability
  std::vector<std::string> credible_set;
};

/// Those with the same id are one. By falling probability, "unknown" always among them.
std::vector<Candidate> candidates_of(const std::vector<Hypothesis>& hypotheses);

/// An effect is named where the explanations that it takes part in hold kNamed together and the
/// residuals hold more than chance, by the p of all tests. Where nothing wrong is the
/// most probable, that is the answer if it is probable enough or the residuals agree; else
/// it is one of the candidates.
/// @pre hypotheses by falling probability
Decision decide(const std::vector<Hypothesis>& hypotheses, double p);

}  // namespace host_sim::diagnose::lives
