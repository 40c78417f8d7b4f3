#include "host_sim/diagnose/tension/decision.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::diagnose {
namespace {

// Shares of 1.
constexpr double kPriorNone = 0.65;
constexpr double kPriorSingles = 0.25;
constexpr double kPriorPairs = 0.05;  ///< of all that the singles make
/// Of something beside the best hypothesis, as odds.
constexpr double kPriorStructure = 0.05;

/// Below this the simulated p is as small as it can be.
constexpr double kResolvedP = 0.0015;

/// ln of what a second effect must be better by, beside the evidence.
constexpr double kSecondEffect = 3;

/// ln of the same odds where the sessions scatter more than rigs do.
constexpr double kBeyondScatter = 20;

/// Of the test of what is left.
constexpr double kSignificant = 0.01;

/// Of a model that explains much, for each unit of ln evidence.
constexpr double kLeastDispersion = 0.0005;

/// The same in what shifts whole sessions: what a signature leaves, it leaves within the stroke. As
/// seen in simulated campaigns that hide one effect: no second one of that kind gained a third of
/// what it takes to be named.
constexpr double kLeastDispersionOfSessions = 0.00001;

/// What the effects of a model may leave of the variance that they explain before it counts as
/// structure: signatures are linear and the catalogue's terms are approximations.
constexpr double kModelError = 0.01;

/// ln of how much likelier the residual is with structure in it than without: the score statistic
/// under the prior variance that suits it best, of one probe among several, and no more than its p
/// allows (Sellke, Bayarri and Berger, 2001).
double log_structure(const ResidualTest& rest) {
  double most = rest.scatter_beyond ? kBeyondScatter : 0;
  for (const ProbeResult& probe : rest.probes) {
    const double statistic = probe.statistic - kModelError * std::max(rest.explained, 0.0);
    if (probe.freedom <= 0 || statistic <= probe.freedom) {
      continue;
    }
    const double ratio = statistic / probe.freedom;
    const double evidence = (statistic - probe.freedom - probe.freedom * std::log(ratio)) / 2;
    const double bound = probe.p < std::exp(-1.0) ? -1 - std::log(-probe.p * std::log(probe.p)) : 0;
    const bool resolved = probe.p > kResolvedP;
    most = std::max(most, resolved ? std::min(evidence, bound) : evidence);
  }
  return most - std::log(static_cast<double>(std::max<std::size_t>(rest.probes.size(), 1)));
}

/// Whether a pair is `first` with an effect beside it that shifts whole sessions.
bool shifts_sessions_beside(const Hypothesis& first, const Hypothesis& pair) {
  return pair.holds(first.id()) && std::ranges::any_of(pair.parts, [&](const Component& part) {
           return part.effect->id() != first.id() && part.effect->shifts_sessions();
         });
}

std::vector<Candidate> normalised(std::vector<Candidate> logs) {
  const double most = std::ranges::max(logs, {}, &Candidate::probability).probability;
  double sum = 0;
  for (Candidate& candidate : logs) {
    candidate.probability = std::exp(candidate.probability - most);
    sum += candidate.probability;
  }
  for (Candidate& candidate : logs) {
    candidate.probability /= sum;
  }
  std::ranges::stable_sort(logs, std::greater{}, &Candidate::probability);
  return logs;
}

}  // namespace

double dispersion_of(const ResidualTest& rest) {
  double most = 1;
  for (const ProbeResult& probe : rest.probes) {
    if (probe.freedom > 0 && probe.p < kSignificant) {
      most = std::max(most, probe.statistic / probe.freedom);
    }
  }
  return most;
}

Weighed weigh(const Ranking& ranking, const Hypothesis& best, const ResidualTest& rest) {
  const double explained = std::max(best.log_evidence - ranking.none.log_evidence, 0.0);
  const double dispersion = dispersion_of(rest);
  const double temperature = std::max(dispersion, 1 + kLeastDispersion * explained);
  const double between_sessions = std::max(dispersion, 1 + kLeastDispersionOfSessions * explained);
  std::vector<Candidate> logs;
  double unknown = 0;
  const auto add = [&](const Hypothesis& hypothesis, double tempered, double prior) {
    const double log = tempered + std::log(prior);
    logs.push_back({hypothesis.id(), log});
    if (logs.back().id == best.id()) {
      unknown = log + std::log(kPriorStructure) + log_structure(rest);
    }
  };
  add(ranking.none, ranking.none.log_evidence / temperature, kPriorNone);
  const auto singles = static_cast<double>(ranking.singles.size());
  for (const Hypothesis& single : ranking.singles) {
    add(single, single.log_evidence / temperature, kPriorSingles / singles);
  }
  for (const Hypothesis& pair : ranking.pairs) {
    // Beside the best only: what is beside another may make up for what is wrong with that one.
    const Hypothesis& first = ranking.singles.front();
    const double of_second = shifts_sessions_beside(first, pair) ? between_sessions : temperature;
    const double tempered =
        first.log_evidence / temperature + (pair.log_evidence - first.log_evidence) / of_second;
    // Tempering takes off most of what the evidence charges for the second effect.
    const double second = std::exp(-kSecondEffect * (1 - 1 / of_second));
    add(pair, tempered, kPriorPairs * second / (singles * std::max(singles - 1, 1.0) / 2));
  }
  logs.push_back({"unknown", unknown});
  return {normalised(std::move(logs))};
}

double Weighed::of(std::string_view id) const {
  const auto found = std::ranges::find(candidates, id, &Candidate::id);
  return found == candidates.end() ? 0 : found->probability;
}

double Weighed::marginal(std::string_view effect) const {
  double sum = 0;
  for (const Candidate& candidate : candidates) {
    const std::string_view id = candidate.id;
    const std::size_t plus = id.find('+');
    if (id.substr(0, plus) == effect ||
        (plus != std::string_view::npos && id.substr(plus + 1) == effect)) {
      sum += candidate.probability;
    }
  }
  return sum;
}

Verdict decide(const Weighed& weighed) {
  const Candidate& first = weighed.candidates.front();
  if (first.id == "unknown") {
    return Verdict::unknown;
  }
  if (first.id == "none") {
    return Verdict::none;
  }
  return first.probability >= kNamed ? Verdict::named : Verdict::ambiguous;
}

}  // namespace host_sim::diagnose
