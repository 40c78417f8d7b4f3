#pragma once

/// The equations of the life model in double precision, one function each. Numbers in parentheses
/// are those of "Reliability analysis of a tendon-driven actuation for soft robots". Angles are in
/// radians, tensions in newtons. No function checks its arguments: each states its domain.
namespace host_sim::reference {

/// Input-output efficiency of the sheath, (14): exp(-mu * phi), in (0, 1].
/// @param friction_coefficient mu >= 0
/// @param bend_angle_rad phi >= 0, summed over the whole path
double capstan_efficiency(double friction_coefficient, double bend_angle_rad);

struct MeanAmplitude {
  double mean_N;
  double amplitude_N;
};

/// Mean and amplitude of the input tension from those of the output tension, (12) and (13).
/// @param efficiency in (0, 1], see capstan_efficiency()
MeanAmplitude input_tension_range(const MeanAmplitude& output, double efficiency);

enum class Direction { kPulling, kReleasing };

/// Direction of travel: pulling while the velocity is positive, releasing while it is negative; at
/// zero velocity the last direction stays.
Direction direction_of(double tendon_velocity_m_s, Direction last);

/// Input tension that goes with an output tension, (4) solved for T_in at full slip: the output
/// tension over the efficiency while pulling, times the efficiency while releasing.
double input_tension_from_output(double output_tension_N, double efficiency, Direction direction);

struct Drive {
  double torque_constant_Nm_per_A;
  double gear_ratio;
  double gear_efficiency;
  double spool_radius_m;
  double current_offset_A;
};

/// Input tension from motor current: K_t * (I - I_0) * N * eta_g / r_spool, in both directions.
double input_tension_from_current(double motor_current_A, const Drive& drive);

/// Gerber's effective tension, (8) and (11): T_a / (1 - (T_m / T_u)^2).
/// Zero for zero amplitude; +infinity for a positive amplitude where |T_m| >= T_u.
double gerber_effective_tension(const MeanAmplitude& input, double ultimate_tension_N);

/// Weibull scale in cycles at an effective tension, the inverse power law (19): A / T_eff^gamma.
/// +infinity at zero tension.
double ipl_life_cycles(double effective_tension_N, double ipl_scale, double ipl_exponent);

/// Probability that the wire is whole at this damage, from (15): exp(-D^beta), for D >= 0.
double weibull_survival(double damage, double weibull_shape);

/// Damage at which the given fraction has failed, (22) with the life in units of alpha:
/// (-ln(1 - x))^(1/beta), for x in [0, 1). B10 is x = 0.1.
double weibull_life_damage(double failed_fraction, double weibull_shape);

/// Mean damage at failure, (21) with the life in units of alpha: Gamma(1 + 1/beta).
double weibull_mean_damage(double weibull_shape);

/// What a wire that is whole at `damage` takes until the given fraction of its like has broken,
/// from (15): d with (D + d)^beta = D^beta - ln(1 - x). Equals weibull_life_damage() at zero
/// damage.
/// @param risk x in [0, 1)
double weibull_further_damage(double damage, double risk, double weibull_shape);

/// Probability that a wire which is whole at `damage` has broken after a `further` one, from (15):
/// 1 - exp(-((D + d)^beta - D^beta)), for damages >= 0.
double weibull_break_risk(double damage, double further, double weibull_shape);

}  // namespace host_sim::reference
