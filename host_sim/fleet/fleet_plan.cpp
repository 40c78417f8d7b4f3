#include "host_sim/fleet/fleet_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "hal/files/interruption.hpp"
#include "host_sim/fleet/costs.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::fleet {

LawBelief belief_of(const Model::Life& life) {
  LawBelief law{.shape = life.weibull_shape};
  if (life.interval) {
    const Model::Life::Interval& interval = *life.interval;
    const double width_sd = 2 * statistics::Distribution{statistics::Family::normal, 0, 1}.quantile(
                                    0.5 + 0.5 * interval.level);
    const auto log_sd = [&](const Model::Life::Interval::Ends& ends) {
      return std::log(ends.high / ends.low) / width_sd;
    };
    law.log_shape_sd = log_sd(interval.weibull_shape);
    law.log_life_sd = log_sd(interval.life_at_pivot);
    law.exponent_sd = (interval.ipl_exponent.high - interval.ipl_exponent.low) / width_sd;
    law.pivot_tension_N = interval.pivot_tension_N;
  }
  return law;
}

namespace {

constexpr double kB10 = 0.1;

Due due_in(double hours, const Tendon& tendon, Date today) {
  Due due{hours, std::nullopt};
  const double days = std::floor(hours / tendon.hours_per_day);
  if (std::abs(days) <= kLongestHorizon_days) {
    const Date date = today + std::chrono::days(static_cast<int>(days));
    due.date = date >= Date() ? std::optional(date) : std::nullopt;
  }
  return due;
}

/// What the spares follow from: risk, due and evidence.
TendonPlan risks_of(const BreakRisk& risk, double horizon_h, double risk_when_due) {
  TendonPlan plan;
  plan.risk = risk.within(horizon_h);
  plan.due = plan.risk >= risk_when_due;
  const double of_all_laws = risk.within_of_all_laws(horizon_h);
  plan.evidence = of_all_laws == 0 ? 1 : plan.risk / of_all_laws;
  return plan;
}

TendonPlan plan_of(const Tendon& tendon, const LawBelief& law, const PlanRequest& request) {
  const BreakRisk risk(law, tendon);
  const double horizon_h = request.horizon.hours(tendon.hours_per_day);
  const double to_b10 = reference::weibull_life_damage(kB10, law.shape) - tendon.damage;
  TendonPlan plan = risks_of(risk, horizon_h, request.risk);
  plan.risk_at_fit = risk.within_at_fit(horizon_h);
  plan.replace = due_in(risk.hours_to(request.risk), tendon, request.today);
  plan.b10 = due_in(to_b10 / tendon.damage_per_h, tendon, request.today);
  plan.risk_until_b10 = plan.b10.hours > 0 ? risk.within(std::min(plan.b10.hours, horizon_h)) : 0;
  return plan;
}

/// The tendons of one model, whose breaks hang together by what is not known of it.
class Group {
 public:
  Group(const Fleet& fleet, const FleetPlan& plan, std::size_t model, const PlanRequest& request)
      : fleet_(fleet),
        plan_(plan),
        request_(request),
        law_(belief_of(fleet.models[model].model.life)),
        shapes_(normal_points(1, 4, law_.log_shape_sd)),
        lives_(normal_points(1, 5, law_.log_life_sd)) {
    bool away_from_pivot = false;
    for (std::size_t i = 0; i < fleet.tendons.size(); ++i) {
      if (fleet.tendons[i].model == model) {
        tendons_.push_back(i);
        away_from_pivot = away_from_pivot || distance_from_pivot(law_, fleet.tendons[i]) != 0;
      }
    }
    exponents_ = normal_points(1, 4, away_from_pivot ? law_.exponent_sd : 0);
    for (const NormalPoint& shape : shapes_) {
      growths_.push_back(growths_under(beta_of(shape)));
    }
  }

  struct Demands {
    Demand all;    ///< where nothing is replaced before it breaks
    Demand later;  ///< of those that are not due
  };

