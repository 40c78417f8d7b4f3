#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "host_sim/effects/tension/law.hpp"

/// Laws of friction, which are approximations of each other.
namespace host_sim::effects::laws {
namespace {

/// kappa of laws of the speed.
ForceParameter viscous_friction(const ForceScales& scales) {
  const double speed_m_s = scales.speed_m_s;
  return usual(0.05 / speed_m_s,
               {"viscous_friction_s_m", "s/m", -1 / speed_m_s, 1 / speed_m_s, {0.01 / speed_m_s}});
}

namespace preload {

constexpr TableKey kTable[] = {{{"preload_N", "N", {0, 1e6}}}};

constexpr Separation kSeparations[] = {{"current_offset",
                                        "move in both directions at low and at high tension: an "
                                        "offset of the sensor does not change sign with s"},
                                       {"friction_load", "measure at low and at high tension"}};

constexpr TensionEffect kEffect{"friction_preload",
                                "load-independent (Coulomb) friction of seals and sheath preload",
                                "adds F to the amplitude of input tension at each reversal, most "
                                "of all in relative terms at low tension, where lives are long",
                                kTable, kSeparations};

Parameters parameters(const ForceScales& scales) {
  return {usual(0.05 * scales.larger_N(),
                {"preload_N", "N", 0, 10 * scales.larger_N(), {0.2 * scales.larger_N()}})};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "+ F s",
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.preload_N = numbers[0]; },
    .written = written<parameters>,
    .of = ForceLaw::Of::friction,
    .by = ForceLaw::By::load,
    .constant = true};

}  // namespace preload

namespace velocity {

constexpr TableKey kTable[] = {{{"stribeck_friction", "", {-0.5, 0.5}}, TableKey::kUnknown},
                               {{"viscous_friction_s_m", "s_m", {-80, 80}}, TableKey::kUnknown},
                               {{"stribeck_velocity_m_s", "m_s", {0.002, 0.1}}, TableKey::kUnknown},
                               {{"viscous_N_s_m", "N_s_m", {0, 1e8}}, TableKey::kUnknown}};

constexpr Separation kSeparations[] = {
    {"filter_lag", "run at constant speed, several speeds at the same tension"},
    {"friction_position", "run over the same positions at several constant speeds"}};

constexpr TensionEffect kEffect{"friction_velocity", "viscous and Stribeck friction",
                                "the same grip does more damage at the speed where friction is "
                                "larger: input tension goes with exp(mu(v) phi)",
                                kTable, kSeparations};

Parameters viscous_parameters(const ForceScales& scales) {
  const double force_N = scales.larger_N();
  const double speed_m_s = scales.speed_m_s;
  return {{"viscous_N_s_m", "N s/m", 0, 10 * force_N / speed_m_s, {0.05 * force_N / speed_m_s}},
          viscous_friction(scales)};
}

constexpr ForceLaw kViscous{.effect = &kEffect,
                            .own_term = "viscous friction",
                            .equation = "+ (c + kappa phi |T|) |v| s",
                            .parameters = viscous_parameters,
                            .set =
                                [](Numbers numbers, ForceValues& values) {
                                  values.viscous_N_s_m = numbers[0];
                                  values.viscous_friction_s_m = numbers[1];
                                },
                            .written = written<viscous_parameters>,
                            .of = ForceLaw::Of::friction,
                            .by = ForceLaw::By::speed};

/// A model that is written has the velocity within these bounds. Slower than friction turns over it
/// would be that.
Parameters stribeck_parameters(const ForceScales& scales) {
  constexpr double kLeast_m_s = 0.002;
  constexpr double kMost_m_s = 0.1;
  const double speed_m_s = scales.speed_m_s;
  const double least_m_s = std::max(kLeast_m_s, 2 * scales.turn_over_m_s);
  if (least_m_s >= kMost_m_s) {
    return {};
  }
  return {
      viscous_friction(scales),
      usual(0.05, {"stribeck_friction", "1", -0.5, 0.5, {0.02}}),
      {"stribeck_velocity_m_s", "m/s", least_m_s, kMost_m_s, {0.1 * speed_m_s, 0.3 * speed_m_s}}};
}

constexpr ForceLaw kStribeck{.effect = &kEffect,
                             .equation = "mu + (mu_s - mu) exp(-|v|/v_s) + kappa |v|",
                             .missing = needs_one_tendon,
                             .parameters = stribeck_parameters,
                             .set =
                                 [](Numbers numbers, ForceValues& values) {
                                   values.viscous_friction_s_m = numbers[0];
                                   values.stribeck_friction = numbers[1];
                                   values.stribeck_velocity_m_s = numbers[2];
                                 },
                             .written = written<stribeck_parameters>,
                             .of = ForceLaw::Of::friction,
                             .by = ForceLaw::By::speed};

}  // namespace velocity

namespace load {

constexpr TableKey kTable[] = {{{"load_exponent", "", {-1, 1}}}};

constexpr Separation kSeparations[] = {{"current_offset", "vary the bend angle at one tension"},
                                       {"friction_preload", "measure at low and at high tension"}};

constexpr TensionEffect kEffect{"friction_load", "load-dependent friction",
                                "friction relative to load falls as load rises, so that mu from "
                                "light tests overstates the damage of heavy use",
                                kTable, kSeparations};

/// A third is the contact of bodies that yield. Friction that rises little as the load does is one
/// that does not depend on it.
Parameters parameters(const ForceScales& /*scales*/) {
  constexpr double kMost = 0.7;
  return {usual(0.2, {"load_exponent", "1", -kMost, kMost, {0.1}})};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "mu (|T|/T_0)^-k",
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.load_exponent = numbers[0]; },
    .written = written<parameters>,
    .of = ForceLaw::Of::friction,
    .by = ForceLaw::By::load};

}  // namespace load

