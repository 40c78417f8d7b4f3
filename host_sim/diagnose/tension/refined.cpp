#include "host_sim/diagnose/tension/refined.hpp"

#include <algorithm>
#include <cstddef>

#include "host_sim/diagnose/tension/fitted.hpp"

namespace host_sim::diagnose {
namespace {

constexpr int kSelectionRounds = 3;
constexpr double kMostChange = 4;  ///< in one round

/// A size that is known to first order by its share alone, times that share.
void take_share(const Fitted& by, std::size_t place, Component& component) {
  if (component.shape.empty()) {
    return;
  }
  const auto parameters = component.effect->parameters();
  const GramLayout::Block& block = by.grams.layout.effects[place].blocks.front();
  const effects::Parameter& size = parameters[block.count];
  if (!size.scaled_by_share) {
    return;
  }
  const double share = by.fit.coefficients(static_cast<Eigen::Index>(block.first));
  const double factor = std::clamp(share, 1 / kMostChange, kMostChange);
  component.shape.front() =
      std::clamp(component.shape.front() * factor, size.minimum, size.maximum);
}

/// Friction and sizes, from one fit.
void take_fit(Evidence& evidence, std::vector<Component>& model) {
  const Fitted by = fitted(evidence, model);
  const double more = by.fit.coefficients(Eigen::Index{GramLayout::kFriction});
  double& friction = evidence.options.baseline.friction_coefficient;
  friction = std::max(friction + more, friction / kMostChange);
  for (std::size_t i = 0; i < model.size(); ++i) {
    take_share(by, i, model[i]);
  }
}

Component searched(const Evidence& evidence, const std::vector<Component>& model,
                   std::size_t place) {
  std::vector<Component> others = model;
  const effects::TensionEffect& effect = *others[place].effect;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(place));
  const std::vector<double> at_shapes =
      evidences_at(evidence, others, {.effect = &effect, .shapes = effect.shapes()});
  return search_shape(evidence, effect, at_shapes, others).best;
}

}  // namespace

void take_friction_of(Evidence& evidence, std::vector<Component> model) {
  for (int round = 0; round < kSelectionRounds && !model.empty(); ++round) {
    take_fit(evidence, model);
  }
}

std::vector<Component> refined(Evidence& evidence, std::vector<Component> model) {
  for (int round = 0; round < kSelectionRounds && !model.empty(); ++round) {
    take_fit(evidence, model);
    for (std::size_t i = 0; i < model.size(); ++i) {
      if (model[i].effect->at_reversals()) {
        model[i] = searched(evidence, model, i);
      }
    }
  }
  return model;
}

}  // namespace host_sim::diagnose
