#include "host_sim/diagnose/lives/gain_test.hpp"

#include <limits>
#include <vector>

#include "host_sim/life_law/life_simulation.hpp"
#include "host_sim/statistics/bootstrap.hpp"

namespace host_sim::diagnose::lives {
namespace {

constexpr std::uint64_t kGainStream = 503;

/// The sample with lives that were drawn.
LifeSample sample_with(const LifeSample& sample, const life_law::LifeData& drawn) {
  LifeSample result = sample;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    LifeSample::Specimen& specimen = result.specimens[i];
    specimen.failed = drawn[i].failed;
    specimen.blocks.resize(drawn[i].blocks.size());
    for (std::size_t j = 0; j < specimen.blocks.size(); ++j) {
      specimen.blocks[j].cycles = drawn[i].blocks[j].cycles;
    }
  }
  return result;
}

}  // namespace

double gain_p(const LifeSample& sample, const CommonPrior& prior, const Model& model,
              const ModelFit& nominal, const ModelFit& fit, const GainTestOptions& options) {
  const life_law::LifeData data = life_data_of(sample);
  const LawOfSample of_sample(sample);
  const life_law::LifeFit fitted = of_sample.fit(data);
  if (fitted.problem != statistics::FitProblem::none) {
    return 1;
  }
  const life_law::LifeLaw law = of_sample.law(fitted);
  const life_law::LifeSimulation simulation(data);
  std::vector<double> gains(options.replicates, std::numeric_limits<double>::quiet_NaN());
  const statistics::BootstrapOptions bootstrap{.seed = options.seed,
                                               .stream = kGainStream,
                                               .replicates = options.replicates,
                                               .threads = options.threads};
  statistics::for_each_replicate(bootstrap, [&] {
    return [&, drawn = life_law::LifeData()](statistics::Random& random, std::size_t i) mutable {
      simulation.draw(law, random, drawn);
      const LifeSample replicate = sample_with(sample, drawn);
      if (replicate.failures() < 2) {
        return;
      }
      const ModelView without(replicate, prior, {});
      const ModelView with(replicate, prior, model);
      const ModelFit before = fit_model(without, {nominal.at});
      Eigen::VectorXd neutral = Eigen::VectorXd::Zero(with.coordinates());
      neutral.head(CommonPrior::kCount) = before.at;
      const ModelFit after = fit_model(with, {fit.at, neutral});
      gains[i] = after.log_posterior - before.log_posterior;
    };
  });
  return statistics::bootstrap_p(gains, fit.log_posterior - nominal.log_posterior);
}

}  // namespace host_sim::diagnose::lives
