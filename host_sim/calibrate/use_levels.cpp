#include "host_sim/calibrate/use_levels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "host_sim/calibrate/streams.hpp"
#include "host_sim/reference/life.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::calibrate {
namespace {

using QuantityKind = life_law::LifeQuantity::Kind;

constexpr double kB10 = 0.1;
constexpr double kB50 = 0.5;
constexpr double kB90 = 0.9;

/// From the simulated distribution of ln (life / predicted scale) in units of the estimated
/// scatter, which does not depend on the parameters.
Interval prediction_interval(double tension_N, const LifeLaw& law, std::span<const LifeLaw> refits,
                             std::uint64_t stream, const CalibrateOptions& options) {
  constexpr double kTail = 0.025;
  const double truth = std::log(law.characteristic_life(tension_N));
  std::vector<double> pivots;
  pivots.reserve(refits.size());
  for (std::size_t i = 0; i < refits.size(); ++i) {
    if (refits[i].shape > 0) {
      statistics::Random random(options.seed, stream, i);
      const double ln_life = truth + std::log(-std::log(random.uniform())) / law.shape;
      const double predicted = std::log(refits[i].characteristic_life(tension_N));
      pivots.push_back((ln_life - predicted) * refits[i].shape);
    }
  }
  if (pivots.empty()) {
    return {std::nan(""), std::nan("")};
  }
  std::sort(pivots.begin(), pivots.end());
  const auto last = static_cast<double>(pivots.size() - 1);
  const auto end = [&](double p) {
    return std::exp(truth + pivots[static_cast<std::size_t>(std::lround(p * last))] / law.shape);
  };
  return {end(kTail), end(1 - kTail)};
}

}  // namespace

UseLevel use_level(std::string name, double effective_tension_N,
                   std::span<const life_law::LifeDatum> data, const life_law::LifeFit& fit,
                   std::span<const LifeLaw> refits, std::size_t index,
                   const CalibrateOptions& options) {
  const LifeLaw law = fit.law();
  UseLevel use;
  use.name = std::move(name);
  use.effective_tension_N = effective_tension_N;
  use.mean = law.mean_life(effective_tension_N);
  use.b10 = law.quantile(kB10, effective_tension_N);
  use.b50 = law.quantile(kB50, effective_tension_N);
  use.b90 = law.quantile(kB90, effective_tension_N);
  use.mean_ci95 = life_law::exp_of(
      profile_interval(data, fit, {QuantityKind::ln_mean_life, effective_tension_N}));
  use.b10_ci95 = life_law::exp_of(
      profile_interval(data, fit, {QuantityKind::ln_quantile, effective_tension_N, kB10}));
  use.next_specimen_95 = prediction_interval(effective_tension_N, law, refits,
                                             stream_of(Purpose::next_specimen, index), options);
  return use;
}

MixResult mix(std::string name, std::vector<MixResult::Part> parts, double ipl_exponent) {
  std::vector<reference::TensionShare> shares;
  shares.reserve(parts.size());
  for (const MixResult::Part& part : parts) {
    shares.push_back({part.effective_tension_N, part.share});
  }
  MixResult result;
  result.name = std::move(name);
  result.parts = std::move(parts);
  result.by_damage_N = reference::mix_by_damage(shares, ipl_exponent);
  result.by_average_of_lives_N = reference::mix_by_life(shares, ipl_exponent);
  return result;
}

std::vector<MixResult> mixes(const Campaign& campaign, const LifeLaw& law) {
  std::vector<MixResult> found;
  for (const Campaign::Use& use : campaign.uses) {
    if (use.parts.size() > 1) {
      std::vector<MixResult::Part> parts;
      for (const Campaign::Use::Part& part : use.parts) {
        parts.push_back({part.load.effective_tension_N, part.share});
      }
      found.push_back(mix(use.name, std::move(parts), law.exponent));
    }
  }
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    if (!specimen.constant_load()) {
      std::vector<MixResult::Part> parts;
      for (const Campaign::Block& block : specimen.blocks) {
        parts.push_back({block.load.effective_tension_N, block.cycles / specimen.cycles()});
      }
      found.push_back(mix(specimen.name, std::move(parts), law.exponent));
    }
  }
  return found;
}

}  // namespace host_sim::calibrate
