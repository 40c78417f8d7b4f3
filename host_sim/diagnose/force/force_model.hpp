#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace host_sim::diagnose {

/// One session in newtons: every sample in order, forces signed. Vectors are of one length.
struct ForceRecord {
  std::string session;
  std::vector<double> time_s;
  std::vector<double> input_N;
  std::vector<double> output_N;
  std::vector<double> output_rate_N_s;  ///< d T_out/dt over the five samples around each
  std::vector<double> velocity_m_s;
  std::vector<double> position_m;
  std::vector<double> bend_angle_rad;
  std::vector<double> sheath_temperature_C;  ///< empty where no session varies in it
  std::vector<bool> used;    ///< whether it counts; motion goes on where it does not
  double input_N_per_A = 0;  ///< of a motor current, which the input force is of; 0: a load cell
  bool rotor_known = false;  ///< the position is that of the rotor and not an integral

  [[nodiscard]] std::size_t samples() const { return time_s.size(); }
};

/// What terms are measured by, of all records together.
struct ForceScales {
  double speed_m_s = 0;   ///< nine tenths of all samples are slower
  double stroke_m = 0;    ///< between the 1 % and the 99 % quantile of the position
  double position_m = 0;  ///< the middle between these
  double force_N = 0;     ///< root mean square of the output force
  /// Of velocity: below it the direction of friction is not settled, by what it was measured with.
  double turn_over_m_s = 0;
};
ForceScales scales_of(std::span<const ForceRecord> records);

/// Effects of the catalogue that the forward model runs.
enum class ForceTerm : unsigned {
  preload,
  velocity,
  presliding,
  load,
  position,
  slack,
  compliance,
  lag,
  zero,
  temperature,
  current_offset,
  gear_asymmetry,
};
inline constexpr std::size_t kForceTermCount = 12;
using ForceTerms = std::vector<ForceTerm>;

/// A parameter with bounds of physics, and what a fit tries to start with.
struct ForceParameter {
  std::string_view name;  ///< with its unit as suffix
  std::string_view unit;
  double minimum = 0;
  double maximum = 0;
  std::vector<double> starts;
  bool stepped = false;  ///< samples lie on one side of it or the other, and it between them
};

struct ForceTermDefinition {
  std::string_view id;  ///< as in the catalogue of effects
  std::string_view term;
  std::string_view equation;
  std::string_view life_consequence;
};
const ForceTermDefinition& definition_of(ForceTerm term);
/// Whether the records hold what a term needs.
bool is_shown(ForceTerm term, std::span<const ForceRecord> records);
std::vector<ForceParameter> parameters_of(ForceTerm term, const ForceScales& scales);

/// Gain and friction coefficient, then the parameters of each term in order.
std::vector<ForceParameter> parameters_of(const ForceTerms& terms, const ForceScales& scales);

/// T_in = gain (T_out + friction), where friction works against the motion, the sheath's in
/// proportion to |T| along it, which is eq. (14) of the paper where mu is the same for all T.
/// @param parameters as parameters_of(terms, scales)
/// @param input_N takes the input force of each sample
void predict_input(const ForceRecord& record, const ForceTerms& terms, const ForceScales& scales,
                   std::span<const double> parameters, std::vector<double>& input_N);

}  // namespace host_sim::diagnose
