#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "host_sim/effects/counting_effect.hpp"
#include "host_sim/recording/covariates.hpp"
#include "host_sim/reference/constants.hpp"
#include "host_sim/reference/reference.hpp"

namespace host_sim::effects {
namespace {

double damage_of(const std::vector<double>& tension_N, std::size_t step,
                 const reference::Constants& constants) {
  reference::Reference count(constants);
  for (std::size_t i = 0; i < tension_N.size(); i += step) {
    count.push(tension_N[i]);
  }
  return count.reading().damage.total;
}

/// Empty where there is an input tension, else what to record for one.
std::string missing_input(const recording::Covariates& covariates) {
  return covariates.tension_in_N().empty() ? "no input tension (input_tension_N or motor_current_A)"
                                           : "";
}

/// The share of the damage of the input tension, counted whole and without a threshold, that is
/// lost where every `step`-th sample from the first on is counted with a hysteresis; 0 where the
/// whole does no damage.
/// @pre missing_input() is empty, step at least 1
double share_lost(const recording::Covariates& covariates, reference::Constants constants,
                  std::size_t step, double hysteresis_N) {
  const std::vector<double>& tension_N = covariates.tension_in_N();
  constants.hysteresis_N = 0;
  const double full = damage_of(tension_N, 1, constants);
  constants.hysteresis_N = hysteresis_N;
  return full > 0 ? (full - damage_of(tension_N, step, constants)) / full : 0;
}

namespace small_cycles {

constexpr Parameter kParameter{
    .name = "hysteresis_N", .unit = "N", .minimum = 0, .maximum = 50, .typical = 0.2};

constexpr Separation kSeparations[] = {
    {"endurance_limit",
     "sweep the hysteresis of the count: an endurance limit does not move with it"},
};

class SmallCycles final : public CountingEffect {
 public:
  std::string_view id() const override { return "small_cycles"; }
  std::string_view term() const override { return "cycles below the threshold of the counter"; }
  std::string_view equation() const override {
    return "a swing below the hysteresis h does not count; its damage is (T_a/T)^gamma of a full "
           "one";
  }
  std::string_view life_consequence() const override {
    return "cycles that wear the wire are not booked: one of a tenth of the amplitude costs 4.2 % "
           "of a full one at gamma 1.38";
  }
  const Parameter& parameter() const override { return kParameter; }
  std::span<const Separation> separations() const override { return kSeparations; }

  std::string missing(const recording::Covariates& covariates) const override {
    return missing_input(covariates);
  }

  double damage_lost(const recording::Covariates& covariates, const reference::Constants& constants,
                     double value) const override {
    return share_lost(covariates, constants, 1, value);
  }
};

}  // namespace small_cycles

namespace undersampling {

constexpr Parameter kParameter{
    .name = "decimation", .unit = "1", .minimum = 1, .maximum = 64, .typical = 2};

constexpr Separation kSeparations[] = {
    {"filter_lag", "decimate the data: what a lag has cut does not come back"},
};

class Undersampling final : public CountingEffect {
 public:
  std::string_view id() const override { return "undersampling"; }
  std::string_view term() const override { return "peaks lost between samples"; }
  std::string_view equation() const override {
    return "a peak is lost by up to 1 - cos(pi/N) of its amplitude at N samples a cycle";
  }
  std::string_view life_consequence() const override {
    return "amplitudes come out too small, so that life is overstated by gamma times the loss: 5 % "
           "of amplitude at N = 10 is 7 % of life at gamma 1.38";
  }
  const Parameter& parameter() const override { return kParameter; }
  std::span<const Separation> separations() const override { return kSeparations; }

  std::string missing(const recording::Covariates& covariates) const override {
    return missing_input(covariates);
  }

  double damage_lost(const recording::Covariates& covariates, const reference::Constants& constants,
                     double value) const override {
    return share_lost(covariates, constants, static_cast<std::size_t>(std::lround(value)), 0);
  }
};

}  // namespace undersampling

std::vector<std::unique_ptr<CountingEffect>> made() {
  std::vector<std::unique_ptr<CountingEffect>> effects;
  effects.push_back(std::make_unique<small_cycles::SmallCycles>());
  effects.push_back(std::make_unique<undersampling::Undersampling>());
  return effects;
}

}  // namespace

std::span<const std::unique_ptr<CountingEffect>> counting_effects() {
  static const std::vector<std::unique_ptr<CountingEffect>> catalogue = made();
  return catalogue;
}

}  // namespace host_sim::effects
