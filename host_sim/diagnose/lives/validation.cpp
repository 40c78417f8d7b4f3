#include "host_sim/diagnose/lives/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

#include "host_sim/diagnose/lives/life_settings.hpp"
#include "host_sim/statistics/distribution.hpp"

namespace host_sim::diagnose::lives {
namespace {

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

std::string validation_words(const Campaign& campaign, const ModelView& view, const ModelFit& fit) {
  std::vector<std::string> sentences;
  for (const Level& level : levels_of(campaign)) {
    if (level.role == Campaign::Role::validation && all_failed(level)) {
      sentences.push_back(sentence(level, power_of(level, view, fit)));
    }
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace host_sim::diagnose::lives
