#include "host_sim/effects/tension/definition.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace host_sim::effects {
namespace {

/// What r itself needs.
std::string missing_in_residual(const recording::Covariates& covariates) {
  if (covariates.tension_in_N().empty()) {
    return "no input tension (input_tension_N or motor_current_A)";
  }
  if (covariates.output_tension_N.empty()) {
    return "no output tension (output_tension_N)";
  }
  if (covariates.direction.empty()) {
    return "no direction of travel (tendon_velocity_m_s)";
  }
  if (covariates.bend_angle_rad.empty()) {
    return "no bend angle (bend_angle_deg, in the recording or in the nominal sheath)";
  }
  return {};
}

class DefinedTensionEffect final : public TensionEffect {
 public:
  explicit DefinedTensionEffect(TensionDefinition definition)
      : definition_(std::move(definition)) {}

  std::string_view id() const override { return definition_.id; }
  std::string_view term() const override { return definition_.term; }
  std::string_view equation() const override { return definition_.equation; }
  std::string_view life_consequence() const override { return definition_.life_consequence; }
  std::span<const Parameter> parameters() const override { return definition_.parameters; }
  std::span<const Separation> separations() const override { return definition_.separations; }
  bool per_pose() const override { return definition_.per_pose; }
  bool at_reversals() const override { return definition_.at_reversals; }
  bool shifts_sessions() const override { return definition_.shifts_sessions; }

  std::string missing(const recording::Covariates& covariates) const override {
    if (definition_.acts_on_current && !covariates.input_tension_N.empty()) {
      return "input tension comes from a load cell, which the drive does not change";
    }
    if (std::string text = missing_in_residual(covariates); !text.empty()) {
      return text;
    }
    for (const Need& need : definition_.needs) {
      if ((covariates.*need.values).empty()) {
        std::string text = "no ";
        text += need.description;
        return text;
      }
    }
    return {};
  }

  std::vector<std::vector<double>> shapes() const override { return definition_.shapes; }
  bool shapes_between() const override { return !definition_.whole_shapes; }

  Signature signature(const recording::Covariates& covariates, const Baseline& baseline,
                      std::span<const double> shape) const override {
    return {.shape = {shape.begin(), shape.end()},
            .columns = definition_.columns(covariates, baseline, shape)};
  }

 private:
  TensionDefinition definition_;
};

}  // namespace

std::span<const std::unique_ptr<TensionEffect>> tension_effects() {
  static const std::vector<std::unique_ptr<TensionEffect>> catalogue = [] {
    std::vector<std::unique_ptr<TensionEffect>> made;
    for (const auto& definitions : {friction_effects(), transmission_effects(), sensor_effects()}) {
      for (const TensionDefinition& definition : definitions) {
        made.push_back(std::make_unique<DefinedTensionEffect>(definition));
      }
    }
    std::ranges::sort(made, {}, &TensionEffect::id);
    return made;
  }();
  return catalogue;
}

}  // namespace host_sim::effects
