#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "host_sim/calibrate/stress_life.hpp"
#include "host_sim/calibrate/use_levels.hpp"
#include "host_sim/life_law/life_fit.hpp"
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

/// Where the truth lies for the interval of each quantity, in one campaign.
std::array<Truth, 5> truths_of(const plan::Design& design, std::size_t number) {
  const auto data = simulated_campaign(design, truth_under(kTruth, design), 20, number);
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

void prove_profile_intervals(const std::string& what, const plan::Design& design) {
  std::vector<std::array<Truth, 5>> found(campaigns(2000));
  statistics::parallel_for(found.size(), [&](std::size_t i) { found[i] = truths_of(design, i); });
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
  prove_profile_intervals("4 levels of 20", whole_design());
}

TEST(ProfileIntervals, CoverUnderSuspension) {
  prove_profile_intervals("4 levels of 20, suspended", suspended_design());
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
