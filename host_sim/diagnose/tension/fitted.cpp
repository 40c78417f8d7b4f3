#include "host_sim/diagnose/tension/fitted.hpp"

#include <utility>

namespace host_sim::diagnose {

Fitted fitted(const Evidence& evidence, std::span<const Component> model) {
  GramOptions options = evidence.options;
  options.wanted = wanted_of(model);
  Grams grams = gram_of(evidence.sessions, options);
  ModelFit fit = fit_model(grams, terms_of(grams.layout), evidence.sample_sd);
  return {std::move(grams), std::move(fit)};
}

Predicted predict(const Session& session, const Fitted& by) {
  return predict(session, by.grams.layout, by.grams.baseline, by.fit);
}

}  // namespace host_sim::diagnose
