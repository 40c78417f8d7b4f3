#include "host_sim/calibrate/stress_life.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/calibrate/adequacy.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::calibrate {
namespace {

using Kind = life_law::LifeQuantity::Kind;

/// The estimate over the mean of what simulation makes of it.
double without_bias(double shape, std::span<const LifeLaw> refits) {
  double sum = 0;
  std::size_t count = 0;
  for (const LifeLaw& law : refits) {
    if (law.shape > 0) {
      sum += law.shape / shape;
      ++count;
    }
  }
  return count == 0 ? shape : shape * static_cast<double>(count) / sum;
}

void fit_as_the_paper(std::span<const LevelResult> levels, const CommonShape& shape,
                      StressLife& result) {
  std::vector<double> tension_N;
  std::vector<double> scale;
  for (const LevelResult& level : levels) {
    if (level.role == Campaign::Role::fit && level.left_out.empty() &&
        level.weibull().problem == statistics::FitProblem::none) {
      tension_N.push_back(level.load.effective_tension_N);
      scale.push_back(level.weibull().distribution.first);
    }
  }
  if (tension_N.size() >= 2) {
    const life_law::LeastSquares fit = life_law::fit_least_squares(tension_N, scale);
    result.least_squares = LifeLaw{fit.scale, fit.exponent, shape.value};
    result.least_squares_rmse = fit.rmse_cycles;
  }
}

/// Tensions of the plots: from 0.8 of the least to 1.25 of the largest, in even ratios.
std::vector<double> band_tensions(std::span<const LevelResult> levels,
                                  std::span<const life_law::LifeDatum> data) {
  constexpr std::size_t kPoints = 33;
  constexpr double kMargin = 1.25;
  double low = data.front().blocks.front().effective_tension_N;
  double high = low;
  for (const life_law::LifeDatum& datum : data) {
    for (const life_law::LifeDatum::Block& block : datum.blocks) {
      low = std::min(low, block.effective_tension_N);
      high = std::max(high, block.effective_tension_N);
    }
  }
  for (const LevelResult& level : levels) {
    low = std::min(low, level.load.effective_tension_N);
    high = std::max(high, level.load.effective_tension_N);
  }
  std::vector<double> tensions(kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double share = static_cast<double>(i) / (kPoints - 1);
    tensions[i] = low / kMargin * std::pow(high / low * kMargin * kMargin, share);
  }
  return tensions;
}

}  // namespace

StressLife stress_life(std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                       std::span<const LifeLaw> refits, std::span<const LevelResult> levels,
                       const std::optional<CommonShape>& shape, const CalibrateOptions& options) {
  StressLife result;
  result.law = fit.law();
  result.log_likelihood = fit.log_likelihood;
  result.scale_ci95 = life_law::exp_of(profile_interval(data, fit, {Kind::ln_scale}));
  result.exponent_ci95 = profile_interval(data, fit, {Kind::exponent});
  result.shape_ci95 = profile_interval(data, fit, {Kind::shape});
  result.shape_unbiased = without_bias(result.law.shape, refits);
  if (shape) {
    fit_as_the_paper(levels, *shape, result);
  }
  test_adequacy(data, fit, options, result);
  result.band_tension_N = band_tensions(levels, data);
  result.band_mean.resize(result.band_tension_N.size());
  statistics::parallel_for(
      result.band_mean.size(),
      [&](std::size_t i) {
        result.band_mean[i] = life_law::exp_of(
            profile_interval(data, fit, {Kind::ln_mean_life, result.band_tension_N[i]}));
      },
      options.threads);
  return result;
}

}  // namespace host_sim::calibrate
