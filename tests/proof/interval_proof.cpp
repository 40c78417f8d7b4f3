#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "host_sim/calibrate/stress_life.hpp"
#include "host_sim/calibrate/use_levels.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/life_law/life_simulation.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "host_sim/statistics/random.hpp"
#include "tests/proof/campaigns.hpp"

namespace host_sim::proof {
namespace {

using QuantityKind = life_law::LifeQuantity::Kind;

struct Wanted {
  std::string name;
  life_law::LifeQuantity quantity;
  double truth;
};

std::array<Wanted, 5> wanted() {
  return {{
      {"scale", {.kind = QuantityKind::ln_scale}, std::log(kTruth.scale)},
      {"exponent", {.kind = QuantityKind::exponent}, kTruth.exponent},
      {"shape", {.kind = QuantityKind::shape}, kTruth.shape},
      {"mean life at the use",
       {.kind = QuantityKind::ln_mean_life, .effective_tension_N = kUseTension_N},
       std::log(kTruth.mean_life(kUseTension_N))},
      {"B10 at the use",
       {.kind = QuantityKind::ln_quantile, .effective_tension_N = kUseTension_N, .p = 0.1},
       std::log(kTruth.quantile(0.1, kUseTension_N))},
  }};
}

enum class Truth { below, inside, above };

/// Draws the campaign of a number.
using Campaigns = std::function<life_law::LifeData(std::size_t number)>;

Campaigns campaigns_of(const plan::Design& design) {
  return [design](std::size_t number) {
    return simulated_campaign(design, truth_under(kTruth, design), 20, number);
  };
}

/// Where the truth lies for the interval of each quantity, in one campaign.
std::array<Truth, 5> truths_of(const Campaigns& draw, std::size_t number) {
  const life_law::LifeData data = draw(number);
  const life_law::LifeFit fit = life_law::fit_life(data);
  EXPECT_EQ(fit.problem, statistics::FitProblem::none) << "campaign " << number;
  std::array<Truth, 5> found{};
  const auto quantities = wanted();
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const auto interval = life_law::profile_interval(data, fit, quantities[i].quantity);
    found[i] = quantities[i].truth < interval.low    ? Truth::below
               : quantities[i].truth > interval.high ? Truth::above
                                                     : Truth::inside;
  }
  return found;
}

void prove_profile_intervals(const std::string& what, const Campaigns& draw) {
  std::vector<std::array<Truth, 5>> found(campaigns(2000));
  statistics::parallel_for(found.size(), [&](std::size_t i) { found[i] = truths_of(draw, i); });
  const auto quantities = wanted();
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    Share inside{0, found.size()};
    Share below{0, found.size()};
    for (const auto& truths : found) {
      inside.holds += truths[i] == Truth::inside ? 1U : 0U;
      below.holds += truths[i] == Truth::below ? 1U : 0U;
    }
    report(what + ", 95 % interval of the " + quantities[i].name + " holds the truth", inside);
    report(what + ", 95 % interval of the " + quantities[i].name + " is above the truth", below);
    // 0.02 is what is wanted; it is 4 binomial errors of 2,000 campaigns.
    EXPECT_NEAR(inside.value(), 0.95, std::max(0.02, inside.tolerance(0.95, 4)))
        << quantities[i].name;
  }
}

TEST(ProfileIntervals, CoverWithoutSuspension) {
  prove_profile_intervals("4 levels of 20", campaigns_of(whole_design()));
}

TEST(ProfileIntervals, CoverUnderSuspension) {
  prove_profile_intervals("4 levels of 20, suspended", campaigns_of(suspended_design()));
}

/// Campaigns of the design whose specimens are seen as `see` says of the first, the second and so
/// on of each level.
Campaigns seen_as(const std::function<void(life_law::LifeDatum&, std::size_t)>& see) {
  const plan::Design design = whole_design();
  life_law::LifeData like;
  for (std::size_t i = 0; i < design.levels.size(); ++i) {
    const double tension_N = design.levels[i].effective_tension_N;
    const double life = std::floor(kTruth.characteristic_life(tension_N));
    for (std::size_t j = 0; j < design.levels[i].specimens; ++j) {
      like.push_back({.blocks = {{tension_N, life}}, .level = i});
      see(like.back(), j);
    }
  }
  return [simulation = life_law::LifeSimulation(like)](std::size_t number) {
    constexpr std::uint64_t kStream = 20;
    statistics::Random random(20, kStream, number);
    life_law::LifeData drawn;
    simulation.draw(kTruth, random, drawn);
    return drawn;
  };
}

TEST(ProfileIntervals, CoverWithInspectionsEvery100Cycles) {
  prove_profile_intervals("4 levels of 20, inspected every 100 cycles",
                          seen_as([](life_law::LifeDatum& specimen, std::size_t) {
                            specimen.from_cycles = 500.0;
                            specimen.blocks.front().cycles = 600;
                          }));
}

TEST(ProfileIntervals, CoverWithTheBestAndTheWorstDropped) {
  prove_profile_intervals("4 levels of 20, best and worst dropped",
                          seen_as([](life_law::LifeDatum& specimen, std::size_t number) {
                            specimen.trimmed = number < 2;
                            specimen.failed = number != 1;
                            if (number == 0) {
                              specimen.from_cycles = 0.0;
                            }
                          }));
}

/// Whether the interval from one campaign holds the life of one more specimen.
bool holds(const plan::Design& design, std::size_t number) {
  constexpr std::uint64_t kStreamOfNext = 1000;
  const auto data = simulated_campaign(design, truth_under(kTruth, design), 30, number);
  const life_law::LifeFit fit = life_law::fit_life(data);
  calibrate::CalibrateOptions options;
  options.seed = number;
  options.bootstraps = 400;
  options.threads = 1;
  const auto refits = calibrate::refitted_laws(data, fit.law(), options);
  const auto use = calibrate::use_level("use", kUseTension_N, data, fit, refits, 0, options);
  statistics::Random random(30, kStreamOfNext, number);
  const double life = kTruth.quantile(random.uniform(), kUseTension_N);
  return use.next_specimen_95.low <= life && life <= use.next_specimen_95.high;
}

void prove_prediction_interval(const std::string& what, const plan::Design& design) {
  // Bytes, as threads write side by side.
  std::vector<char> held(campaigns(1000));
  statistics::parallel_for(held.size(), [&](std::size_t i) { held[i] = holds(design, i) ? 1 : 0; });
  Share share{0, held.size()};
  for (const char one : held) {
    share.holds += one != 0 ? 1U : 0U;
  }
  report(what + ", 95 % prediction interval holds the next life", share);
  EXPECT_NEAR(share.value(), 0.95, std::max(0.02, share.tolerance(0.95, 4)));
}

TEST(PredictionInterval, CoversWithoutSuspension) {
  prove_prediction_interval("4 levels of 20", whole_design());
}

TEST(PredictionInterval, CoversUnderSuspension) {
  prove_prediction_interval("4 levels of 20, suspended", suspended_design());
}

}  // namespace
}  // namespace host_sim::proof
