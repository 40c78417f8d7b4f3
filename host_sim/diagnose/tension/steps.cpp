#include "host_sim/diagnose/tension/steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/diagnose/tension/estimates.hpp"
#include "host_sim/diagnose/tension/held_out.hpp"
#include "host_sim/diagnose/tension/noise.hpp"

namespace host_sim::diagnose {
namespace {

constexpr std::size_t kMostSteps = 4;

/// What a good model leaves of the misfit of the nominal one, which the scatter of sessions is
/// weighed against.
constexpr double kLeftByGood = 1.0 / 3;

/// Standard deviations of the sign test over the sessions.
constexpr double kConvincing = 2;

struct Addition {
  Component part;
  double log_evidence = 0;  ///< averaged over its shapes
};

bool holds(std::span<const Component> model, const effects::TensionEffect* effect) {
  return std::ranges::find(model, effect, &Component::effect) != model.end();
}

/// Every effect that the sessions can give and the model does not hold, best evidence first.
std::vector<Addition> additions_to(const Evidence& evidence, const std::vector<Wanted>& wanted,
                                   std::span<const Component> model) {
  const GramLayout layout = layout_of(evidence.sessions, evidence.options.baseline, wanted);
  std::vector<Addition> additions;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!layout.effects[i].missing.empty() || holds(model, wanted[i].effect)) {
      continue;
    }
    const std::vector<double> at_shapes = evidences_at(evidence, model, wanted[i]);
    ShapeSearch found = search_shape(evidence, *wanted[i].effect, at_shapes, model);
    additions.push_back({std::move(found.best), found.log_evidence});
  }
  std::ranges::stable_sort(additions, std::greater{}, &Addition::log_evidence);
  return additions;
}

/// Of the first among all, and none.
double probability_of(const std::vector<Addition>& additions, double log_none) {
  const double first = additions.front().log_evidence;
  double sum = std::exp(log_none - first);
  for (const Addition& addition : additions) {
    sum += std::exp(addition.log_evidence - first);
  }
  return 1 / sum;
}

int sessions_better(const HeldOut& before, const HeldOut& after) {
  int better = 0;
  for (std::size_t i = 0; i < before.sessions.size(); ++i) {
    better += after.sessions[i].output_square_N2 < before.sessions[i].output_square_N2 ? 1 : 0;
  }
  return better;
}

/// More than sessions that are better or worse by chance.
bool convincing(int better, std::size_t sessions) {
  const auto all = static_cast<double>(sessions);
  return 2 * better - all >= kConvincing * std::sqrt(all);
}

Step step_with(const HeldOut& scores) {
  return {.effect = {},
          .output_rmse_N = scores.output_rmse_N(),
          .input_rmse_N = scores.input_rmse_N(),
          .log_predictive_density = scores.log_density()};
}

double log_evidence_of(const Evidence& evidence, std::span<const Component> model) {
  GramOptions options = evidence.options;
  options.wanted = wanted_of(model);
  const Grams grams = gram_of(evidence.sessions, options);
  return log_evidence(scatter_grid(grams, evidence.sample_sd), terms_of(grams.layout),
                      grams.response(), grams.samples());
}

/// Weights by which the error in newtons counts.
SampleWeights newton_weights(std::span<const Session> sessions) {
  return weights_of_mean_one(sessions, [](const recording::Covariates& covariates, std::size_t i) {
    return covariates.tension_in_N()[i] * covariates.output_tension_N[i];
  });
}

/// Standard deviation of what the nominal model leaves, with a gain and a friction for each
/// session.
double misfit_of(const Evidence& evidence) {
  const Grams grams = gram_of(evidence.sessions, evidence.options);
  const Projection projection = project(grams, {.sample_sd = 1, .free_sessions = true});
  return std::sqrt(projection.left(grams.response(), grams.response()) / grams.samples());
}

FoundEffect found(const Evidence& evidence, std::span<const Component> model, double probability,
                  double dispersion) {
  const effects::TensionEffect& effect = *model.back().effect;
  return {.id = std::string(effect.id()),
          .term = std::string(effect.term()),
          .equation = std::string(effect.equation()),
          .life_consequence = std::string(effect.life_consequence()),
          .probability = probability,
          .parameters = estimates_of(evidence, model, model.size() - 1, dispersion)};
}

}  // namespace

std::vector<Step> steps_of(Evidence evidence, const std::vector<Wanted>& wanted, double dispersion,
                           const reference::Constants& constants) {
  const SampleWeights weights = newton_weights(evidence.sessions);
  evidence.options.weights = weights;
  evidence.options.autocorrelation = 0;
  evidence.sample_sd = kLeftByGood * misfit_of(evidence);
  std::vector<Component> model;
  HeldOut last = held_out(evidence, model, constants);
  std::vector<Step> steps{step_with(last)};
  while (model.size() < kMostSteps) {
    const std::vector<Addition> additions = additions_to(evidence, wanted, model);
    if (additions.empty()) {
      break;
    }
    const double log_none = log_evidence_of(evidence, model);
    model.push_back(additions.front().part);
    HeldOut scores = held_out(evidence, model, constants);
    const int better = sessions_better(last, scores);
    const double probability = probability_of(additions, log_none);
    if (probability < kNamed || !convincing(better, scores.sessions.size())) {
      break;
    }
    Step step = step_with(scores);
    step.effect = found(evidence, model, probability, dispersion);
    step.sessions_better = better;
    step.sessions = static_cast<int>(scores.sessions.size());
    steps.push_back(std::move(step));
    last = std::move(scores);
  }
  return steps;
}

}  // namespace host_sim::diagnose