  [[nodiscard]] Demands demands() const {
    const std::size_t count = shapes_.size() * lives_.size() * exponents_.size();
    std::vector<Demand> all(count);
    std::vector<Demand> later(count);
    std::vector<double> weights(count);
    const auto under_law = [&](std::size_t k) {
      hal::files::stop_if_interrupted();
      const std::size_t shape = k % shapes_.size();
      const NormalPoint& life = lives_[k / shapes_.size() % lives_.size()];
      const NormalPoint& exponent = exponents_[k / shapes_.size() / lives_.size()];
      weights[k] = shapes_[shape].weight * life.weight * exponent.weight;
      const std::vector<double> breaks = breaks_under(shape, life.z, exponent.z);
      std::vector<double> of_later;
      for (std::size_t i = 0; i < breaks.size(); ++i) {
        if (!plan_.tendons[tendons_[i]].due) {
          of_later.push_back(breaks[i]);
        }
      }
      all[k] = poisson_binomial(breaks);
      later[k] = poisson_binomial(of_later);
    };
    statistics::parallel_for(count, under_law, request_.threads);
    return {mixture(all, weights), mixture(later, weights)};
  }

 private:
  /// What a tendon's hazard grows by until the horizon, if its rate is a certain multiple of the
  /// mean one.
  struct Growth {
    double hazard;
    double weight;
  };

  [[nodiscard]] double beta_of(const NormalPoint& shape) const {
    return law_.shape * std::exp(law_.log_shape_sd * shape.z);
  }

  /// Of each tendon, one for each rate, under the law as it is fitted but for its shape.
  [[nodiscard]] std::vector<std::vector<Growth>> growths_under(double beta) const {
    std::vector<std::vector<Growth>> growths;
    growths.reserve(tendons_.size());
    for (const std::size_t i : tendons_) {
      const Tendon& tendon = fleet_.tendons[i];
      const double further = tendon.damage_per_h * request_.horizon.hours(tendon.hours_per_day);
      std::vector<Growth>& of_tendon = growths.emplace_back();
      for (const NormalPoint& rate : rate_factors(tendon.rate_log_sd)) {
        of_tendon.push_back({hazard_growth(tendon.damage, further * rate.z, beta), rate.weight});
      }
    }
    return growths;
  }

  /// The probability of a break of each tendon under one law. A tendon's survival is evidence of
  /// its own law alone: its neighbours may be the ones that were never replaced. So the laws keep
  /// their weights, and each tendon its own risk as the mean.
  [[nodiscard]] std::vector<double> breaks_under(std::size_t shape, double life_z,
                                                 double exponent_z) const {
    const double beta = beta_of(shapes_[shape]);
    std::vector<double> breaks;
    breaks.reserve(tendons_.size());
    for (std::size_t k = 0; k < tendons_.size(); ++k) {
      const double distance = distance_from_pivot(law_, fleet_.tendons[tendons_[k]]);
      const double log_life = law_.log_life_sd * life_z - law_.exponent_sd * exponent_z * distance;
      const double rate_of_hazard = std::exp(-beta * log_life);
      double risk = 0;
      for (const Growth& growth : growths_[shape][k]) {
        risk -= growth.weight * std::expm1(-growth.hazard * rate_of_hazard);
      }
      breaks.push_back(std::clamp(risk * plan_.tendons[tendons_[k]].evidence, 0.0, 1.0));
    }
    return breaks;
  }

