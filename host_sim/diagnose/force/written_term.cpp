#include "host_sim/diagnose/force/written_term.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace host_sim::diagnose {
namespace {

/// a sin(k (x - m)) + b cos(k (x - m)) as a sum of sin(kx) and cos(kx); a table has six of them.
Extension about_zero(std::string id, std::span<const double> harmonics, const ForceScales& scales) {
  constexpr std::size_t kWritten = 6;
  Extension extension{std::move(id), {}};
  for (std::size_t harmonic = 1; harmonic <= kWritten; ++harmonic) {
    const std::size_t at = 2 * harmonic - 2;
    const double sine = at < harmonics.size() ? harmonics[at] : 0;
    const double cosine = at < harmonics.size() ? harmonics[at + 1] : 0;
    const double phase =
        2 * std::numbers::pi * static_cast<double>(harmonic) * scales.position_m / scales.stroke_m;
    const std::string number = std::to_string(harmonic);
    extension.values.push_back(
        {"position_sine_" + number, {sine * std::cos(phase) + cosine * std::sin(phase)}});
    extension.values.push_back(
        {"position_cosine_" + number, {cosine * std::cos(phase) - sine * std::sin(phase)}});
  }
  extension.values.push_back({"wavelength_m", {scales.stroke_m}});
  return extension;
}

}  // namespace

std::optional<Extension> written_term(ForceTerm term, std::span<const double> values,
                                      const ForceScales& scales) {
  const std::string id(definition_of(term).id);
  switch (term) {
    case ForceTerm::preload:
    case ForceTerm::presliding:
    case ForceTerm::load:
    case ForceTerm::lag:
    case ForceTerm::temperature:
    case ForceTerm::current_offset:
    case ForceTerm::gear_asymmetry:
    case ForceTerm::velocity: {
      Extension extension{id, {}};
      std::size_t next = 0;
      for (const ForceParameter& parameter : parameters_of(term, scales)) {
        extension.values.push_back({std::string(parameter.name), {values[next++]}});
      }
      return extension;
    }
    case ForceTerm::zero:
      return Extension{id, {{"zero_N", {values.front()}}}};
    case ForceTerm::position:
      return about_zero(id, values, scales);
    case ForceTerm::slack:
    case ForceTerm::compliance:
      break;
  }
  return std::nullopt;
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
