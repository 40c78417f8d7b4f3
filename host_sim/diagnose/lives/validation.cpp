#include "host_sim/diagnose/lives/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

#include "host_sim/diagnose/lives/life_settings.hpp"
#include "host_sim/diagnose/lives/likelihood.hpp"
#include "host_sim/statistics/distribution.hpp"
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
               const Model& model, const std::vector<Eigen::VectorXd>& starts) {
  const LifeSample kept = sample.with(fold.kept);
  const LifeSample held_out = sample.with(fold.held_out);
  const ModelView view(kept, prior, model);
  const LifeSettings settings = view.settings(fit_model(view, starts).at);
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

constexpr double kPower_z = 0.8416212335729143;  ///< of 80 %

double ln_mean_sd(double shape) {
  const double mean = std::tgamma(1 + 1 / shape);
  return std::sqrt(std::tgamma(1 + 2 / shape) / (mean * mean) - 1);
}

double mean_of(const Level& level) {
  double sum = 0;
  for (const Campaign::Specimen* specimen : level.specimens) {
    sum += specimen->cycles();
  }
  return sum / static_cast<double>(level.specimens.size());
}

bool all_failed(const Level& level) {
  return std::ranges::all_of(level.specimens, [](const Campaign::Specimen* specimen) {
    return specimen->status == Campaign::Status::failed;
  });
}

/// Of the nominal law, whose first three coordinates are ln of life, exponent and shape.
ValidationPower power_of(const Level& level, const ModelView& view, const ModelFit& fit) {
  const LifeSettings settings = view.settings(fit.at);
  const double away =
      std::log(level.load.effective_tension_N) - centre_ln_N(view.sample(), settings);
  const double ln_life = settings.ln_life_at_centre - settings.exponent * away;
  Eigen::Vector2d slope(CommonPrior::kLife_sd,
                        -settings.exponent * CommonPrior::kLogExponent_sd * away);
  const double variance = slope.dot(fit.covariance.topLeftCorner<2, 2>() * slope);
  return {.specimens = level.specimens.size(),
          .ln_deviation = std::log(mean_of(level)) - ln_life - std::lgamma(1 + 1 / settings.shape),
          .ln_sd = ln_mean_sd(settings.shape),
          .ln_sd_of_law = std::sqrt(variance)};
}

std::string sentence(const Level& level, const ValidationPower& power) {
  const double percent = 100 * std::expm1(power.ln_deviation);
  std::string text = fmt::format(
      "{} validation specimens at {:.1f} N live {:.1f} % {} than the law says (p = {:.2g})",
      power.specimens, level.load.effective_tension_N, std::abs(percent),
      percent < 0 ? "shorter" : "longer", power.p());
  if (power.p() < 0.05) {
    return text + ".";
  }
  const std::size_t needed = power.specimens_needed();
  text += fmt::format(": not decidable with {}. ", power.specimens);
  text += needed > 0 ? fmt::format(
                           "{} would find such a deviation at 5 % in 80 % of campaigns (normal "
                           "approximation of ln of the mean life).",
                           needed)
                     : std::string(
                           "No number would, before the law itself is known better (normal "
                           "approximation of ln of the mean life).");
  return text;
}

}  // namespace

HeldOutGain gain_of(const LifeSample& sample, const Model& model, const ModelFit& fit,
                    unsigned threads) {
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
        after[i] = score_of(sample, folds[i], prior, model, {fit.at});
      },
      threads);
  Score without;
  Score with;
  for (std::size_t i = 0; i < folds.size(); ++i) {
    without.add(before[i]);
    with.add(after[i]);
  }
  const auto size = static_cast<double>(sample.size());
  HeldOutGain gain{.held_out_by = by_level ? "level" : "specimen", .metrics = {}};
  gain.metrics.push_back(
      {"log_predictive_density", without.log_density / size, with.log_density / size});
  if (without.known > 0 && with.known > 0) {
    gain.metrics.push_back(
        {"b10_coverage", without.before_b10 / without.known, with.before_b10 / with.known});
  }
  return gain;
}

double ValidationPower::p() const {
  const double sd = std::hypot(ln_sd / std::sqrt(static_cast<double>(specimens)), ln_sd_of_law);
  const boost::math::normal standard;
  return 2 * boost::math::cdf(boost::math::complement(standard, std::abs(ln_deviation) / sd));
}

std::size_t ValidationPower::specimens_needed() const {
  const double wanted_sd = std::abs(ln_deviation) / (statistics::kNormal95 + kPower_z);
  const double left = wanted_sd * wanted_sd - ln_sd_of_law * ln_sd_of_law;
  constexpr double kMost = 1e6;
  const double needed = left > 0 ? std::ceil(ln_sd * ln_sd / left) : kMost;
  return needed < kMost ? static_cast<std::size_t>(needed) : 0;
}

std::string validation_prose(const Campaign& campaign, const ModelView& view, const ModelFit& fit) {
  std::vector<std::string> sentences;
  for (const Level& level : levels_of(campaign)) {
    if (level.role == Campaign::Role::validation && all_failed(level)) {
      sentences.push_back(sentence(level, power_of(level, view, fit)));
    }
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace host_sim::diagnose::lives