namespace position {

constexpr TableKey kTable[] = {
    {{"position_sine_1", "", {-1, 1}}},     {{"position_cosine_1", "", {-1, 1}}},
    {{"position_sine_2", "", {-1, 1}}},     {{"position_cosine_2", "", {-1, 1}}},
    {{"position_sine_3", "", {-1, 1}}},     {{"position_cosine_3", "", {-1, 1}}},
    {{"position_sine_4", "", {-1, 1}}},     {{"position_cosine_4", "", {-1, 1}}},
    {{"position_sine_5", "", {-1, 1}}},     {{"position_cosine_5", "", {-1, 1}}},
    {{"position_sine_6", "", {-1, 1}}},     {{"position_cosine_6", "", {-1, 1}}},
    {{"direction_sine_1", "", {-1, 1}}, 0}, {{"direction_cosine_1", "", {-1, 1}}, 0},
    {{"direction_sine_2", "", {-1, 1}}, 0}, {{"direction_cosine_2", "", {-1, 1}}, 0},
    {{"wavelength_m", "m", {0, 100, true}}}};

constexpr Separation kSeparations[] = {
    {"torque_ripple", "repeat the stroke at several loads"},
    {"friction_velocity", "run over the same positions at several constant speeds"}};

constexpr TensionEffect kEffect{"friction_position",
                                "position-dependent friction of features along the route",
                                "wire that dwells on the tight part of the route sees a larger "
                                "amplitude than the mean mu gives",
                                kTable, kSeparations};

Parameters parameters(const ForceScales& /*scales*/) {
  Parameters all;
  for (std::size_t harmonic = 1; harmonic <= ForceValues::kHarmonics; ++harmonic) {
    const std::string number = std::to_string(harmonic);
    all.push_back(usual(0.1, {"position_sine_" + number, "1", -1, 1, {0.01}}));
    all.push_back(usual(0.1, {"position_cosine_" + number, "1", -1, 1, {0.01}}));
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
    const double phase = 2 * std::numbers::pi * static_cast<double>(harmonic) * scales.position_m /
                         scales.wavelength_m();
    const std::string number = std::to_string(harmonic);
    extension.values.push_back(
        {"position_sine_" + number, {sine * std::cos(phase) + cosine * std::sin(phase)}});
    extension.values.push_back(
        {"position_cosine_" + number, {cosine * std::cos(phase) - sine * std::sin(phase)}});
  }
  extension.values.push_back({"wavelength_m", {scales.wavelength_m()}});
  return extension;
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "mu (1 + g(x)), F (1 + g(x))",
    .parameters = parameters,
    .set = [](Numbers numbers,
              ForceValues& values) { std::ranges::copy(numbers, values.harmonics.begin()); },
    .written = about_zero,
    .of = ForceLaw::Of::friction};

std::string_view needs_integrals(const ForceRecord& record) {
  return record.rotor_known ? "the rotor shows where the tendon is" : "";
}

/// An integral of the velocity starts anew with each record: strokes may have an end in common, or
/// their middle.
constexpr ForceLaw kAboutMiddle{
    .effect = &kEffect,
    .own_term = "position-dependent friction, from the middle of each stroke",
    .equation = "mu (1 + g(x - m)), F (1 + g(x - m)), m the middle of each record",
    .missing = needs_integrals,
    .parameters = parameters,
    .set =
        [](Numbers numbers, ForceValues& values) {
          kLaw.set(numbers, values);
          values.from_middle = true;
        },
    .of = ForceLaw::Of::friction};

}  // namespace position

