#include "host_sim/effects/life/definition.hpp"

#include <utility>

namespace host_sim::effects {
namespace {

class DefinedEffect final : public LifeEffect {
 public:
  explicit DefinedEffect(LifeDefinition definition) : definition_(std::move(definition)) {}

  std::string_view id() const override { return definition_.id; }
  Kind kind() const override { return definition_.kind; }
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

std::unique_ptr<LifeEffect> effect_of(LifeDefinition definition) {
  return std::make_unique<DefinedEffect>(std::move(definition));
}

}  // namespace host_sim::effects