  const Fleet& fleet_;
  const FleetPlan& plan_;
  const PlanRequest& request_;
  LawBelief law_;
  std::vector<std::size_t> tendons_;
  std::vector<NormalPoint> shapes_;
  std::vector<NormalPoint> lives_;
  std::vector<NormalPoint> exponents_;
  std::vector<std::vector<std::vector<Growth>>> growths_;  ///< by shape
};

Spares spares_of(Demand demand, double service) {
  Spares spares{std::move(demand), 0, 0};
  spares.count = spares.demand.quantile(service);
  spares.service = spares.demand.at_most(spares.count);
  return spares;
}

void count_spares(const Fleet& fleet, const PlanRequest& request, FleetPlan& plan) {
  Demand all;
  Demand later;
  for (std::size_t model = 0; model < fleet.models.size(); ++model) {
    const Group::Demands demands = Group(fleet, plan, model, request).demands();
    all = together(all, demands.all);
    later = together(later, demands.later);
  }
  later.first += plan.due;
  plan.breaks = spares_of(std::move(all), request.service);
  plan.on_condition = spares_of(std::move(later), request.service);
}

/// What the numbers do not hold, in sentences.
std::vector<std::string> warnings_of(const Fleet& fleet, const FleetPlan& plan) {
  std::vector<std::string> warnings = fleet.doubts;
  for (const FleetModel& model : fleet.models) {
    if (belief_of(model.model.life).exact()) {
      warnings.push_back(fmt::format(
          "{} has no [life.interval]: its law is taken as exact, and risks are too sure",
          model.file));
    } else if (std::ranges::any_of(fleet.tendons, [](const Tendon& tendon) {
                 return !tendon.effective_tension_N;
               })) {
      warnings.push_back(fmt::format(
          "{}: tendons without effective_tension_N are taken to be at {:g} N, where its law is "
          "known best",
          model.file, model.model.life.interval->pivot_tension_N));
    }
  }
  if (plan.second_breaks_at_most > 0.1) {
    warnings.push_back(fmt::format(
        "replacements may break within the horizon themselves, up to {:.1f} of them: plan a "
        "shorter horizon",
        plan.second_breaks_at_most));
  }
  return warnings;
}

std::vector<LawBelief> laws_of(const Fleet& fleet) {
  std::vector<LawBelief> laws;
  for (const FleetModel& model : fleet.models) {
    laws.push_back(belief_of(model.model.life));
  }
  return laws;
}

/// A plan with `plan_of(i)` for each tendon.
template <class PlanOf>
FleetPlan plan_each(const Fleet& fleet, unsigned threads, PlanOf plan_of) {
  FleetPlan plan;
  plan.tendons.resize(fleet.tendons.size());
  statistics::parallel_for(
      fleet.tendons.size(),
      [&](std::size_t i) {
        hal::files::stop_if_interrupted();
        plan.tendons[i] = plan_of(i);
      },
      threads);
  plan.due = static_cast<std::size_t>(std::ranges::count(plan.tendons, true, &TendonPlan::due));
  return plan;
}

}  // namespace

FleetPlan make_plan(const Fleet& fleet, const PlanRequest& request) {
  const std::vector<LawBelief> laws = laws_of(fleet);
  std::vector<double> second_risks(fleet.tendons.size());
  FleetPlan plan = plan_each(fleet, request.threads, [&](std::size_t i) {
    const Tendon& tendon = fleet.tendons[i];
    Tendon replacement = tendon;
    replacement.damage = 0;
    second_risks[i] = BreakRisk(laws[tendon.model], replacement)
                          .within(request.horizon.hours(tendon.hours_per_day));
    return plan_of(tendon, laws[tendon.model], request);
  });
  for (std::size_t i = 0; i < fleet.tendons.size(); ++i) {
    const TendonPlan& planned = plan.tendons[i];
    plan.expected_breaks += planned.risk;
    plan.breaks_until_due += planned.due ? request.risk : planned.risk;
    plan.second_breaks_at_most += planned.risk * second_risks[i];
    plan.past_b10 += planned.b10.hours <= 0 ? 1 : 0;
  }
  count_spares(fleet, request, plan);
  plan.costs = costs_of(fleet, request, plan);
  plan.warnings = warnings_of(fleet, plan);
  return plan;
}

std::vector<SparesUntil> course_of(const Fleet& fleet, const PlanRequest& request,
                                   const FleetPlan& plan) {
  constexpr std::size_t kTendonSteps = 30'000;
  const std::size_t steps = std::clamp<std::size_t>(kTendonSteps / fleet.tendons.size(), 3, 30);
  const std::vector<LawBelief> laws = laws_of(fleet);
  std::vector<SparesUntil> course(1);
  for (std::size_t i = 1; i < steps; ++i) {
    PlanRequest part = request;
    part.horizon.length *= static_cast<double>(i) / static_cast<double>(steps);
    FleetPlan until = plan_each(fleet, part.threads, [&](std::size_t k) {
      const Tendon& tendon = fleet.tendons[k];
      return risks_of(BreakRisk(laws[tendon.model], tendon),
                      part.horizon.hours(tendon.hours_per_day), part.risk);
    });
    count_spares(fleet, part, until);
    course.push_back({part.horizon.length, std::move(until.breaks), std::move(until.on_condition)});
  }
  course.push_back({request.horizon.length, plan.breaks, plan.on_condition});
  return course;
}

std::vector<std::size_t> by_urgency(const FleetPlan& plan) {
  std::vector<std::size_t> order(plan.tendons.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto days = [&](std::size_t i) {
    const auto& date = plan.tendons[i].replace.date;
    return date ? date->time_since_epoch().count() : std::numeric_limits<int>::max();
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return std::pair(days(one), -plan.tendons[one].risk) <
           std::pair(days(other), -plan.tendons[other].risk);
  });
  return order;
}

}  // namespace host_sim::fleet
