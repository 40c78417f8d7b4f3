#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/audit.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/tension/ranking.hpp"
#include "host_sim/diagnose/tension/residual_test.hpp"

namespace host_sim::diagnose {

/// Of each hypothesis, most probable first; "unknown" is one of them.
struct Weighed {
  std::vector<Candidate> candidates;

  [[nodiscard]] double of(std::string_view id) const;
  /// Of all hypotheses that hold this effect.
  [[nodiscard]] double marginal(std::string_view effect) const;
};

/// The evidences are tempered: signatures are linear and the catalogue's terms are
/// approximations, so that differences that are small beside what the effects explain say little.
/// @param best the hypothesis that `rest` was tested on
Weighed weigh(const Ranking& ranking, const Hypothesis& best, const ResidualTest& rest);

/// How many times larger what is left is than noise, where that is significant: evidences of models
/// that are wrong by that much count so many times less, as quasi-likelihoods do (McCullagh and
/// Nelder, 1989, section 9.2). 1 or more.
double dispersion_of(const ResidualTest& rest);

/// The verdict by the probabilities of the candidates.
Verdict decide(const Weighed& weighed);

}  // namespace host_sim::diagnose