namespace presliding {

constexpr TableKey kTable[] = {{{"presliding_share", "", {0, 1}}, TableKey::kUnknown},
                               {{"presliding_length_m", "m", {0, 1, true}}}};

constexpr Separation kSeparations[] = {
    {"slack", "step the pretension: slack closes, presliding stays"},
    {"compliance", "reverse at two loads and two poses"}};

constexpr TensionEffect kEffect{
    "presliding", "Dahl or LuGre hysteresis",
    "strokes shorter than d never build up the full friction, so that small cycles of input "
    "tension are smaller than the Capstan law makes them",
    kTable, kSeparations};

Parameters length_parameters(const ForceScales& scales) {
  const double stroke_m = scales.stroke_m;
  return {{"presliding_length_m",
           "m",
           5e-4 * stroke_m,
           0.5 * stroke_m,
           {0.01 * stroke_m, 0.05 * stroke_m, 0.15 * stroke_m}}};
}

constexpr ForceLaw kOverLength{
    .effect = &kEffect,
    .own_term = "presliding",
    .equation = "s becomes z, dz/dx = (sgn(dx) - z)/l",
    .parameters = length_parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.presliding_m = numbers[0]; },
    .written = written<length_parameters>,
    .of = ForceLaw::Of::friction};

/// A length that friction turns over by is how far it stretches a tendon of this stiffness.
Parameters stiffness_parameters(const ForceScales& scales) {
  return {stiffness("presliding_stiffness_N_m", scales, {0.3, 5, 100})};
}

constexpr ForceLaw kByStiffness{
    .effect = &kEffect,
    .own_term = "presliding over a length that grows with friction",
    .equation = "s becomes z, dz/dx = (sgn(dx) - z) k/F, F the friction that is turned over",
    .missing = needs_one_tendon,
    .parameters = stiffness_parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.presliding_N_m = numbers[0]; },
    .of = ForceLaw::Of::friction};

}  // namespace presliding

}  // namespace

constinit const ForceLaw kPreload = preload::kLaw;
constinit const ForceLaw kVelocity = velocity::kViscous;
constinit const ForceLaw kStribeck = velocity::kStribeck;
constinit const ForceLaw kLoad = load::kLaw;
constinit const ForceLaw kPosition = position::kLaw;
constinit const ForceLaw kPositionFromMiddle = position::kAboutMiddle;
constinit const ForceLaw kPresliding = presliding::kOverLength;
constinit const ForceLaw kElasticPresliding = presliding::kByStiffness;

}  // namespace host_sim::effects::laws
