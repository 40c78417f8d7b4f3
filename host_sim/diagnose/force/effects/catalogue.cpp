#include <array>
#include <cmath>

#include "host_sim/diagnose/force/effects/law.hpp"
#include "host_sim/extension/model_file.hpp"

namespace host_sim::diagnose {
namespace {

/// In order of ForceTerm.
constexpr std::array<const ForceEffect*, kForceTermCount> kEffects{&laws::kPreload,
                                                                   &laws::kVelocity,
                                                                   &laws::kPresliding,
                                                                   &laws::kElasticPresliding,
                                                                   &laws::kStribeck,
                                                                   &laws::kLoad,
                                                                   &laws::kPosition,
                                                                   &laws::kSlack,
                                                                   &laws::kLooseTendon,
                                                                   &laws::kCompliance,
                                                                   &laws::kLag,
                                                                   &laws::kDelay,
                                                                   &laws::kZero,
                                                                   &laws::kTemperature,
                                                                   &laws::kWear,
                                                                   &laws::kRunIn,
                                                                   &laws::kBendAngle,
                                                                   &laws::kCurrentOffset,
                                                                   &laws::kGearAsymmetry,
                                                                   &laws::kTorqueGain,
                                                                   &laws::kTorqueRipple,
                                                                   &laws::kGivingSheath,
                                                                   &laws::kOneWayFriction,
                                                                   &laws::kBentSensor,
                                                                   &laws::kDriftingGain,
                                                                   &laws::kWarmSensor};

}  // namespace

const ForceEffect& definition_of(ForceTerm term) {
  return *kEffects[static_cast<std::size_t>(term)];
}

bool is_shown(ForceTerm term, std::span<const ForceRecord> records) {
  const auto shown = definition_of(term).shown;
  return shown == nullptr || std::ranges::all_of(records, shown);
}

std::vector<ForceParameter> parameters_of(ForceTerm term, const ForceScales& scales) {
  return definition_of(term).parameters(scales);
}

std::vector<ForceParameter> parameters_of(const ForceTerms& terms, const ForceScales& scales) {
  std::vector<ForceParameter> all{{"gain", "1", 0.05, 20, {1}},
                                  {"friction_coefficient", "1", 0, 2, {0.1}}};
  for (const ForceTerm term : terms) {
    for (ForceParameter& parameter : parameters_of(term, scales)) {
      all.push_back(std::move(parameter));
    }
  }
  return all;
}

std::span<const double> parameters_at(std::size_t place, const ForceTerms& terms,
                                      std::span<const double> parameters,
                                      const ForceScales& scales) {
  std::size_t first = 2;
  for (std::size_t i = 0; i < place; ++i) {
    first += parameters_of(terms[i], scales).size();
  }
  return parameters.subspan(first, parameters_of(terms[place], scales).size());
}

std::optional<Extension> written_term(ForceTerm term, std::span<const double> parameters,
                                      const ForceScales& scales) {
  const ForceEffect& effect = definition_of(term);
  if (effect.written == nullptr) {
    return std::nullopt;
  }
  return effect.written(effect.id, parameters, scales);
}

double written_friction(double friction, std::span<const Extension> extensions,
                        const ForceScales& scales) {
  constexpr double kReference_N = 50;
  const Extension* const load = extension_of(extensions, "friction_load");
  return load == nullptr ? friction
                         : friction * std::pow(kReference_N / scales.force_N,
                                               -value_of(*load, "load_exponent"));
}

}  // namespace host_sim::diagnose
