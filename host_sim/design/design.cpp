#include "host_sim/design/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "hal/files/input_error.hpp"

namespace host_sim::design {

using hal::files::InputError;
using reference::MeanAmplitude;

namespace {

constexpr double kMostFriction = 1;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

/// How many times the wire of the model could be cut out of the cross-section of this one.
double section_ratio(const Model& model, double diameter_mm) {
  const double ratio = diameter_mm / model.cable.diameter_mm;
  return ratio * ratio;
}

/// Mean and amplitude of a tension between two values.
MeanAmplitude between(double low_N, double high_N) {
  return {(high_N + low_N) / 2, (high_N - low_N) / 2};
}

}  // namespace

Stress stress_of(const Model& model, const Tendon& tendon) {
  const double section = section_ratio(model, tendon.diameter_mm);
  Stress stress{};
  stress.efficiency =
      reference::capstan_efficiency(tendon.friction_coefficient, radians(tendon.bend_angle_deg));
  stress.input = reference::input_tension_range(between(tendon.output_min_N, tendon.output_max_N),
                                                stress.efficiency);
  stress.ultimate_tension_N = model.cable.ultimate_tension_N * section;
  stress.effective_tension_N =
      reference::gerber_effective_tension(stress.input, stress.ultimate_tension_N);
  stress.characteristic_life_cycles = reference::ipl_life_cycles(
      law_tension_N(model, stress), model.life.ipl_scale, model.life.ipl_exponent);
  return stress;
}

double law_tension_N(const Model& model, const Stress& stress) {
  return stress.effective_tension_N * model.cable.ultimate_tension_N / stress.ultimate_tension_N;
}

double life_at(const Model& model, const Tendon& tendon, double risk) {
  return reference::weibull_life_damage(risk, model.life.weibull_shape) *
         stress_of(model, tendon).characteristic_life_cycles;
}

double diameter_of(const Model& model, double ultimate_tension_N) {
  return model.cable.diameter_mm * std::sqrt(ultimate_tension_N / model.cable.ultimate_tension_N);
}

std::span<const std::string_view> unknown_names() {
  static constexpr std::array<std::string_view, 7> kNames{"life", "tension", "bend",  "friction",
                                                          "wire", "risk",    "safety"};
  return kNames;
}

namespace {

/// The effective tension at which the wire of the model has this life: (19) and (22) solved for it.
double wanted_tension_N(const Model& model, double life_cycles, double risk) {
  const double damage = reference::weibull_life_damage(risk, model.life.weibull_shape);
  return std::pow(model.life.ipl_scale * damage / life_cycles, 1 / model.life.ipl_exponent);
}

/// Solves E (1 - (T_m / T_u)^2) = T_a, Gerber's (11), for t where T_m = p_m + q_m t and
/// T_a = p_a + q_a t by (12) and (13).
double solve_gerber(const MeanAmplitude& p, const MeanAmplitude& q, double effective_N,
                    double ultimate_N) {
  const double per_square = effective_N / (ultimate_N * ultimate_N);
  const double a = per_square * q.mean_N * q.mean_N;
  const double b = q.amplitude_N + 2 * per_square * p.mean_N * q.mean_N;
  const double c = p.amplitude_N + per_square * p.mean_N * p.mean_N - effective_N;
  return -2 * c / (b + std::sqrt(b * b - 4 * a * c));
}

/// The tendon with the unknown at a value.
using At = std::function<Tendon(double)>;

/// Where the unknown may lie, from the longest life to the shortest.
struct Domain {
  double gentle;
  double hard;
  std::string_view name;
  std::string_view unit;
  At at;
};

std::string value_text(double value, std::string_view unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

[[noreturn]] void refuse_life(const Request& request, const Domain& domain, double shortest,
                              double longest) {
  const auto [low, high] = std::minmax(domain.gentle, domain.hard);
  const std::string found = fmt::format(
      "no {} from {:.4g} to {} gives a life of {:.6g} cycles at a risk of {:g} %", domain.name, low,
      value_text(high, domain.unit), request.life_cycles, 100 * request.risk);
  if (std::isinf(shortest)) {
    throw InputError("design", 0, 0, found + ", as nothing there varies the tension",
                     "a load that varies, or a sheath with bend and friction");
  }
  throw InputError("design", 0, 0, found,
                   std::isinf(longest)
                       ? fmt::format("a life of at least {:.4g} cycles", shortest)
                       : fmt::format("a life of {:.4g} to {:.4g} cycles", shortest, longest));
}

[[noreturn]] void refuse_torn(const Stress& stress) {
  throw InputError("design", 0, 0,
                   fmt::format("the input tension reaches {:.4g} N, and the wire holds {:.4g} N",
                               stress.peak_N(), stress.ultimate_tension_N),
                   fmt::format("an output tension below {:.4g} N",
                               stress.efficiency * stress.ultimate_tension_N));
}

void check_whole(const Model& model, const Tendon& tendon) {
  if (const Stress stress = stress_of(model, tendon); stress.breaks_at_once()) {
    refuse_torn(stress);
  }
}

/// @throws InputError unless the wanted life lies within the domain
void check_within(const Model& model, const Request& request, const Domain& domain) {
  const double longest = life_at(model, domain.at(domain.gentle), request.risk);
  const double shortest = life_at(model, domain.at(domain.hard), request.risk);
  if (!(request.life_cycles >= shortest && request.life_cycles <= longest)) {
    refuse_life(request, domain, shortest, longest);
  }
}

Tendon solve_tension(const Model& model, const Request& request) {
  const Tendon& given = request.tendon;
  const auto at = [&](double max_N) {
    Tendon tendon = given;
    tendon.output_max_N = max_N;
    tendon.output_min_N = request.load_ratio ? *request.load_ratio * max_N : given.output_min_N;
    return tendon;
  };
  const double least_N =
      request.load_ratio ? kLeastTension_N : std::max(kLeastTension_N, given.output_min_N);
  const Stress stress = stress_of(model, at(least_N));
  const double torn_N = stress.efficiency * stress.ultimate_tension_N;
  if (torn_N <= least_N) {
    refuse_torn(stress);
  }
  check_within(model, request, {least_N, torn_N, "output tension", "N", at});

  const MeanAmplitude none{0, 0};
  const MeanAmplitude p =
      request.load_ratio
          ? none
          : reference::input_tension_range({given.output_min_N / 2, -given.output_min_N / 2},
                                           stress.efficiency);
  const MeanAmplitude q =
      reference::input_tension_range(between(request.load_ratio.value_or(0), 1), stress.efficiency);
  const double effective_N = section_ratio(model, given.diameter_mm) *
                             wanted_tension_N(model, request.life_cycles, request.risk);
  return at(solve_gerber(p, q, effective_N, stress.ultimate_tension_N));
}

/// With k times the cross-section: W (k^2 - (T_m / T_u)^2) = k T_a, of the wire of the model.
Tendon solve_wire(const Model& model, const Request& request) {
  const auto at = [&](double diameter_mm) {
    Tendon tendon = request.tendon;
    tendon.diameter_mm = diameter_mm;
    return tendon;
  };
  const Stress stress = stress_of(model, at(model.cable.diameter_mm));
  const double torn_mm = diameter_of(model, stress.peak_N());
  if (torn_mm >= kThickestWire_mm) {
    refuse_torn(stress_of(model, at(kThickestWire_mm)));
  }
  check_within(model, request, {kThickestWire_mm, torn_mm, "diameter of the wire", "mm", at});

  const double wanted_N = wanted_tension_N(model, request.life_cycles, request.risk);
  const double mean_ratio = stress.input.mean_N / model.cable.ultimate_tension_N;
  const double amplitude_N = stress.input.amplitude_N;
  const double section =
      (amplitude_N + std::hypot(amplitude_N, 2 * wanted_N * mean_ratio)) / (2 * wanted_N);
  return at(model.cable.diameter_mm * std::sqrt(section));
}

/// Friction and bend act by their product alone.
Tendon solve_sheath(const Model& model, const Request& request) {
  const bool is_bend = request.unknown == Unknown::bend;
  const auto at = [&](double value) {
    Tendon tendon = request.tendon;
    (is_bend ? tendon.bend_angle_deg : tendon.friction_coefficient) = value;
    return tendon;
  };
  check_whole(model, at(0));
  const Stress straight = stress_of(model, at(0));
  const double torn = std::log(straight.ultimate_tension_N / request.tendon.output_max_N);
  const double per_unit = is_bend ? request.tendon.friction_coefficient * radians(1)
                                  : radians(request.tendon.bend_angle_deg);
  const double most = std::min(is_bend ? kMostBend_deg : kMostFriction, torn / per_unit);
  check_within(
      model, request,
      {0, most, is_bend ? "bend angle" : "friction coefficient", is_bend ? "deg" : "", at});

  const double effective_N = section_ratio(model, request.tendon.diameter_mm) *
                             wanted_tension_N(model, request.life_cycles, request.risk);
  const auto beyond = [&](double value) {
    return stress_of(model, at(value)).effective_tension_N - effective_N;
  };
  // The ends of the domain may miss zero by their rounding.
  if (beyond(0) >= 0) {
    return at(0);
  }
  if (beyond(most) <= 0) {
    return at(most);
  }
  std::uintmax_t iterations = 200;
  const auto root = boost::math::tools::toms748_solve(
      beyond, 0.0, most,
      boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits - 2),
      iterations);
  return at((root.first + root.second) / 2);
}

}  // namespace

Design solve(const Model& model, const Request& request) {
  Design design{request.unknown, request.tendon, request.life_cycles, request.risk};
  switch (request.unknown) {
    case Unknown::tension:
      design.tendon = solve_tension(model, request);
      break;
    case Unknown::wire:
      design.tendon = solve_wire(model, request);
      break;
    case Unknown::bend:
    case Unknown::friction:
      design.tendon = solve_sheath(model, request);
      break;
    case Unknown::life:
      check_whole(model, request.tendon);
      design.life_cycles = life_at(model, request.tendon, request.risk);
      break;
    case Unknown::risk: {
      check_whole(model, request.tendon);
      const double damage =
          request.life_cycles / stress_of(model, request.tendon).characteristic_life_cycles;
      design.risk = 1 - reference::weibull_survival(damage, model.life.weibull_shape);
      break;
    }
    case Unknown::safety:
      check_whole(model, request.tendon);
      break;
  }
  return design;
}

}  // namespace host_sim::design
