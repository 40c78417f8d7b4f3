#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/effects/tension/force_record.hpp"
#include "host_sim/effects/tension/tension_effect.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim::effects {

/// Effects of the catalogue that the forward model runs, a law each: an effect may have several.
/// The last ones are outside of it: what could imitate an effect, and is never named.
enum class ForceTerm : unsigned {
  preload,
  velocity,
  presliding,
  elastic_presliding,
  stribeck,
  load,
  position,
  position_from_middle,
  slack,
  loose_tendon,
  compliance,
  lag,
  delay,
  zero,
  temperature,
  wear,
  run_in,
  bend_angle,
  current_offset,
  gear_asymmetry,
  torque_gain,
  torque_ripple,
  friction_by_load,
  friction_by_speed,
  giving_sheath,
  one_way_friction,
  bent_sensor,
  drifting_gain,
  warm_sensor,
};
inline constexpr std::size_t kForceTermCount = 29;
inline constexpr auto kForceTerms = [] {
  std::array<ForceTerm, kForceTermCount> all{};
  for (unsigned i = 0; i < kForceTermCount; ++i) {
    all[i] = static_cast<ForceTerm>(i);
  }
  return all;
}();
using ForceTerms = std::vector<ForceTerm>;

/// A parameter with bounds of physics, and what a fit tries to start with.
struct ForceParameter {
  std::string name;  ///< with its unit as suffix
  std::string_view unit;
  double minimum = 0;
  double maximum = 0;
  std::vector<double> starts;
  bool stepped = false;  ///< samples lie on one side of it or the other, and it between them
  bool chosen = false;   ///< one of its starts, which no fit moves
  double resolved = 0;   ///< less than that is none: the motion between samples is not known
  bool beside = false;   ///< may lie at a bound: the effect is there without it
  double usual = 0;      ///< size of a usual effect, with the sign of its start; 0: as it starts
};

/// What to move a parameter by for a derivative of the force: over many samples where it lies
/// between them, and away from its bound.
double step_of(const ForceParameter& parameter, double value);

/// Gain and friction coefficient, and what effects add to them: the model by its physics. What no
/// term sets has no effect.
struct ForceValues {
  static constexpr std::size_t kHarmonics = 5;

  double gain = 1;
  double friction = 0;
  double preload_N = 0;
  double viscous_N_s_m = 0;
  double viscous_friction_s_m = 0;
  double stribeck_friction = 0;
  double stribeck_velocity_m_s = 1;
  double presliding_m = 0;
  double presliding_N_m = 0;  ///< of a length that is in proportion to the friction
  double load_exponent = 0;
  std::array<double, 2 * kHarmonics> harmonics{};  ///< sine, cosine, of ForceScales::wavelength_m()
  bool from_middle = false;                        ///< of each record, and not of all
  double evenly = 0;                               ///< as much more of it at any place
  double slack_m = 0;
  double loose_m = 0;
  double loose_log_drop = 0;
  double loose_friction = 1;
  double stiffness_N_m = 0;
  double lag_s = 0;    ///< of the output sensor; below 0 of the input's
  double delay_s = 0;  ///< the same, of samples that are as they were
  double zero_N = 0;
  double temperature_1_K = 0;
  double wear = 0;
  double wear_exponent = 1;
  double run_in = 0;
  double run_in_cycles = 1;
  std::span<const double> pose_errors_rad;  ///< by ForceScales::poses_rad; the last one has none
  double current_offset_A = 0;
  double gear_asymmetry = 0;
  double droop_1_K = 0;
  double ripple_sine_A = 0;
  double ripple_cosine_A = 0;
  double ripple_harmonic = 0;
  /// Of the friction, more of it at loads and speeds of knots than at that in between which is 1.
  std::array<double, 3> by_load{};
  std::array<double, 3> by_speed{};
  double giving_share = 0;   ///< of the bend angle, as the load doubles from ForceScales::force_N
  double one_way_share = 0;  ///< of all friction, more of it one way and less the other
  double bent_share = 0;   ///< of the output force at ForceScales::force_N, that grows as its cube
  double drift_share = 0;  ///< of the input force, in the course of a session
  double drift_s = 1;      ///< its time constant
  double warm_N_K = 0;     ///< of the input force
};

