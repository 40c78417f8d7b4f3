#include "host_sim/calibrate/adequacy.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <limits>
#include <set>
#include <vector>

#include "host_sim/calibrate/streams.hpp"
#include "host_sim/life_law/life_simulation.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::calibrate {
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

}  // namespace host_sim::calibrate
