#include "host_sim/design/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hal/files/input_error.hpp"
#include "host_sim/statistics/reach.hpp"

namespace host_sim::design {
namespace {

/// An input by which a design can be changed.
struct Input {
  std::string name;
  /// The tendon, and in the case of the risk that, with the input times a factor.
  void (*scale)(Tendon& tendon, double& risk, double factor);
};

std::vector<Input> inputs_of(const Tendon& tendon) {
  std::vector<Input> inputs{
      {"output tension",
       [](Tendon& s, double&, double factor) {
         s.output_max_N *= factor;
         s.output_min_N *= factor;
       }},
      {"bend angle", [](Tendon& s, double&, double factor) { s.bend_angle_deg *= factor; }},
      {"friction coefficient",
       [](Tendon& s, double&, double factor) { s.friction_coefficient *= factor; }},
      {"diameter of the wire", [](Tendon& s, double&, double factor) { s.diameter_mm *= factor; }},
      {"risk", [](Tendon&, double& risk, double factor) { risk *= factor; }},
  };
  if (tendon.output_min_N > 0 && tendon.output_min_N < tendon.output_max_N) {
    inputs.push_back({"lowest output tension", [](Tendon& s, double&, double factor) {
                        s.output_min_N = std::min(s.output_min_N * factor, s.output_max_N);
                      }});
  }
  return inputs;
}

double life_with(const Model& model, const Design& design, const Input& input, double factor) {
  Tendon tendon = design.tendon;
  double risk = design.risk;
  input.scale(tendon, risk, factor);
  if (stress_of(model, tendon).breaks_at_once()) {
    return 0;
  }
  return risk < 1 ? life_at(model, tendon, risk) : std::numeric_limits<double>::quiet_NaN();
}

Elasticity elasticity_of(const Model& model, const Design& design, const Input& input) {
  constexpr double kStep = 1e-4;
  constexpr double kTenth = 0.1;
  const double life = life_at(model, design.tendon, design.risk);
  const auto log_life = [&](double log_factor) {
    return std::log(life_with(model, design, input, std::exp(log_factor)));
  };
  return {input.name, (log_life(kStep) - log_life(-kStep)) / (2 * kStep),
          life_with(model, design, input, 1 - kTenth) / life,
          life_with(model, design, input, 1 + kTenth) / life};
}

std::vector<Elasticity> elasticities_of(const Model& model, const Design& design) {
  std::vector<Elasticity> all;
  if (!std::isfinite(life_at(model, design.tendon, design.risk)) || design.risk <= 0 ||
      design.risk >= 1) {
    return all;
  }
  for (const Input& input : inputs_of(design.tendon)) {
    all.push_back(elasticity_of(model, design, input));
  }
  std::stable_sort(all.begin(), all.end(), [](const Elasticity& a, const Elasticity& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  return all;
}

Margin margin_of(const Model& model, const Design& design, double risk, double strength) {
  Margin margin{life_at(model, design.tendon, risk) / design.life_cycles, strength};
  Tendon torn = design.tendon;
  torn.output_max_N *= strength;
  torn.output_min_N *= strength;
  // Where even the tension that tears the wire allows the wanted life, the strength is the limit.
  if (life_at(model, torn, risk) < design.life_cycles) {
    const Design allowed = solve(model, {.unknown = Unknown::tension,
                                         .tendon = design.tendon,
                                         .load_ratio = design.tendon.load_ratio(),
                                         .life_cycles = design.life_cycles,
                                         .risk = risk});
    margin.tension = allowed.tendon.output_max_N / design.tendon.output_max_N;
  }
  return margin;
}

Safety safety_of(const Model& model, const Design& design, const Stress& stress) {
  const double strength = stress.ultimate_tension_N / stress.peak_N();
  const bool is_certain = design.risk <= 0 || design.risk >= 1;
  const Margin none{1, 1};
  if (std::isinf(design.life_cycles)) {
    return {strength, none, none};
  }
  return {strength, is_certain ? none : margin_of(model, design, design.risk, strength),
          margin_of(model, design, 0.5, strength)};
}

/// Life at the pivot, exponent and shape err on their own.
std::optional<LifeInterval> interval_of(const Model& model, const Design& design,
                                        const Stress& stress, double life_cycles) {
  if (!model.life.interval || !std::isfinite(life_cycles) || life_cycles <= 0) {
    return std::nullopt;
  }
  const Model::Life::Interval& known = *model.life.interval;
  const double own = std::log(life_cycles);
  const double pivot_life_cycles = reference::ipl_life_cycles(
      known.pivot_tension_N, model.life.ipl_scale, model.life.ipl_exponent);
  const double log_tension_ratio = std::log(law_tension_N(model, stress) / known.pivot_tension_N);
  const double log_hazard = model.life.weibull_shape * std::log(reference::weibull_life_damage(
                                                           design.risk, model.life.weibull_shape));
  const auto at_exponent = [&](double exponent) {
    return own - (exponent - model.life.ipl_exponent) * log_tension_ratio;
  };
  const auto at_shape = [&](double shape) {
    return own + log_hazard * (1 / shape - 1 / model.life.weibull_shape);
  };
  statistics::Reach reach;
  reach.add(own, own + std::log(known.life_at_pivot.low / pivot_life_cycles),
            own + std::log(known.life_at_pivot.high / pivot_life_cycles));
  reach.add(own, at_exponent(known.ipl_exponent.low), at_exponent(known.ipl_exponent.high));
  reach.add(own, at_shape(known.weibull_shape.low), at_shape(known.weibull_shape.high));
  return LifeInterval{known.level, std::exp(own - reach.below), std::exp(own + reach.above)};
}

std::optional<AcceleratedTest> accelerated(const Model& model, const Design& design,
                                           const TestRequest& request) {
  if (!request.output_max_N && !request.bend_angle_deg) {
    return std::nullopt;
  }
  Tendon tendon = design.tendon;
  tendon.output_max_N = request.output_max_N.value_or(tendon.output_max_N);
  tendon.output_min_N = design.tendon.load_ratio() * tendon.output_max_N;
  tendon.bend_angle_deg = request.bend_angle_deg.value_or(tendon.bend_angle_deg);
  const Stress stress = stress_of(model, tendon);
  if (stress.breaks_at_once()) {
    throw hal::files::InputError(
        "design", 0, 0,
        fmt::format("the input tension of the test reaches {:.4g} N, and the wire holds {:.4g} N",
                    stress.peak_N(), stress.ultimate_tension_N),
        "a test below the ultimate tension of the wire");
  }
  const double own = stress_of(model, design.tendon).characteristic_life_cycles;
  return AcceleratedTest{tendon, own / stress.characteristic_life_cycles,
                         life_at(model, tendon, design.risk)};
}

Curve curve_of(const Model& model, const Design& design, double bend_angle_deg, double least_N,
               double most_N) {
  constexpr int kPoints = 80;
  Tendon tendon = design.tendon;
  tendon.bend_angle_deg = bend_angle_deg;
  const Stress stress = stress_of(model, tendon);
  const double end_N = std::min(most_N, stress.efficiency * stress.ultimate_tension_N);
  Curve curve{bend_angle_deg, {}, {}};
  for (int i = 0; i <= kPoints && end_N > least_N; ++i) {
    tendon.output_max_N = least_N + (end_N - least_N) * i / kPoints;
    tendon.output_min_N = design.tendon.load_ratio() * tendon.output_max_N;
    curve.output_max_N.push_back(tendon.output_max_N);
    curve.life_cycles.push_back(life_at(model, tendon, design.risk));
  }
  return curve;
}

/// Of the bend angle of the design and others to both sides of it, a right angle apart.
std::vector<Curve> curves_of(const Model& model, const Design& design) {
  constexpr double kRightAngle_deg = 90;
  constexpr double kLeast = 0.25;
  constexpr double kMost = 2.2;
  std::vector<Curve> curves;
  for (int i = -2; i <= 2; ++i) {
    const double bend_angle_deg = design.tendon.bend_angle_deg + i * kRightAngle_deg;
    if (bend_angle_deg >= 0 && bend_angle_deg <= kMostBend_deg) {
      curves.push_back(curve_of(model, design, bend_angle_deg, kLeast * design.tendon.output_max_N,
                                kMost * design.tendon.output_max_N));
    }
  }
  return curves;
}

}  // namespace

Study study(const Model& model, const Design& design, const TestRequest& test) {
  const Stress stress = stress_of(model, design.tendon);
  const double life_cycles = design.found == Unknown::safety
                                 ? life_at(model, design.tendon, design.risk)
                                 : design.life_cycles;
  return {.design = design,
          .stress = stress,
          .life_cycles = life_cycles,
          .interval = interval_of(model, design, stress, life_cycles),
          .lives_cycles = reference::repeats_to(1 / stress.characteristic_life_cycles,
                                                model.life.weibull_shape),
          .safety = safety_of(model, design, stress),
          .elasticities = elasticities_of(model, design),
          .test = accelerated(model, design, test),
          .curves = curves_of(model, design)};
}

}  // namespace host_sim::design
