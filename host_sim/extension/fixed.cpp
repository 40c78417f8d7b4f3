#include "host_sim/extension/fixed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "hal/files/input_error.hpp"
#include "host_sim/extension/life.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/extension/tension.hpp"
#include "host_sim/model/model.hpp"
#include "lifemodel/pack/pack.hpp"

namespace host_sim {

using hal::files::InputError;

namespace {

namespace fixed = lifemodel::extension;
using fixed::Effect;

/// What tables of a model are taken into.
struct Target {
  const Model& model;
  std::string_view model_name;  ///< of its file, in errors
  fixed::Extension& extension;

  /// Of the ultimate tension, in steps of the target.
  [[nodiscard]] std::int32_t tension(double force_N) const {
    return lifemodel::pack::tension(force_N, model.cable.ultimate_tension_N).raw();
  }
};

/// The word nearest to a value with so many fractional bits; the ends of its range beyond them.
std::int32_t word(double value, int fraction_bits) {
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(
      std::clamp(std::nearbyint(std::ldexp(value, fraction_bits)), -kMost, kMost));
}

void add_wear(const Extension& e, const Target& target) {
  const double size = value_of(e, "wear_coefficient");
  const double exponent = value_of(e, "wear_exponent");
  constexpr double kLeast = 1e-15;
  fixed::FrictionWear wear;
  wear.log2_size = word(std::log2(std::max(std::abs(size), kLeast)), fixed::kExponentBits);
  wear.lowers = size < 0 ? 1 : 0;
  // An exponent that rounds to 0 would make it a run-in.
  wear.exponent = exponent > 0 ? std::max(1, word(exponent, fixed::kFactorBits)) : 0;
  if (exponent == 0) {
    wear.fading = word(std::numbers::log2e / (2 * value_of(e, "run_in_cycles")), 31);
  }
  target.extension.friction_wear = wear;
  target.extension.add(Effect::friction_wear);
}

void add_velocity(const Extension& e, const Target& target) {
  fixed::Extension& result = target.extension;
  const double stribeck = value_if(e, "stribeck_friction").value_or(0);
  const double viscous_s_m = value_if(e, "viscous_friction_s_m").value_or(0);
  const double viscous_N_s_m = value_if(e, "viscous_N_s_m").value_or(0);
  if (stribeck != 0 || viscous_s_m != 0) {
    // Where it is not given it is of no effect.
    const double speed_m_s = value_if(e, "stribeck_velocity_m_s").value_or(1);
    result.friction_velocity = {.stribeck = word(stribeck * std::numbers::log2e, 28),
                                .viscous = word(viscous_s_m * std::numbers::log2e, 24),
                                .log2_a_speed = word(std::numbers::log2e / speed_m_s, 16)};
    result.add(Effect::friction_velocity);
  }
  constexpr int kBits = lifemodel::Tension::kFractionBits - lifemodel::Velocity::kFractionBits;
  const auto factor = lifemodel::pack::factor(
      std::ldexp(viscous_N_s_m / target.model.cable.ultimate_tension_N, kBits));
  // What is too small for a factor moves no tension by a step.
  if (viscous_N_s_m != 0 && factor) {
    result.viscous_force = {*factor};
    result.add(Effect::viscous_force);
  }
}

void add_presliding(const Extension& e, const Target& target) {
  // In steps of velocity times samples; what is dropped of them leaves 24 bits of the length.
  const double length =
      std::ldexp(value_of(e, "presliding_length_m") * target.model.counting.sample_rate_Hz,
                 lifemodel::Velocity::kFractionBits);
  fixed::Presliding presliding;
  constexpr int kLengthBits = 24;
  presliding.drop = std::max(0, std::ilogb(length) - kLengthBits);
  const auto lengths = lifemodel::pack::factor(
      std::ldexp(std::numbers::log2e / length, fixed::kExponentBits + presliding.drop));
  if (!lengths) {
    throw InputError(
        target.model_name, 0, 0,
        fmt::format("presliding_length_m of [extension.presliding] times "
                    "sample_rate_Hz is {:.3g} m/s",
                    value_of(e, "presliding_length_m") * target.model.counting.sample_rate_Hz),
        "1e-9 m/s or more");
  }
  presliding.lengths = *lengths;
  presliding.share = word(value_if(e, "presliding_share").value_or(1), fixed::kFactorBits);
  target.extension.presliding = presliding;
  target.extension.add(Effect::presliding);
}

void add_load(const Extension& e, const Target& target) {
  const double ultimate_N = target.model.cable.ultimate_tension_N;
  constexpr double kReference_N = 50;
  constexpr double kLeastUltimate_N = kReference_N / 8;  // log2 of 50 N in steps is below 32 there
  if (!(ultimate_N > kLeastUltimate_N)) {
    throw InputError(
        target.model_name, 0, 0,
        fmt::format("ultimate_tension_N is {} with [extension.friction_load]", ultimate_N),
        fmt::format("more than {} N with it", kLeastUltimate_N));
  }
  // Below this a term of the series is all there is.
  constexpr double kLeastExponent = 0x1p-16;
  const double exponent = value_of(e, "load_exponent");
  fixed::FrictionLoad load;
  load.exponent = word(exponent, fixed::kFactorBits);
  load.log2_reference = word(std::log2(std::ldexp(kReference_N / ultimate_N, 29)), 26);
  load.inverse =
      *lifemodel::pack::factor(std::ldexp(1 / std::max(std::abs(exponent), kLeastExponent), -3));
  target.extension.friction_load = load;
  target.extension.add(Effect::friction_load);
}

/// Of the tendon, for a turn of the rotor.
double metres_a_turn(const Model::Drive& drive) {
  return 2 * std::numbers::pi * drive.spool_radius_m() / drive.gear_ratio;
}

void add_position(const Extension& e, const Target& target) {
  fixed::FrictionPosition position;
  for (std::size_t i = 0; i < position.harmonics.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    position.harmonics[i] = {word(value_of(e, "position_sine_" + number), 28),
                             word(value_of(e, "position_cosine_" + number), 28)};
  }
  const double waves = metres_a_turn(*target.model.drive) / value_of(e, "wavelength_m");
  constexpr double kMostWaves = 7.99;
  constexpr double kLeastWaves = 1e-6;
  if (!(waves >= kLeastWaves && waves <= kMostWaves)) {
    throw InputError(target.model_name, 0, 0,
                     fmt::format("wavelength_m of [extension.friction_position] is passed {:.3g} "
                                 "times in a turn of the rotor",
                                 waves),
                     fmt::format("{}..{} times", kLeastWaves, kMostWaves));
  }
  position.waves_a_turn = word(waves, 28);
  target.extension.friction_position = position;
  target.extension.add(Effect::friction_position);
}

void add_bend_angle(const Extension& e, const Target& target) {
  const std::span<const double> errors_rad = values_of(e, "bend_angle_error_rad");
  const std::span<const double> angles_deg = values_of(e, "bend_angles_deg");
  fixed::BendAngle bend;
  bend.poses = static_cast<std::int32_t>(errors_rad.size());
  for (std::size_t i = 0; i < errors_rad.size(); ++i) {
    const double angle_deg = i < angles_deg.size() ? angles_deg[i] : 0;
    bend.pose[i] = {
        lifemodel::pack::from_double<lifemodel::Angle>(angle_deg * std::numbers::pi / 180).raw(),
        word(errors_rad[i], lifemodel::Angle::kFractionBits)};
  }
  target.extension.bend_angle = bend;
  target.extension.add(Effect::bend_angle);
}

void add_lag(const Extension& e, const Target& target) {
  fixed::Extension& result = target.extension;
  const double periods = value_of(e, "lag_s") * target.model.counting.sample_rate_Hz;
  const fixed::FilterLag lag{.periods = word(std::abs(periods), 16)};
  if (periods > 0) {
    result.output_lag = lag;
    result.add(Effect::output_lag);
  } else if (periods < 0) {
    result.input_lag = lag;
    result.add(Effect::input_lag);
  }
}

/// Steps of the covariate at a unit of it.
double steps_of(fixed::Empirical::Covariate covariate, const Model& model) {
  using fixed::Empirical;
  const double speed = std::ldexp(1, lifemodel::Velocity::kFractionBits);
  switch (covariate) {
    case Empirical::output_tension:
      break;
    case Empirical::position:
      return std::ldexp(1, Empirical::kPositionBits) / metres_a_turn(*model.drive);
    case Empirical::speed:
      return speed;
    case Empirical::travel:
      return std::ldexp(speed * model.counting.sample_rate_Hz, -Empirical::kTravelDrop);
  }
  return std::ldexp(1 / model.cable.ultimate_tension_N, lifemodel::Tension::kFractionBits);
}

void add_empirical(const Extension& e, const Target& target) {
  const auto covariate = static_cast<fixed::Empirical::Covariate>(empirical_covariate(e));
  if (covariate == fixed::Empirical::position && !target.model.drive) {
    return;
  }
  const std::string_view name = kEmpiricalCovariates[empirical_covariate(e)].name;
  const std::span<const double> knots = values_of(e, name);
  const std::span<const double> pulling_N = values_of(e, "pulling_N");
  const std::span<const double> letting_go_N = values_of(e, "letting_go_N");
  const double steps = steps_of(covariate, target.model);
  fixed::Empirical& table = target.extension.empirical;
  table.covariate = covariate;
  table.knots = static_cast<std::int32_t>(knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    table.knot[i] = {word(knots[i] * steps, 0), target.tension(pulling_N[i]),
                     target.tension(letting_go_N[i])};
  }
  const double furthest = std::max(std::abs(knots.front()), std::abs(knots.back())) * steps;
  if (!table.plausible() || furthest > 0x1p31) {
    throw InputError(
        target.model_name, 0, 0,
        fmt::format("{} of [extension.empirical] has knots that are the same to the "
                    "target",
                    name),
        fmt::format("knots up to {:.3g} that are {:.3g} or more apart", 0x1p31 / steps, 1 / steps));
  }
  target.extension.add(Effect::empirical);
}

void add_bending(const Extension& e, const Target& target) {
  const auto amplitude_N = bending_amplitude_N(e);
  if (!amplitude_N) {
    return;
  }
  const double relative = *amplitude_N / target.model.cable.ultimate_tension_N;
  constexpr double kMost = 1.5;
  if (relative > kMost) {
    throw InputError(target.model_name, 0, 0,
                     fmt::format("bending_N * wire_to_bend_ratio of [extension.bending_fatigue] is "
                                 "{:.3g} of ultimate_tension_N",
                                 relative),
                     fmt::format("up to {}", kMost));
  }
  target.extension.bending_fatigue = {word(value_of(e, "bending_share"), fixed::kFactorBits),
                                      word(2 * relative, lifemodel::Tension::kFractionBits)};
  target.extension.add(Effect::bending_fatigue);
}

void add_limit(const Extension& e, const Target& target) {
  const auto limit_N = endurance_limit_N(e);
  if (!limit_N) {
    return;
  }
  constexpr double kLeast = 1e-9;
  const double relative = std::clamp(*limit_N / target.model.cable.ultimate_tension_N, kLeast, 1.0);
  target.extension.endurance_limit = {word(value_of(e, "endurance_share"), fixed::kFactorBits),
                                      word(std::log2(relative), lifemodel::numeric::kLogBits)};
  target.extension.add(Effect::endurance_limit);
}

/// How a table is taken into the target.
struct Packed {
  std::string_view id;
  void (*add)(const Extension& e, const Target& target);
  bool of_drive = false;  ///< it is of no effect without one
};

constexpr Packed kPacked[] = {
    {"bend_angle", add_bend_angle},
    {"bending_fatigue", add_bending},
    {"current_offset",
     [](const Extension& e, const Target& target) {
       target.extension.current_offset = {word(value_of(e, "current_offset_A"), 24)};
       target.extension.add(Effect::current_offset);
     },
     true},
    {kEmpirical, add_empirical},
    {"endurance_limit", add_limit},
    {"filter_lag", add_lag},
    {"friction_load", add_load},
    {"friction_position", add_position, true},
    {"friction_preload",
     [](const Extension& e, const Target& target) {
       target.extension.friction_preload.force = target.tension(value_of(e, "preload_N"));
       target.extension.add(Effect::friction_preload);
     }},
    {"friction_temperature",
     [](const Extension& e, const Target& target) {
       target.extension.friction_temperature = {
           word(value_of(e, "temperature_coefficient_1_K"), 30),
           word(value_of(e, "sheath_reference_C"), 16)};
       target.extension.add(Effect::friction_temperature);
     }},
    {"friction_velocity", add_velocity},
    {"friction_wear", add_wear},
    {"gear_asymmetry",
     [](const Extension& e, const Target& target) {
       target.extension.gear_asymmetry = {word(value_of(e, "gear_asymmetry"), fixed::kFactorBits)};
       target.extension.add(Effect::gear_asymmetry);
     },
     true},
    {"load_cell_zero",
     [](const Extension& e, const Target& target) {
       target.extension.load_cell_zero = {target.tension(value_of(e, "zero_N"))};
       target.extension.add(Effect::load_cell_zero);
     }},
    {"mean_stress",
     [](const Extension& e, const Target& target) {
       target.extension.mean_stress = {word(value_of(e, "mean_stress_share"), fixed::kFactorBits),
                                       word(value_of(e, "walker_exponent"), fixed::kFactorBits)};
       target.extension.add(Effect::mean_stress);
     }},
    {"presliding", add_presliding},
    {"torque_gain",
     [](const Extension& e, const Target& target) {
       target.extension.torque_gain = {word(value_of(e, "droop_1_K"), 30),
                                       word(value_of(e, "winding_reference_C"), 16)};
       target.extension.add(Effect::torque_gain);
     },
     true},
    {"torque_ripple",
     [](const Extension& e, const Target& target) {
       target.extension.torque_ripple = {word(value_of(e, "ripple_sine_A"), 24),
                                         word(value_of(e, "ripple_cosine_A"), 24),
                                         word(value_of(e, "ripple_harmonic"), 16)};
       target.extension.add(Effect::torque_ripple);
     },
     true},
};

}  // namespace

fixed::Extension fixed_extension(const Model& model, std::span<const Extension> extensions,
                                 std::string_view model_name) {
  fixed::Extension result;
  const Target target{model, model_name, result};
  for (const Extension& extension : extensions) {
    const auto* const packed = std::ranges::find(kPacked, extension.id, &Packed::id);
    if (packed != std::end(kPacked) && (model.drive || !packed->of_drive)) {
      packed->add(extension, target);
    }
  }
  return result;
}

}  // namespace host_sim
