#include "host_sim/calibrate/stress_life.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "host_sim/calibrate/streams.hpp"
#include "host_sim/life_law/life_simulation.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::calibrate {

std::vector<LifeLaw> refitted_laws(std::span<const life_law::LifeDatum> data, const LifeLaw& law,
                                   const CalibrateOptions& options) {
  constexpr std::size_t kChunk = 64;
  const life_law::LifeSimulation simulation(data);
  const life_law::LifeFit start = life_law::fit_life(data);
  std::vector<LifeLaw> laws(options.bootstraps);
  const std::size_t chunks = (laws.size() + kChunk - 1) / kChunk;
  statistics::parallel_for(
      chunks,
      [&](std::size_t chunk) {
        life_law::LifeData drawn;
        const std::size_t end = std::min(laws.size(), (chunk + 1) * kChunk);
        for (std::size_t i = chunk * kChunk; i < end; ++i) {
          statistics::Random random(options.seed, stream_of(Purpose::campaigns), i);
          simulation.draw(law, random, drawn);
          const life_law::LifeFit fit = life_law::fit_life(drawn, start);
          if (fit.problem == statistics::FitProblem::none) {
            laws[i] = fit.law();
          }
        }
      },
      options.threads);
  return laws;
}

namespace {

using life_law::LifeForm;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The law against one wider form.
struct Alternative {
  LifeForm form;
  double degrees_of_freedom = 1;
  bool levels_alone = false;  ///< the wider form has nothing to say of specimens in blocks
};

std::set<double> tensions(std::span<const life_law::LifeDatum> data, bool failures_alone) {
  std::set<double> found;
  for (const life_law::LifeDatum& datum : data) {
    if (datum.failed || !failures_alone) {
      for (const life_law::LifeDatum::Block& block : datum.blocks) {
        found.insert(block.effective_tension_N);
      }
    }
  }
  return found;
}

life_law::LifeData at_levels(std::span<const life_law::LifeDatum> data) {
  life_law::LifeData found;
  std::copy_if(data.begin(), data.end(), std::back_inserter(found),
               [](const auto& datum) { return datum.level != life_law::LifeDatum::kNoLevel; });
  return found;
}

std::set<std::size_t> levels_with_failures(std::span<const life_law::LifeDatum> data) {
  std::set<std::size_t> found;
  for (const life_law::LifeDatum& datum : data) {
    if (datum.failed && datum.level != life_law::LifeDatum::kNoLevel) {
      found.insert(datum.level);
    }
  }
  return found;
}

/// The likelihood ratio, or NaN where one of the two has no fit.
double statistic(std::span<const life_law::LifeDatum> data, LifeForm wider) {
  const life_law::LifeFit law = life_law::fit_life(data);
  const life_law::LifeFit other = life_law::fit_life(data, wider);
  if (law.problem != statistics::FitProblem::none ||
      other.problem != statistics::FitProblem::none) {
    return kNone;
  }
  return std::max(0.0, 2 * (other.log_likelihood - law.log_likelihood));
}

double simulated_p(std::span<const life_law::LifeDatum> data, const LifeLaw& law,
                   const Alternative& alternative, double measured, std::size_t index,
                   const CalibrateOptions& options) {
  constexpr std::size_t kShare = 5;
  const life_law::LifeSimulation simulation(data);
  std::vector<double> drawn(options.bootstraps / kShare);
  statistics::parallel_for(
      drawn.size(),
      [&](std::size_t i) {
        life_law::LifeData replicate;
        statistics::Random random(options.seed, stream_of(Purpose::adequacy, index), i);
        simulation.draw(law, random, replicate);
        drawn[i] = statistic(replicate, alternative.form);
      },
      options.threads);
  const auto fitted = std::count_if(drawn.begin(), drawn.end(), [](double s) { return s >= 0; });
  const auto beyond =
      std::count_if(drawn.begin(), drawn.end(), [measured](double s) { return s >= measured; });
  return static_cast<double>(1 + beyond) / static_cast<double>(1 + fitted);
}

std::optional<Test> test(std::span<const life_law::LifeDatum> data, const LifeLaw& law,
                         const Alternative& alternative, std::size_t index,
                         const CalibrateOptions& options) {
  const life_law::LifeData chosen =
      alternative.levels_alone ? at_levels(data) : life_law::LifeData(data.begin(), data.end());
  Test result;
  result.statistic = statistic(chosen, alternative.form);
  if (!(result.statistic >= 0)) {
    return std::nullopt;
  }
  result.degrees_of_freedom = alternative.degrees_of_freedom;
  result.p_chi_square = boost::math::cdf(boost::math::complement(
      boost::math::chi_squared(result.degrees_of_freedom), result.statistic));
  result.p_simulated = simulated_p(chosen, law, alternative, result.statistic, index, options);
  return result;
}

}  // namespace

