#include "host_sim/diagnose/lives/estimates.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/lives/maximize.hpp"
#include "host_sim/diagnose/lives/specimen_life.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// Half the 0.95 point of chi-square with one degree of freedom.
constexpr double kLoss = 1.9207294103470258;

/// The end on one side: secant steps on the root of the loss, which is nearly straight.
double end_of(const ModelView& view, const ModelFit& fit, Eigen::Index coordinate, double sign) {
  const double best = fit.at[coordinate];
  const double root = std::sqrt(kLoss);
  double near = 0;
  double near_root = 0;
  double far = std::sqrt(2 * kLoss * fit.covariance(coordinate, coordinate));
  Eigen::VectorXd start = fit.at;
  constexpr int kSteps = 8;
  constexpr double kClose = 0.01;
  for (int step = 0; step < kSteps; ++step) {
    far = std::min(far, std::max(kFarthest - sign * best, near));
    const ModelFit at = fit_with_fixed(view, coordinate, best + sign * far, start);
    start = at.at;
    const double loss_root = std::sqrt(std::max(0.0, fit.log_posterior - at.log_posterior));
    if (std::abs(loss_root - root) < kClose) {
      break;
    }
    const double slope = (loss_root - near_root) / std::max(far - near, 1e-9);
    if (loss_root < root) {
      near = far;
      near_root = loss_root;
      far += slope > 1e-3 ? std::min((root - loss_root) / slope, 2.0) : 1.0;
    } else {
      far = near + (root - near_root) / slope;
    }
    if (best + sign * near >= kFarthest || best + sign * near <= -kFarthest) {
      break;
    }
  }
  return best + sign * far;
}

Estimate estimate_of(const TermParameter& parameter, const CoordinateInterval& interval) {
  return {.name = parameter.name,
          .unit = parameter.unit,
          .value = parameter.value(interval.value),
          .low = parameter.value(interval.low),
          .high = parameter.value(interval.high)};
}

std::vector<Estimate> refitted_of(const ModelView& view, const ModelFit& fit,
                                  const std::vector<CoordinateInterval>& common) {
  const LifeSettings settings = view.settings(fit.at);
  const double scale = std::exp(frame_of(view.sample(), settings).ln_scale);
  const auto changed = [&](std::size_t i, double sd, double end) {
    return std::exp(sd * (end - common[i].value));
  };
  const auto life_change = [&](double end) {
    return std::exp(CommonPrior::kLife_sd * (end - common[0].value));
  };
  return {{"ipl_scale", "cycles", scale, scale * life_change(common[0].low),
           scale * life_change(common[0].high)},
          {"ipl_exponent", "1", settings.exponent,
           settings.exponent * changed(1, CommonPrior::kLogExponent_sd, common[1].low),
           settings.exponent * changed(1, CommonPrior::kLogExponent_sd, common[1].high)},
          {"weibull_shape", "1", settings.shape,
           settings.shape * changed(2, CommonPrior::kLogShape_sd, common[2].low),
           settings.shape * changed(2, CommonPrior::kLogShape_sd, common[2].high)}};
}

}  // namespace

CoordinateInterval profile_interval(const ModelView& view, const ModelFit& fit,
                                    Eigen::Index coordinate) {
  return {.value = fit.at[coordinate],
          .low = end_of(view, fit, coordinate, -1),
          .high = end_of(view, fit, coordinate, 1)};
}

ModelEstimates estimates_of(const ModelView& view, const ModelFit& fit, unsigned threads) {
  std::vector<CoordinateInterval> intervals(static_cast<std::size_t>(view.coordinates()));
  statistics::parallel_for(
      intervals.size(),
      [&](std::size_t i) {
        intervals[i] = profile_interval(view, fit, static_cast<Eigen::Index>(i));
      },
      threads);
  ModelEstimates estimates;
  std::size_t next = static_cast<std::size_t>(CommonPrior::kCount);
  for (const Term& term : view.terms()) {
    estimates.terms.emplace_back();
    for (const TermParameter& parameter : term.parameters) {
      estimates.terms.back().push_back(estimate_of(parameter, intervals[next++]));
    }
  }
  estimates.refitted = refitted_of(view, fit, intervals);
  return estimates;
}

}  // namespace host_sim::diagnose::lives
