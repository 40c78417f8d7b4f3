#include "host_sim/diagnose/lives/gain.hpp"

#include "host_sim/diagnose/lives/likelihood.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose::lives {
namespace {

/// Sums over held-out specimens.
struct Score {
  double log_density = 0;
  double before_b10 = 0, known = 0;

  void add(const Score& other) {
    log_density += other.log_density;
    before_b10 += other.before_b10;
    known += other.known;
  }
};

struct Fold {
  std::vector<std::size_t> kept, held_out;
};

std::vector<Fold> folds_of(const LifeSample& sample, bool by_level) {
  constexpr std::size_t kFolds = 5;
  std::vector<Fold> folds(by_level ? sample.levels : kFolds);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const std::size_t own = by_level ? sample.specimens[i].last().level : i % kFolds;
    for (std::size_t f = 0; f < folds.size(); ++f) {
      (f == own ? folds[f].held_out : folds[f].kept).push_back(i);
    }
  }
  std::erase_if(folds, [](const Fold& fold) { return fold.held_out.empty(); });
  return folds;
}

Score score_of(const LifeSample& sample, const Fold& fold, const CommonPrior& prior,
               const Model& model, const Eigen::VectorXd& start) {
  const LifeSample kept = sample.with(fold.kept);
  const LifeSample held_out = sample.with(fold.held_out);
  const ModelView view(kept, prior, model);
  const LifeSettings settings = view.settings(fit_model(view, start).at);
  Score score;
  // What is held out shares its lots with what is kept.
  score.log_density = log_likelihood(sample, settings) - log_likelihood(kept, settings);
  for (const LifeSample::Specimen& specimen : held_out.specimens) {
    constexpr double kB10 = 0.1;
    const bool before = survival(sample, specimen, settings) > 1 - kB10;
    if (specimen.failed || !before) {
      score.known += 1;
      score.before_b10 += before ? 1 : 0;
    }
  }
  return score;
}

}  // namespace

Gain gain_of(const LifeSample& sample, const Model& model, const ModelFit& fit, unsigned threads) {
  constexpr std::size_t kLeastLevels = 4;
  const bool by_level = sample.levels >= kLeastLevels;
  const std::vector<Fold> folds = folds_of(sample, by_level);
  const CommonPrior prior = common_prior(sample);
  std::vector<Score> before(folds.size());
  std::vector<Score> after(folds.size());
  statistics::parallel_for(
      folds.size(),
      [&](std::size_t i) {
        before[i] = score_of(sample, folds[i], prior, {}, {});
        after[i] = score_of(sample, folds[i], prior, model, fit.at);
      },
      threads);
  Score without;
  Score with;
  for (std::size_t i = 0; i < folds.size(); ++i) {
    without.add(before[i]);
    with.add(after[i]);
  }
  const auto size = static_cast<double>(sample.size());
  Gain gain{.held_out_by = by_level ? "level" : "specimen", .metrics = {}};
  gain.metrics.push_back(
      {"log_predictive_density", without.log_density / size, with.log_density / size});
  if (without.known > 0 && with.known > 0) {
    gain.metrics.push_back(
        {"b10_coverage", without.before_b10 / without.known, with.before_b10 / with.known});
  }
  return gain;
}

}  // namespace host_sim::diagnose::lives
