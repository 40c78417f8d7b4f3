#include "host_sim/plan/outlook.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "hal/files/interruption.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::plan {

using hal::files::stop_if_interrupted;

namespace {

struct Campaign {
  double ratio = std::numeric_limits<double>::infinity();
  bool covered = false;
  std::vector<double> longest_cycles;  ///< by level
};

std::vector<double> longest_by_level(const life_law::LifeData& data, std::size_t levels) {
  std::vector<double> longest(levels, 0.0);
  for (const life_law::LifeDatum& specimen : data) {
    longest[specimen.level] = std::max(longest[specimen.level], specimen.blocks.back().cycles);
  }
  return longest;
}

/// One campaign: fitted, and its interval of B10.
Campaign judge(const life_law::LifeData& data, const LifeLaw& law, double use_tension_N) {
  Campaign campaign;
  const life_law::LifeFit fit = life_law::fit_life(data);
  if (fit.problem != statistics::FitProblem::none) {
    return campaign;
  }
  const statistics::Interval interval =
      life_law::profile_interval(data, fit,
                                 {.kind = life_law::LifeQuantity::Kind::ln_quantile,
                                  .effective_tension_N = use_tension_N,
                                  .p = kB10});
  const double truth = std::log(law.quantile(kB10, use_tension_N));
  campaign.ratio = std::exp(interval.high - interval.low);
  campaign.covered = interval.low <= truth && truth <= interval.high;
  return campaign;
}

std::vector<Campaign> judge_all(const LifeLaw& law, const Design& design, double use_tension_N,
                                const SimulationOptions& options) {
  const Truth truth = truth_under(law, design);
  std::vector<Campaign> campaigns(options.simulations);
  statistics::parallel_for(
      campaigns.size(),
      [&](std::size_t i) {
        stop_if_interrupted();
        const auto data = simulated_campaign(design, truth, options.seed, i);
        campaigns[i] = judge(data, law, use_tension_N);
        campaigns[i].longest_cycles = longest_by_level(data, design.levels.size());
      },
      options.threads);
  return campaigns;
}

template <typename Predicate>
double share_of(const std::vector<Campaign>& campaigns, Predicate predicate) {
  return static_cast<double>(std::count_if(campaigns.begin(), campaigns.end(), predicate)) /
         static_cast<double>(campaigns.size());
}

/// The least of `sorted` that the share `p` of them is at or below.
double at_share(const std::vector<double>& sorted, double p) {
  constexpr double kRounding = 1e-9;
  const auto count =
      static_cast<std::size_t>(std::ceil(p * static_cast<double>(sorted.size()) - kRounding));
  return sorted[std::clamp<std::size_t>(count, 1, sorted.size()) - 1];
}

std::vector<Outlook::Level> levels_of(const Design& design, const LifeLaw& law,
                                      const std::vector<Campaign>& campaigns) {
  std::vector<Outlook::Level> levels;
  for (std::size_t i = 0; i < design.levels.size(); ++i) {
    const PlannedLevel& level = design.levels[i];
    double longest_cycles = 0;
    for (const Campaign& campaign : campaigns) {
      longest_cycles += campaign.longest_cycles[i];
    }
    levels.push_back({level.effective_tension_N, level.specimens,
                      expected_failures(level, design.suspend_at_cycles, law),
                      expected_cycles(level, design.suspend_at_cycles, law),
                      longest_cycles / static_cast<double>(campaigns.size())});
  }
  return levels;
}

}  // namespace

std::size_t Outlook::specimens() const {
  return std::accumulate(levels.begin(), levels.end(), std::size_t{0},
                         [](std::size_t sum, const Level& level) { return sum + level.specimens; });
}

double Outlook::failures() const {
  return std::accumulate(levels.begin(), levels.end(), 0.0,
                         [](double sum, const Level& level) { return sum + level.failures; });
}

double Outlook::cycles() const {
  return std::accumulate(levels.begin(), levels.end(), 0.0,
                         [](double sum, const Level& level) { return sum + level.cycles; });
}

Outlook look_out(const LifeLaw& law, const Design& design, const Goal& goal,
                 const SimulationOptions& options) {
  const auto campaigns = judge_all(law, design, goal.use_tension_N, options);
  std::vector<double> ratios;
  ratios.reserve(campaigns.size());
  for (const Campaign& campaign : campaigns) {
    ratios.push_back(campaign.ratio);
  }
  std::sort(ratios.begin(), ratios.end());
  Outlook outlook;
  outlook.levels = levels_of(design, law, campaigns);
  outlook.ratio_median = at_share(ratios, 0.5);
  outlook.ratio_at_assurance = at_share(ratios, goal.assurance);
  outlook.share_within =
      share_of(campaigns, [&](const Campaign& campaign) { return campaign.ratio <= goal.ratio; });
  outlook.coverage = share_of(campaigns, [](const Campaign& campaign) { return campaign.covered; });
  outlook.no_interval =
      share_of(campaigns, [](const Campaign& campaign) { return std::isinf(campaign.ratio); });
  return outlook;
}

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
