#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "gear_asymmetry", .unit = "1", .minimum = -0.3, .maximum = 0.3, .typical = 0.02},
};

constexpr Separation kSeparations[] = {
    {"bend_angle", "measure at four or more bend angles: an asymmetry is the same at each"},
    {"friction_preload", "measure at low and at high tension"},
};

constexpr Need kNeeds[] = {kCurrentNeed};

/// ln(1 + c s) is c s for small c, so r = s c.
Columns columns(const recording::Covariates& covariates, const Baseline&, std::span<const double>) {
  return {column_of(covariates, [&](std::size_t i) { return covariates.direction[i]; })};
}

}  // namespace

std::unique_ptr<TensionEffect> make_gear_asymmetry();

std::unique_ptr<TensionEffect> make_gear_asymmetry() {
  return effect_of(
      {.id = "gear_asymmetry",
       .term = "direction-dependent gear efficiency",
       .equation = "T_in = K_t (I - I_0) N eta_g (1 + c s) / r_spool",
       .life_consequence =
           "the amplitude of input tension is wrong by c times its mean, at every bend angle",
       .parameters = kParameters,
       .separations = kSeparations,
       .needs = kNeeds,
       .acts_on_current = true,
       .shifts_sessions = true,
       .columns = columns});
}

}  // namespace host_sim::effects