/// One law of an effect: what it needs, its parameters and what it does to the predicted force.
struct ForceLaw {
  const TensionEffect* effect = nullptr;
  std::string_view own_term = {};  ///< where its effect has several laws
  std::string_view equation = {};
  /// What is missing in a record, in words; empty where it holds what the law needs. Null: any
  /// record does.
  std::string_view (*missing)(const ForceRecord& record) = nullptr;
  std::vector<ForceParameter> (*parameters)(const ForceScales& scales) = nullptr;
  /// Takes parameters() into the model.
  void (*set)(std::span<const double> parameters, ForceValues& values) = nullptr;
  /// Its table in a model that is written; null where no model holds it.
  Extension (*written)(std::string_view id, std::span<const double> parameters,
                       const ForceScales& scales) = nullptr;
  /// Of what it is a law. Those of friction are approximations, and another of them may take up a
  /// part of what one leaves. Two of when a channel is read together smooth its noise, which gains
  /// by itself. What sessions differ in, their place in the tendon's life, pose and temperature,
  /// moves them as wholes.
  enum class Of { sensor, friction, time, session } of = Of::sensor;
  /// What friction depends on by it, where it does on load or speed: friction that depends on the
  /// same in another way is called the same.
  enum class By { nothing, load, speed } by = By::nothing;
  bool outside = false;  ///< not of the catalogue
  /// Whether it is one force at any load and speed, but for its direction.
  bool constant = false;

  [[nodiscard]] std::string_view id() const { return effect->id; }
  [[nodiscard]] std::string_view term() const { return own_term.empty() ? effect->term : own_term; }
};
const ForceLaw& law_of(ForceTerm term);

/// Whether friction has a memory of the motion by it, and does not turn over at once.
constexpr bool remembers_motion(ForceTerm term) {
  return term == ForceTerm::presliding || term == ForceTerm::elastic_presliding ||
         term == ForceTerm::compliance;
}

/// What is missing for a term in one of the records, in words; empty where nothing is.
std::string_view missing_of(ForceTerm term, std::span<const ForceRecord> records);

/// Whether the records hold what a term needs.
inline bool is_shown(ForceTerm term, std::span<const ForceRecord> records) {
  return missing_of(term, records).empty();
}
std::vector<ForceParameter> parameters_of(ForceTerm term, const ForceScales& scales);

/// Gain and friction coefficient, then the parameters of each term in order.
std::vector<ForceParameter> parameters_of(const ForceTerms& terms, const ForceScales& scales);

/// The part of all parameters that one of the terms has.
std::span<const double> parameters_at(std::size_t place, const ForceTerms& terms,
                                      std::span<const double> parameters,
                                      const ForceScales& scales);

/// The table of a term of a model; none of what a written model cannot hold.
std::optional<Extension> written_term(ForceTerm term, std::span<const double> parameters,
                                      const ForceScales& scales);

/// T_in = gain (T_out + friction), where friction works against the motion, the sheath's in
/// proportion to |T| along it, which is eq. (14) of the paper where mu is the same for all T.
/// @param kinematics of the record by the scales
/// @param parameters as parameters_of(terms, scales)
/// @param input_N takes the input force of each sample
void predict_input(const ForceRecord& record, const Kinematics& kinematics, const ForceTerms& terms,
                   const ForceScales& scales, std::span<const double> parameters,
                   std::vector<double>& input_N);

/// Derivatives of that force by the parameters of a law of friction by position, sooner than by
/// steps of each: those of a sample in proportion to the waves there.
/// @param at_N that force
/// @param place of the term
/// @param slopes_N takes all of the first sample, then of the next
/// @returns whether the term is one, and no memory of friction makes a sample depend on others
bool position_slopes(const ForceRecord& record, const Kinematics& kinematics,
                     const ForceTerms& terms, const ForceScales& scales,
                     std::span<const double> parameters, std::span<const double> at_N,
                     std::size_t place, std::vector<double>& slopes_N);

}  // namespace host_sim::effects
