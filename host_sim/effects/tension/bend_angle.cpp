#include <algorithm>
#include <cmath>

#include "host_sim/effects/tension/definition.hpp"
#include "host_sim/effects/tension/needs.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameters[] = {
    {.name = "bend_angle_error_rad",
     .unit = "rad",
     .minimum = -0.6,
     .maximum = 0.6,
     .typical = 0.26},
};

constexpr Separation kSeparations[] = {
    {"gear_asymmetry", "measure at four or more bend angles: an asymmetry is the same at each"},
};

std::size_t nearest(const std::vector<double>& poses_rad, double bend_angle_rad) {
  const auto closer = [&](double a, double b) {
    return std::abs(a - bend_angle_rad) < std::abs(b - bend_angle_rad);
  };
  return static_cast<std::size_t>(std::ranges::min_element(poses_rad, closer) - poses_rad.begin());
}

/// r = -mu s delta in the samples of the pose, 0 in the others.
Columns columns(const recording::Covariates& covariates, const Baseline& baseline,
                std::span<const double>) {
  const bool one_pose = baseline.poses_rad.empty();
  Columns columns(one_pose ? 1 : baseline.poses_rad.size(),
                  std::vector<double>(covariates.samples()));
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    const std::size_t pose =
        one_pose ? 0 : nearest(baseline.poses_rad, covariates.bend_angle_rad[i]);
    columns[pose][i] = -baseline.friction_coefficient * covariates.direction[i];
  }
  return columns;
}

}  // namespace

std::unique_ptr<TensionEffect> make_bend_angle();

std::unique_ptr<TensionEffect> make_bend_angle() {
  return effect_of(
      {.id = "bend_angle",
       .term = "bend-angle (pose) error",
       .equation = "mu (phi + delta), delta of each pose",
       .life_consequence =
           "a pose that bends more than it was said to has input tensions larger by exp(mu delta)",
       .parameters = kParameters,
       .separations = kSeparations,
       .per_pose = true,
       .shifts_sessions = true,
       .columns = columns});
}

}  // namespace host_sim::effects
