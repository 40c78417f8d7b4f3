#include <algorithm>
#include <array>
#include <utility>

#include "host_sim/effects/tension/law.hpp"

namespace host_sim::effects {
namespace {

/// In order of ForceTerm.
constexpr std::array<const ForceLaw*, kForceTermCount> kLaws{
    &laws::kPreload,        &laws::kVelocity,
    &laws::kPresliding,     &laws::kElasticPresliding,
    &laws::kStribeck,       &laws::kLoad,
    &laws::kPosition,       &laws::kPositionFromMiddle,
    &laws::kSlack,          &laws::kLooseTendon,
    &laws::kCompliance,     &laws::kLag,
    &laws::kDelay,          &laws::kZero,
    &laws::kTemperature,    &laws::kWear,
    &laws::kRunIn,          &laws::kBendAngle,
    &laws::kCurrentOffset,  &laws::kGearAsymmetry,
    &laws::kTorqueGain,     &laws::kTorqueRipple,
    &laws::kFrictionByLoad, &laws::kFrictionBySpeed,
    &laws::kGivingSheath,   &laws::kOneWayFriction,
    &laws::kBentSensor,     &laws::kDriftingGain,
    &laws::kWarmSensor};

}  // namespace

const ForceLaw& law_of(ForceTerm term) {
  return *kLaws[static_cast<std::size_t>(term)];
}

std::span<const TensionEffect* const> tension_effects() {
  static const std::vector<const TensionEffect*> catalogue = [] {
    std::vector<const TensionEffect*> effects;
    for (const ForceLaw* const law : kLaws) {
      if (!law->outside && std::ranges::find(effects, law->effect) == effects.end()) {
        effects.push_back(law->effect);
      }
    }
    std::ranges::sort(effects, {}, &TensionEffect::id);
    return effects;
  }();
  return catalogue;
}

const TensionEffect* tension_effect(std::string_view id) {
  const auto all = tension_effects();
  const auto found = std::ranges::find(all, id, &TensionEffect::id);
  return found == all.end() ? nullptr : *found;
}

std::string_view missing_of(ForceTerm term, std::span<const ForceRecord> records) {
  const auto missing = law_of(term).missing;
  if (missing == nullptr) {
    return {};
  }
  for (const ForceRecord& record : records) {
    if (const std::string_view words = missing(record); !words.empty()) {
      return words;
    }
  }
  return {};
}

std::vector<ForceParameter> parameters_of(ForceTerm term, const ForceScales& scales) {
  return law_of(term).parameters(scales);
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
  const ForceLaw& law = law_of(term);
  if (law.written == nullptr) {
    return std::nullopt;
  }
  return law.written(law.id(), parameters, scales);
}

}  // namespace host_sim::effects
