#include "host_sim/diagnose/tension/possible_scatter.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/evidence.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kImpossible = 14;  ///< of -2 ln likelihood, above the least

}  // namespace

PossibleScatter::PossibleScatter(const Grams& grams, double sample_sd, Eigen::Index refitted,
                                 const Products& measured)
    : grams_(grams) {
  for (NoiseModel noise : scatter_values()) {
    noise.sample_sd = sample_sd;
    scores_.emplace_back(grams, noise, refitted);
  }
  const std::vector<double> all = deviances(measured);
  const double least = std::ranges::min(all);
  std::vector<ScatterScore> possible;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] <= least + kImpossible) {
      possible.push_back(std::move(scores_[i]));
      possible.back().look_at_probes(grams);
    }
  }
  scores_ = std::move(possible);
}

std::vector<double> PossibleScatter::deviances(const Products& products) const {
  std::vector<double> deviances;
  for (const ScatterScore& score : scores_) {
    deviances.push_back(score.deviance(grams_, products));
  }
  return deviances;
}

const ScatterScore& PossibleScatter::best(const Products& products) const {
  const std::vector<double> all = deviances(products);
  return scores_[static_cast<std::size_t>(std::ranges::min_element(all) - all.begin())];
}

const ScatterScore& PossibleScatter::drawn(const std::vector<double>& deviances,
                                           double uniform) const {
  const double least = std::ranges::min(deviances);
  double sum = 0;
  for (const double deviance : deviances) {
    sum += std::exp((least - deviance) / 2);
  }
  double rest = uniform * sum;
  for (std::size_t i = 0; i < deviances.size(); ++i) {
    rest -= std::exp((least - deviances[i]) / 2);
    if (rest <= 0) {
      return scores_[i];
    }
  }
  return scores_.back();
}

}  // namespace host_sim::diagnose
