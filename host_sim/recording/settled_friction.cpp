#include "host_sim/recording/settled_friction.hpp"

#include <cmath>

#include "host_sim/recording/motion.hpp"

namespace host_sim::recording {
namespace {

/// Of short strokes the settled samples are ends alone, and friction there speaks for no more.
constexpr double kLeastShare = 0.25;

}  // namespace

SettledSums::SettledSums(const Covariates& covariates) {
  double samples = 0;
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < covariates.samples(); ++i) {
    if (covariates.travel_m[i] < kSettledTravel_m) {
      continue;
    }
    const double x = -covariates.bend_angle_rad[i] * covariates.direction[i];
    const double y = std::log(covariates.output_tension_N[i] / covariates.tension_in_N()[i]);
    samples += 1;
    const double off_x = x - mean_x;
    mean_x += off_x / samples;
    mean_y += (y - mean_y) / samples;
    square += off_x * (x - mean_x);
    product += off_x * (y - mean_y);
  }
  if (samples < kLeastShare * static_cast<double>(covariates.samples())) {
    square = 0;
    product = 0;
  }
}

double settled_friction(const Covariates& covariates) {
  const SettledSums sums(covariates);
  return sums.square > 0 ? sums.product / sums.square : 0;
}

}  // namespace host_sim::recording
