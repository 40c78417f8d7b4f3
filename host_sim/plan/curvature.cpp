#include "host_sim/plan/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host_sim/io/interruption.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::plan {
namespace {

using life_law::LifeFit;
using life_law::LifeForm;

constexpr double kSignificance = 0.05;

/// 2 (log L curved - log L straight); 0 where one of them cannot be fitted.
double likelihood_ratio(const life_law::LifeData& campaign) {
  const LifeFit straight = life_law::fit_life(campaign);
  const LifeFit curved = life_law::fit_life(campaign, LifeForm{LifeForm::Scale::curved});
  const bool fitted = straight.problem == statistics::FitProblem::none &&
                      curved.problem == statistics::FitProblem::none;
  return fitted ? 2 * (curved.log_likelihood - straight.log_likelihood) : 0;
}

std::vector<double> likelihood_ratios(const Design& design, const Truth& truth,
                                      const SimulationOptions& options) {
  std::vector<double> ratios(options.simulations);
  statistics::parallel_for(
      ratios.size(),
      [&](std::size_t i) {
        stop_if_interrupted();
        ratios[i] = likelihood_ratio(simulated_campaign(design, truth, options.seed, i));
      },
      options.threads);
  return ratios;
}

/// What the share `kSignificance` of `ratios` is above.
double critical_value(std::vector<double> ratios) {
  std::sort(ratios.begin(), ratios.end());
  const auto above = static_cast<std::size_t>(kSignificance * static_cast<double>(ratios.size()));
  return ratios[ratios.size() - 1 - above];
}

}  // namespace

Truth truth_under(const LifeLaw& law, const Curvature& curvature, const Design& design) {
  std::vector<double> tested_N;
  for (const PlannedLevel& level : design.levels) {
    if (level.specimens > 0) {
      tested_N.push_back(level.effective_tension_N);
    }
  }
  const double low = std::log(tested_N.front());
  const double high = std::log(tested_N.back());
  const double use = std::log(curvature.use_tension_N);
  const double at = low <= use && use <= high ? (low + high) / 2 : use;
  Truth truth = truth_under(law, design);
  for (std::size_t i = 0; i < design.levels.size(); ++i) {
    const double x = std::log(design.levels[i].effective_tension_N);
    const double share = (x - low) * (x - high) / ((at - low) * (at - high));
    truth.characteristic_life_cycles[i] *= std::pow(curvature.factor, -share);
  }
  return truth;
}

std::optional<double> power_to_see(const Curvature& curvature, const LifeLaw& law,
                                   const Design& design, const SimulationOptions& options) {
  if (design.tested_levels() < 3) {
    return std::nullopt;
  }
  const double critical =
      critical_value(likelihood_ratios(design, truth_under(law, design), options));
  const auto bent = likelihood_ratios(design, truth_under(law, curvature, design), options);
  const auto seen =
      std::count_if(bent.begin(), bent.end(), [&](double ratio) { return ratio > critical; });
  return static_cast<double>(seen) / static_cast<double>(bent.size());
}

}  // namespace host_sim::plan
