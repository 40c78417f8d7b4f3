#pragma once

#include <cstdint>

#include "lifemodel/extension/drive.hpp"
#include "lifemodel/extension/effective_tension.hpp"
#include "lifemodel/extension/empirical.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/extension/sheath.hpp"

namespace lifemodel::extension {

/// Effects that are evaluated on line. The number of each is part of the format of the block.
enum class Effect : std::uint32_t {
  bend_angle,
  current_offset,
  input_lag,   ///< of the current
  output_lag,  ///< of the output tension
  friction_load,
  friction_position,
  friction_preload,
  friction_temperature,
  friction_velocity,
  friction_wear,
  gear_asymmetry,
  torque_gain,
  torque_ripple,
  mean_stress,
  bending_fatigue,
  endurance_limit,
  presliding,
  viscous_force,  ///< of friction_velocity
  load_cell_zero,
  empirical,  ///< a correction
};
inline constexpr std::uint32_t kEffects = 20;

/// What extends the nominal model of one tendon, in fixed point. Without effects it changes
/// nothing.
struct Extension {
  std::uint32_t effects = 0;  ///< a bit for each Effect

  BendAngle bend_angle;
  CurrentOffset current_offset;
  FilterLag input_lag;
  FilterLag output_lag;
  FrictionLoad friction_load;
  FrictionPosition friction_position;
  FrictionPreload friction_preload;
  FrictionTemperature friction_temperature;
  FrictionVelocity friction_velocity;
  FrictionWear friction_wear;
  GearAsymmetry gear_asymmetry;
  TorqueGain torque_gain;
  TorqueRipple torque_ripple;
  MeanStress mean_stress;
  BendingFatigue bending_fatigue;
  EnduranceLimit endurance_limit;
  Presliding presliding;
  ViscousForce viscous_force;
  LoadCellZero load_cell_zero;
  Empirical empirical;

  [[nodiscard]] constexpr bool has(Effect effect) const {
    return (effects >> static_cast<std::uint32_t>(effect) & 1u) != 0;
  }
  constexpr void add(Effect effect) { effects |= 1u << static_cast<std::uint32_t>(effect); }

  /// Calls `what(effect, part)` for each effect there can be, in the order of their numbers.
  template <class What>
  constexpr void each(What&& what) {
    what(Effect::bend_angle, bend_angle);
    what(Effect::current_offset, current_offset);
    what(Effect::input_lag, input_lag);
    what(Effect::output_lag, output_lag);
    what(Effect::friction_load, friction_load);
    what(Effect::friction_position, friction_position);
    what(Effect::friction_preload, friction_preload);
    what(Effect::friction_temperature, friction_temperature);
    what(Effect::friction_velocity, friction_velocity);
    what(Effect::friction_wear, friction_wear);
    what(Effect::gear_asymmetry, gear_asymmetry);
    what(Effect::torque_gain, torque_gain);
    what(Effect::torque_ripple, torque_ripple);
    what(Effect::mean_stress, mean_stress);
    what(Effect::bending_fatigue, bending_fatigue);
    what(Effect::endurance_limit, endurance_limit);
    what(Effect::presliding, presliding);
    what(Effect::viscous_force, viscous_force);
    what(Effect::load_cell_zero, load_cell_zero);
    what(Effect::empirical, empirical);
  }
};

}  // namespace lifemodel::extension
