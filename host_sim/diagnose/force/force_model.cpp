#include "host_sim/diagnose/force/force_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace host_sim::diagnose {
namespace {

constexpr std::size_t kHarmonics = 2;
constexpr double kUsualTurnOver = 0.05;  ///< of the scale of speed
constexpr double kMostLogRatio = 5;
/// Of the scale of force: where friction that depends on load stops to grow.
constexpr double kLeastLoad = 0.01;

constexpr std::array<ForceTermDefinition, kForceTermCount> kDefinitions{{
    {"friction_preload", "load-independent friction", "+ F s",
     "friction that does not fall with the load loads the tendon in every cycle, small ones most"},
    {"friction_velocity", "viscous friction", "+ (c + kappa phi |T|) |v| s",
     "fast strokes load the tendon more than slow ones of the same load"},
    {"presliding", "presliding", "s becomes z, dz/dx = (sgn(dx) - z)/l",
     "short strokes see less friction than long ones"},
    {"friction_load", "load-dependent friction", "mu (|T|/T_0)^-k",
     "friction relative to load falls as load rises, so that mu from light tests overstates the "
     "damage of heavy use"},
    {"friction_position", "position-dependent friction", "mu (1 + g(x)), F (1 + g(x))",
     "damage gathers where the stroke meets more friction"},
    {"slack", "backlash", "no friction within b of a reversal",
     "the tendon runs free at reversals, and shocks follow"},
    {"compliance", "sheath and tendon elasticity", "dT_in = k dx within what friction holds",
     "reversals of the friction come late, which changes small cycles"},
    {"filter_lag", "first-order lag of a sensor", "T_out + tau dT_out/dt",
     "peaks of fast cycles are read too low"},
    {"load_cell_zero", "zero of the output sensor", "T_out - b",
     "every tension is read too high or too low by the same force"},
    {"friction_temperature", "temperature-dependent friction", "all friction (1 + k (T - 20 C))",
     "a sheath that is warmer has another friction, and damage goes with it"},
    {"current_offset", "zero error of the current sensor", "I - b",
     "all input tensions are wrong by the same force: the mean moves and the amplitude stays"},
    {"gear_asymmetry", "direction-dependent gear efficiency", "eta_g (1 + c s)",
     "the amplitude of input tension is wrong by c times its mean, at every bend angle"},
}};

double quantile(std::vector<double>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// The parameters by their meaning; what no term sets has no effect.
struct Values {
  double gain = 1;
  double friction = 0;
  double preload_N = 0;
  double viscous_N_s_m = 0;
  double viscous_friction_s_m = 0;
  double presliding_m = 0;
  double load_exponent = 0;
  std::array<double, 2 * kHarmonics> harmonics{};
  double slack_m = 0;
  double stiffness_N_m = 0;
  double lag_s = 0;
  double zero_N = 0;
  double temperature_1_K = 0;
  double current_offset_A = 0;
  double gear_asymmetry = 0;

  Values(const ForceTerms& terms, std::span<const double> parameters) {
    auto next = parameters.begin();
    gain = *next++;
    friction = *next++;
    for (const ForceTerm term : terms) {
      switch (term) {
        case ForceTerm::preload:
          preload_N = *next++;
          break;
        case ForceTerm::velocity:
          viscous_N_s_m = *next++;
          viscous_friction_s_m = *next++;
          break;
        case ForceTerm::presliding:
          presliding_m = *next++;
          break;
        case ForceTerm::load:
          load_exponent = *next++;
          break;
        case ForceTerm::position:
          for (double& harmonic : harmonics) {
            harmonic = *next++;
          }
          break;
        case ForceTerm::slack:
          slack_m = *next++;
          break;
        case ForceTerm::compliance:
          stiffness_N_m = *next++;
          break;
        case ForceTerm::lag:
          lag_s = *next++;
          break;
        case ForceTerm::zero:
          zero_N = *next++;
          break;
        case ForceTerm::temperature:
          temperature_1_K = *next++;
          break;
        case ForceTerm::current_offset:
          current_offset_A = *next++;
          break;
        case ForceTerm::gear_asymmetry:
          gear_asymmetry = *next++;
          break;
      }
    }
  }

  [[nodiscard]] double position_factor(double turns) const {
    double factor = 1;
    if (harmonics == decltype(harmonics){}) {
      return factor;
    }
    for (std::size_t harmonic = 1; harmonic <= kHarmonics; ++harmonic) {
      const double phase = 2 * std::numbers::pi * static_cast<double>(harmonic) * turns;
      factor += harmonics[2 * harmonic - 2] * std::sin(phase) +
                harmonics[2 * harmonic - 1] * std::cos(phase);
    }
    return factor;
  }
};

/// How far friction is turned over, -1 .. 1, with its memory of the motion.
class Slip {
 public:
  Slip(const Values& values, const ForceScales& scales, double position_m)
      : values_(values), edge_m_s_(scales.turn_over_m_s), before_m_(position_m) {}

  double at(const ForceRecord& record, std::size_t i) {
    const double moved_m = record.position_m[i] - before_m_;
    before_m_ = record.position_m[i];
    double slip = std::tanh(record.velocity_m_s[i] / edge_m_s_);
    if (values_.slack_m > 0) {
      taken_up_ = std::clamp(taken_up_ + 2 * moved_m / values_.slack_m, -1.0, 1.0);
      slip = std::abs(taken_up_) == 1 && taken_up_ * slip > 0 ? slip : 0;
    }
    if (values_.presliding_m > 0) {
      const double side = moved_m > 0 ? 1 : moved_m < 0 ? -1 : presliding_;
      presliding_ =
          side + (presliding_ - side) * std::exp(-std::abs(moved_m) / values_.presliding_m);
      slip = presliding_;
    }
    return slip;
  }

 private:
  const Values& values_;
  double edge_m_s_;
  double before_m_;
  double taken_up_ = 0;
  double presliding_ = 0;
};

}  // namespace

ForceScales scales_of(std::span<const ForceRecord> records) {
  std::vector<double> speeds;
  std::vector<double> positions;
  double square_N2 = 0;
  for (const ForceRecord& record : records) {
    for (std::size_t i = 0; i < record.samples(); ++i) {
      speeds.push_back(std::abs(record.velocity_m_s[i]));
      positions.push_back(record.position_m[i]);
      square_N2 += record.output_N[i] * record.output_N[i];
    }
  }
  constexpr double kLeast = 1e-9;
  if (speeds.empty()) {
    return {kLeast, kLeast, 0, kLeast, kLeast};
  }
  const double low_m = quantile(positions, 0.01);
  const double high_m = quantile(positions, 0.99);
  const double speed_m_s = std::max(quantile(speeds, 0.9), kLeast);
  return {.speed_m_s = speed_m_s,
          .stroke_m = std::max(high_m - low_m, kLeast),
          .position_m = (high_m + low_m) / 2,
          .force_N = std::max(std::sqrt(square_N2 / static_cast<double>(speeds.size())), kLeast),
          .turn_over_m_s = kUsualTurnOver * speed_m_s};
}

const ForceTermDefinition& definition_of(ForceTerm term) {
  return kDefinitions[static_cast<std::size_t>(term)];
}

bool is_shown(ForceTerm term, std::span<const ForceRecord> records) {
  const bool of_temperature = term == ForceTerm::temperature;
  const bool of_current = term == ForceTerm::current_offset || term == ForceTerm::gear_asymmetry;
  return std::ranges::all_of(records, [&](const ForceRecord& one) {
    return (!of_temperature || !one.sheath_temperature_C.empty()) &&
           (!of_current || one.input_N_per_A > 0);
  });
}

std::vector<ForceParameter> parameters_of(ForceTerm term, const ForceScales& scales) {
  const double force_N = scales.force_N;
  const double speed_m_s = scales.speed_m_s;
  const double stroke_m = scales.stroke_m;
  switch (term) {
    case ForceTerm::preload:
      return {{"preload_N", "N", 0, 10 * force_N, {0.2 * force_N}}};
    case ForceTerm::velocity:
      return {{"viscous_N_s_m", "N s/m", 0, 10 * force_N / speed_m_s, {0.05 * force_N / speed_m_s}},
              {"viscous_friction_s_m", "s/m", -1 / speed_m_s, 1 / speed_m_s, {0.01 / speed_m_s}}};
    case ForceTerm::presliding:
      return {{"presliding_length_m",
               "m",
               1e-4 * stroke_m,
               0.5 * stroke_m,
               {0.01 * stroke_m, 0.05 * stroke_m, 0.15 * stroke_m}}};
    case ForceTerm::load:
      return {{"load_exponent", "1", -1, 1, {0.1}}};
    case ForceTerm::position:
      return {{"position_sine_1", "1", -1, 1, {0.01}},
              {"position_cosine_1", "1", -1, 1, {0.01}},
              {"position_sine_2", "1", -1, 1, {0.01}},
              {"position_cosine_2", "1", -1, 1, {0.01}}};
    case ForceTerm::slack:
      return {{"slack_m",
               "m",
               0,
               0.3 * stroke_m,
               {0.01 * stroke_m, 0.03 * stroke_m, 0.1 * stroke_m},
               true}};
    case ForceTerm::compliance:
      return {{"stiffness_N_m",
               "N/m",
               0.1 * force_N / stroke_m,
               1e4 * force_N / stroke_m,
               {3 * force_N / stroke_m, 30 * force_N / stroke_m, 300 * force_N / stroke_m}}};
    case ForceTerm::lag:
      return {{"lag_s", "s", -0.1, 0.1, {0.005, -0.005}}};
    case ForceTerm::zero:
      return {{"load_cell_zero_N", "N", -force_N, force_N, {0.01 * force_N}}};
    case ForceTerm::temperature:
      return {{"temperature_coefficient_1_K", "1/K", -0.05, 0.05, {0.001}}};
    case ForceTerm::current_offset:
      return {{"current_offset_A", "A", -0.5, 0.5, {0.01}}};
    case ForceTerm::gear_asymmetry:
      return {{"gear_asymmetry", "1", -0.3, 0.3, {0.01}}};
  }
  return {};
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

namespace {

/// ln(T_in/T_out) of dT/dphi = mu (T/T_0)^-k T, for that of the output's friction all along.
double along_sheath(double log_ratio, double load_exponent) {
  constexpr double kLeast = 1e-9;  // nothing is left of the force
  return load_exponent == 0
             ? log_ratio
             : std::log1p(std::max(load_exponent * log_ratio, kLeast - 1)) / load_exponent;
}

/// Input force before the gain at one sample, for a friction that is turned over by `slip`.
double input_at(const ForceRecord& record, std::size_t i, const Values& values,
                const ForceScales& scales, double slip) {
  constexpr double kReference_C = 20;
  const double output_N =
      record.output_N[i] - values.zero_N + values.lag_s * record.output_rate_N_s[i];
  const double size_N = std::abs(output_N);
  const double speed_m_s = std::abs(record.velocity_m_s[i]);
  double factor =
      values.position_factor((record.position_m[i] - scales.position_m) / scales.stroke_m);
  if (values.temperature_1_K != 0) {
    factor *= 1 + values.temperature_1_K * (record.sheath_temperature_C[i] - kReference_C);
  }
  double log_ratio = (values.friction + values.viscous_friction_s_m * speed_m_s) * factor *
                     record.bend_angle_rad[i] * slip;
  if (values.load_exponent != 0) {
    log_ratio *= std::pow(std::max(size_N / scales.force_N, kLeastLoad), -values.load_exponent);
  }
  // A force the other way round is that of the other tendon, whose motion is the other way too.
  const double side = output_N < 0 ? -1 : 1;
  const double sheath_N =
      side * size_N *
      std::expm1(std::clamp(along_sheath(side * log_ratio, values.load_exponent), -kMostLogRatio,
                            kMostLogRatio));
  const double other_N = values.preload_N * factor + values.viscous_N_s_m * speed_m_s;
  return output_N + sheath_N + other_N * slip;
}

}  // namespace

void predict_input(const ForceRecord& record, const ForceTerms& terms, const ForceScales& scales,
                   std::span<const double> parameters, std::vector<double>& input_N) {
  const Values values(terms, parameters);
  input_N.resize(record.samples());
  if (input_N.empty()) {
    return;
  }
  Slip slips(values, scales, record.position_m.front());
  double held_N = 0;
  for (std::size_t i = 0; i < record.samples(); ++i) {
    const double slip = slips.at(record, i);
    if (values.stiffness_N_m > 0 && i > 0) {
      // Between slips the input follows the spring; it never leaves what friction holds.
      const auto [low_N, high_N] = std::minmax(
          {input_at(record, i, values, scales, -1), input_at(record, i, values, scales, 1)});
      held_N += values.stiffness_N_m * (record.position_m[i] - record.position_m[i - 1]);
      held_N = std::clamp(held_N, low_N, high_N);
    } else {
      held_N = input_at(record, i, values, scales, slip);
    }
    double efficiency = 1;
    if (values.gear_asymmetry != 0) {
      efficiency +=
          values.gear_asymmetry * std::tanh(record.velocity_m_s[i] / scales.turn_over_m_s);
    }
    input_N[i] = values.gain * held_N / efficiency + record.input_N_per_A * values.current_offset_A;
  }
}

}  // namespace host_sim::diagnose
