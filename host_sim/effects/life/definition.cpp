#include "host_sim/effects/life/definition.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace host_sim::effects {
namespace {

class DefinedLifeEffect final : public LifeEffect {
 public:
  explicit DefinedLifeEffect(LifeDefinition definition) : definition_(std::move(definition)) {}

  std::string_view id() const override { return definition_.id; }
  LifeEffectKind kind() const override { return definition_.kind; }
  std::string_view term() const override { return definition_.term; }
  std::string_view equation() const override { return definition_.equation; }
  std::string_view life_consequence() const override { return definition_.life_consequence; }
  std::span<const Parameter> parameters() const override { return definition_.parameters; }
  std::span<const Separation> separations() const override { return definition_.separations; }
  std::vector<std::vector<double>> shapes() const override { return definition_.shapes; }

  std::string missing(const LifeCovariates& covariates) const override {
    return std::string(definition_.missing != nullptr ? definition_.missing(covariates) : "");
  }

  Signature signature(const LifeCovariates& covariates, const LifeBaseline& baseline,
                      std::span<const double> shape) const override {
    Signature signature{.shape = {shape.begin(), shape.end()}, .columns = {}};
    if (definition_.columns != nullptr) {
      signature.columns = definition_.columns(covariates, baseline, shape);
    }
    return signature;
  }

  Scatter scatter(const LifeCovariates& covariates, const LifeBaseline& baseline,
                  std::span<const double> shape) const override {
    return definition_.scatter != nullptr ? definition_.scatter(covariates, baseline, shape)
                                          : Scatter{};
  }

 private:
  LifeDefinition definition_;
};

}  // namespace

std::span<const std::unique_ptr<LifeEffect>> life_effects() {
  static const std::vector<std::unique_ptr<LifeEffect>> catalogue = [] {
    std::vector<std::unique_ptr<LifeEffect>> made;
    for (const auto& definitions : {load_effects(), specimen_effects()}) {
      for (const LifeDefinition& definition : definitions) {
        made.push_back(std::make_unique<DefinedLifeEffect>(definition));
      }
    }
    std::ranges::sort(made, {}, &LifeEffect::id);
    return made;
  }();
  return catalogue;
}

}  // namespace host_sim::effects