void test_adequacy(std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                   const CalibrateOptions& options, StressLife& result) {
  constexpr std::size_t kLawParameters = 2;
  const LifeLaw law = fit.law();
  const std::size_t levels = levels_with_failures(data).size();
  if (levels > kLawParameters) {
    const auto freedom = static_cast<double>(levels - kLawParameters);
    result.against_free_levels =
        test(data, law, {{LifeForm::Scale::free, LifeForm::Shape::one}, freedom, true}, 0, options);
  }
  if (tensions(data, false).size() > kLawParameters) {
    result.against_curvature =
        test(data, law, {{LifeForm::Scale::curved, LifeForm::Shape::one}}, 1, options);
  }
  if (tensions(data, true).size() >= 2) {
    result.against_growing_scatter =
        test(data, law, {{LifeForm::Scale::power_law, LifeForm::Shape::growing}}, 2, options);
  }
}

namespace {

using QuantityKind = life_law::LifeQuantity::Kind;

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

/// Further tensions in even ratios, a little beyond the least and the largest of the uses.
void reach(std::vector<double>& tensions_N, std::span<const double> use_N) {
  constexpr double kMargin = 1.05;
  constexpr int kSteps = 8;
  const auto steps = [](double from, double to) {
    std::vector<double> further;
    for (int i = 1; i <= kSteps; ++i) {
      further.push_back(from * std::pow(to / from, static_cast<double>(i) / kSteps));
    }
    return further;
  };
  for (const double use : use_N) {
    if (const double low = use / kMargin; low < tensions_N.front()) {
      const std::vector<double> below = steps(tensions_N.front(), low);
      tensions_N.insert(tensions_N.begin(), below.rbegin(), below.rend());
    }
    if (const double high = use * kMargin; high > tensions_N.back()) {
      const std::vector<double> above = steps(tensions_N.back(), high);
      tensions_N.insert(tensions_N.end(), above.begin(), above.end());
    }
  }
}

}  // namespace

StressLife stress_life(std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                       std::span<const LifeLaw> refits, std::span<const LevelResult> levels,
                       const std::optional<CommonShape>& shape, std::span<const double> use_N,
                       const CalibrateOptions& options) {
  StressLife result;
  result.law = fit.law();
  result.log_likelihood = fit.log_likelihood;
  result.scale_ci95 = life_law::exp_of(profile_interval(data, fit, {QuantityKind::ln_scale}));
  result.exponent_ci95 = profile_interval(data, fit, {QuantityKind::exponent});
  result.shape_ci95 = profile_interval(data, fit, {QuantityKind::shape});
  result.pivot_tension_N = life_law::pivot_tension_N(data, fit);
  result.life_at_pivot_ci95 = life_law::exp_of(profile_interval(
      data, fit, {QuantityKind::ln_quantile, result.pivot_tension_N, -std::expm1(-1.0)}));
  result.shape_unbiased = without_bias(result.law.shape, refits);
  if (shape) {
    fit_as_the_paper(levels, *shape, result);
  }
  test_adequacy(data, fit, options, result);
  result.band_tension_N = band_tensions(levels, data);
  result.tested_N = {result.band_tension_N.front(), result.band_tension_N.back()};
  reach(result.band_tension_N, use_N);
  result.band_mean.resize(result.band_tension_N.size());
  statistics::parallel_for(
      result.band_mean.size(),
      [&](std::size_t i) {
        result.band_mean[i] = life_law::exp_of(
            profile_interval(data, fit, {QuantityKind::ln_mean_life, result.band_tension_N[i]}));
      },
      options.threads);
  return result;
}

}  // namespace host_sim::calibrate
