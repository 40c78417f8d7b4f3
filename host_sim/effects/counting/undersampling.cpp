#include <cmath>

#include "host_sim/effects/counting/damage.hpp"
#include "host_sim/effects/counting_effect.hpp"

namespace host_sim::effects {
namespace {

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

}  // namespace

std::unique_ptr<CountingEffect> make_undersampling();

std::unique_ptr<CountingEffect> make_undersampling() {
  return std::make_unique<Undersampling>();
}

}  // namespace host_sim::effects
