#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/model/model.hpp"

namespace host_sim::diagnose {

/// One session in newtons: every sample in order, forces signed. Vectors are of one length, but for
/// those that may be empty where nothing measured them.
struct ForceRecord {
  std::string session;
  std::vector<double> time_s;
  std::vector<double> input_N;
  std::vector<double> output_N;
  std::vector<double> output_rate_N_s;  ///< d T_out/dt
  std::vector<double> velocity_m_s;
  std::vector<double> position_m;
  std::vector<double> reversal_m;  ///< where it turned since the sample before; else its position
  std::vector<double> bend_angle_rad;
  std::vector<double> sheath_temperature_C;   ///< empty where no session varies in it
  std::vector<double> winding_temperature_C;  ///< the same
  std::vector<double> rotor_rad;              ///< may be empty
  std::vector<double> cycle;                  ///< of the tendon's life; may be empty
  std::vector<bool> used;    ///< whether it counts; motion goes on where it does not
  double input_N_per_A = 0;  ///< of a motor current, which the input force is of; 0: a load cell
  bool rotor_known = false;  ///< the position is that of the rotor and not an integral
  bool pulls_alone = false;  ///< one tendon, whose force has one sign

  [[nodiscard]] std::size_t samples() const { return time_s.size(); }
  /// Mean time between samples. @pre one or more
  [[nodiscard]] double step_s() const {
    return (time_s.back() - time_s.front()) /
           static_cast<double>(std::max<std::size_t>(samples() - 1, 1));
  }
};

/// What terms are measured by, of all records together.
struct ForceScales {
  double speed_m_s = 0;   ///< nine tenths of all samples are slower
  double stroke_m = 0;    ///< between the 1 % and the 99 % quantile of the position
  double position_m = 0;  ///< the middle between these
  double force_N = 0;     ///< root mean square of the output force
  double input_N = 0;     ///< of the input force, which a drive that runs free has nearly alone
  /// Of velocity: below it the direction of friction is not settled, by what it was measured with.
  double turn_over_m_s = 0;
  double step_s = 0;              ///< mean time between samples
  double cycles = 0;              ///< the last of the tendon's life
  std::vector<double> poses_rad;  ///< mean bend angles of sessions that differ by a degree, rising

  [[nodiscard]] double larger_N() const { return std::max(force_N, input_N); }
};
ForceScales scales_of(std::span<const ForceRecord> records);

/// What each sample of a record has by its motion, whatever the parameters.
struct Kinematics {
  std::vector<double> turned_over;  ///< how far its speed turns friction over, -1 .. 1
  std::vector<std::size_t> pose;    ///< the nearest of ForceScales::poses_rad
  std::vector<double> stroke_sine, stroke_cosine;  ///< of its place in the stroke, a turn long
};

/// Where the motion turns between samples, on the parabola of their speeds, as reversal_m.
std::vector<double> reversals_m(const ForceRecord& record);

Kinematics kinematics_of(const ForceRecord& record, const ForceScales& scales);

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
  giving_sheath,
  one_way_friction,
  bent_sensor,
  drifting_gain,
  warm_sensor,
};
inline constexpr std::size_t kForceTermCount = 26;
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
};

/// Gain and friction coefficient, and what effects add to them: the model by its physics. What no
/// term sets has no effect.
struct ForceValues {
  static constexpr std::size_t kHarmonics = 4;

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
  std::array<double, 2 * kHarmonics> harmonics{};  ///< sine and cosine of each, of the stroke
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
  double giving_share = 0;   ///< of the bend angle, as the load doubles from ForceScales::force_N
  double one_way_share = 0;  ///< of all friction, more of it one way and less the other
  double bent_share = 0;   ///< of the output force at ForceScales::force_N, that grows as its cube
  double drift_share = 0;  ///< of the input force, in the course of a session
  double drift_s = 1;      ///< its time constant
  double warm_N_K = 0;     ///< of the input force
};

/// One law of an effect, with all that is known of it.
struct ForceEffect {
  std::string_view id;  ///< as in the catalogue of effects
  std::string_view term;
  std::string_view equation;
  std::string_view life_consequence;
  /// Whether a record holds what it needs; null: any does.
  bool (*shown)(const ForceRecord& record);
  std::vector<ForceParameter> (*parameters)(const ForceScales& scales);
  /// Takes parameters() into the model.
  void (*set)(std::span<const double> parameters, ForceValues& values);
  /// Its table in a model that is written; null where no model holds it.
  Extension (*written)(std::string_view id, std::span<const double> parameters,
                       const ForceScales& scales);
  /// Of what it is a law. Those of friction are approximations, and another of them may take up a
  /// part of what one leaves. Two of when a channel is read together smooth its noise, which gains
  /// by itself. What sessions differ in, their place in the tendon's life, pose and temperature,
  /// moves them as wholes.
  enum class Of { sensor, friction, time, session } of = Of::sensor;
  bool outside = false;  ///< not of the catalogue
};
const ForceEffect& definition_of(ForceTerm term);

/// Whether the records hold what a term needs.
bool is_shown(ForceTerm term, std::span<const ForceRecord> records);
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

/// The friction coefficient that a written model has beside these tables, for which
/// [extension.friction_load] is relative to 50 N.
double written_friction(double friction, std::span<const Extension> extensions,
                        const ForceScales& scales);

/// T_in = gain (T_out + friction), where friction works against the motion, the sheath's in
/// proportion to |T| along it, which is eq. (14) of the paper where mu is the same for all T.
/// @param kinematics of the record by the scales
/// @param parameters as parameters_of(terms, scales)
/// @param input_N takes the input force of each sample
void predict_input(const ForceRecord& record, const Kinematics& kinematics, const ForceTerms& terms,
                   const ForceScales& scales, std::span<const double> parameters,
                   std::vector<double>& input_N);

}  // namespace host_sim::diagnose
