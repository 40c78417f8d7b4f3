#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "host_sim/diagnose/force/effects/law.hpp"

/// Laws of friction, which are approximations of each other.
namespace host_sim::diagnose::laws {
namespace {

/// kappa of laws of the speed.
ForceParameter viscous_friction(const ForceScales& scales) {
  const double speed_m_s = scales.speed_m_s;
  return {"viscous_friction_s_m", "s/m", -1 / speed_m_s, 1 / speed_m_s, {0.01 / speed_m_s}};
}

namespace preload {

Parameters parameters(const ForceScales& scales) {
  return {{"preload_N", "N", 0, 10 * scales.larger_N(), {0.2 * scales.larger_N()}}};
}

constexpr ForceEffect kEffect{
    "friction_preload",
    "load-independent friction",
    "+ F s",
    "friction that does not fall with the load loads the tendon in every cycle, small ones most",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.preload_N = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::friction};

}  // namespace preload

namespace velocity {

Parameters parameters(const ForceScales& scales) {
  const double force_N = scales.larger_N();
  const double speed_m_s = scales.speed_m_s;
  return {{"viscous_N_s_m", "N s/m", 0, 10 * force_N / speed_m_s, {0.05 * force_N / speed_m_s}},
          viscous_friction(scales)};
}

constexpr ForceEffect kEffect{"friction_velocity",
                              "viscous friction",
                              "+ (c + kappa phi |T|) |v| s",
                              "fast strokes load the tendon more than slow ones of the same load",
                              nullptr,
                              parameters,
                              [](Numbers numbers, ForceValues& values) {
                                values.viscous_N_s_m = numbers[0];
                                values.viscous_friction_s_m = numbers[1];
                              },
                              written<parameters>,
                              ForceEffect::Of::friction};

}  // namespace velocity

namespace stribeck {

/// A model that is written has the velocity within these bounds. Slower than friction turns over it
/// would be that.
Parameters parameters(const ForceScales& scales) {
  constexpr double kLeast_m_s = 0.002;
  constexpr double kMost_m_s = 0.1;
  const double speed_m_s = scales.speed_m_s;
  const double least_m_s = std::max(kLeast_m_s, 2 * scales.turn_over_m_s);
  if (least_m_s >= kMost_m_s) {
    return {};
  }
  return {
      viscous_friction(scales),
      {"stribeck_friction", "1", -0.5, 0.5, {0.02}},
      {"stribeck_velocity_m_s", "m/s", least_m_s, kMost_m_s, {0.1 * speed_m_s, 0.3 * speed_m_s}}};
}

constexpr ForceEffect kEffect{
    "friction_velocity",
    "viscous and Stribeck friction",
    "mu + (mu_s - mu) exp(-|v|/v_s) + kappa |v|",
    "the same grip does more damage at the speed where friction is larger",
    pulls_alone,
    parameters,
    [](Numbers numbers, ForceValues& values) {
      values.viscous_friction_s_m = numbers[0];
      values.stribeck_friction = numbers[1];
      values.stribeck_velocity_m_s = numbers[2];
    },
    written<parameters>,
    ForceEffect::Of::friction};

}  // namespace stribeck

namespace load {

/// A third is the contact of bodies that yield. Friction that rises little as the load does is one
/// that does not depend on it.
Parameters parameters(const ForceScales& /*scales*/) {
  constexpr double kMost = 0.7;
  return {{"load_exponent", "1", -kMost, kMost, {0.1}}};
}

constexpr ForceEffect kEffect{
    "friction_load",
    "load-dependent friction",
    "mu (|T|/T_0)^-k",
    "friction relative to load falls as load rises, so that mu from light tests overstates the "
    "damage of heavy use",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.load_exponent = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::friction};

}  // namespace load

namespace position {

Parameters parameters(const ForceScales& /*scales*/) {
  Parameters all;
  for (std::size_t harmonic = 1; harmonic <= ForceValues::kHarmonics; ++harmonic) {
    const std::string number = std::to_string(harmonic);
    all.push_back({"position_sine_" + number, "1", -1, 1, {0.01}});
    all.push_back({"position_cosine_" + number, "1", -1, 1, {0.01}});
  }
  return all;
}

/// a sin(k (x - m)) + b cos(k (x - m)) as a sum of sin(kx) and cos(kx); a table has six of them.
Extension about_zero(std::string_view id, Numbers numbers, const ForceScales& scales) {
  constexpr std::size_t kWritten = 6;
  Extension extension{std::string(id), {}};
  for (std::size_t harmonic = 1; harmonic <= kWritten; ++harmonic) {
    const std::size_t at = 2 * harmonic - 2;
    const double sine = at < numbers.size() ? numbers[at] : 0;
    const double cosine = at < numbers.size() ? numbers[at + 1] : 0;
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

constexpr ForceEffect kEffect{"friction_position",
                              "position-dependent friction",
                              "mu (1 + g(x)), F (1 + g(x))",
                              "damage gathers where the stroke meets more friction",
                              nullptr,
                              parameters,
                              [](Numbers numbers, ForceValues& values) {
                                std::ranges::copy(numbers, values.harmonics.begin());
                              },
                              about_zero,
                              ForceEffect::Of::friction};

}  // namespace position

namespace presliding {

Parameters parameters(const ForceScales& scales) {
  const double stroke_m = scales.stroke_m;
  return {{"presliding_length_m",
           "m",
           5e-4 * stroke_m,
           0.5 * stroke_m,
           {0.01 * stroke_m, 0.05 * stroke_m, 0.15 * stroke_m}}};
}

constexpr ForceEffect kEffect{
    "presliding",
    "presliding",
    "s becomes z, dz/dx = (sgn(dx) - z)/l",
    "short strokes see less friction than long ones",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.presliding_m = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::friction};

}  // namespace presliding

namespace elastic_presliding {

/// A length that friction turns over by is how far it stretches a tendon of this stiffness.
Parameters parameters(const ForceScales& scales) {
  return {stiffness("presliding_stiffness_N_m", scales, {0.3, 5, 100})};
}

constexpr ForceEffect kEffect{
    "presliding",
    "presliding over a length that grows with friction",
    "s becomes z, dz/dx = (sgn(dx) - z) k/F, F the friction that is turned over",
    "short strokes see less friction than long ones, at a high load more so",
    pulls_alone,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.presliding_N_m = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction};

}  // namespace elastic_presliding

}  // namespace

constinit const ForceEffect kPreload = preload::kEffect;
constinit const ForceEffect kVelocity = velocity::kEffect;
constinit const ForceEffect kStribeck = stribeck::kEffect;
constinit const ForceEffect kLoad = load::kEffect;
constinit const ForceEffect kPosition = position::kEffect;
constinit const ForceEffect kPresliding = presliding::kEffect;
constinit const ForceEffect kElasticPresliding = elastic_presliding::kEffect;

}  // namespace host_sim::diagnose::laws
