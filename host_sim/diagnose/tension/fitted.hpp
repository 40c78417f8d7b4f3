#pragma once

#include <span>

#include "host_sim/diagnose/tension/model_fit.hpp"
#include "host_sim/diagnose/tension/predicted.hpp"
#include "host_sim/diagnose/tension/shape_search.hpp"

namespace host_sim::diagnose {

/// A model fitted to all sessions, with the matrices that it was fitted by.
struct Fitted {
  Grams grams;
  ModelFit fit;
};

/// @param model no parts: the nominal one
Fitted fitted(const Evidence& evidence, std::span<const Component> model);

Predicted predict(const Session& session, const Fitted& by);

}  // namespace host_sim::diagnose
