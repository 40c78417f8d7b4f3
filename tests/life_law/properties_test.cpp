#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/life_law/life_fit.hpp"
#include "tests/life_law/campaigns.hpp"
#include "tests/life_law/data_sets.hpp"

namespace host_sim::life_law {
namespace {

using statistics::FitProblem;
using Scale = LifeForm::Scale;
using Shape = LifeForm::Shape;

/// Four levels with suspended specimens, some specimens in blocks, and a law of its own each time.
LifeData any_campaign() {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
  const LifeLaw law{.scale = 1.5e5,
                    .exponent = *rc::gen::inRange(5, 60) / 10.0,
                    .shape = *rc::gen::inRange(7, 90) / 10.0};
  LifeData data = testing::paper_like(seed, *rc::gen::inRange<std::size_t>(4, 12), law);
  data = testing::suspended_at(data, 1.1 * law.characteristic_life(46));
  const LifeData blocks = testing::in_blocks(seed, 6, 0.3, law);
  data.insert(data.end(), blocks.begin(), blocks.end());
  return data;
}

/// A few small campaigns do not determine a form; they are left out.
LifeFit fitted(const LifeData& data, LifeForm form = {}) {
  LifeFit fit = fit_life(data, form);
  RC_PRE(fit.problem == FitProblem::none);
  return fit;
}

void near(double value, double expected, double tolerance) {
  RC_ASSERT(value == expected ||
            std::abs(value - expected) <= tolerance * (1 + std::abs(expected)));
}

RC_GTEST_PROP(LifeFitProperty, AnotherUnitOfTensionChangesTheScaleAlone, ()) {
  const LifeData data = any_campaign();
  const double unit = std::exp(*rc::gen::inRange(-50, 50) / 10.0);
  LifeData other = data;
  for (LifeDatum& datum : other) {
    for (LifeDatum::Block& block : datum.blocks) {
      block.effective_tension_N *= unit;
    }
  }
  const LifeFit a = fitted(data);
  const LifeFit b = fitted(other);
  near(b.law().exponent, a.law().exponent, 1e-9);
  near(b.law().shape, a.law().shape, 1e-9);
  near(std::log(b.law().scale), std::log(a.law().scale) + a.law().exponent * std::log(unit), 1e-9);
  near(b.log_likelihood, a.log_likelihood, 1e-12);
}

RC_GTEST_PROP(LifeFitProperty, AnotherUnitOfLifeScalesAlphaAndTheDensities, ()) {
  const LifeData data = any_campaign();
  const double unit = std::exp(*rc::gen::inRange(-80, 80) / 10.0);
  const LifeFit a = fitted(data);
  const LifeFit b = fitted(testing::scaled(data, unit));
  const auto failures =
      std::count_if(data.begin(), data.end(), [](const LifeDatum& datum) { return datum.failed; });
  near(std::log(b.law().scale), std::log(a.law().scale) + std::log(unit), 1e-9);
  near(b.law().exponent, a.law().exponent, 1e-9);
  near(b.law().shape, a.law().shape, 1e-9);
  near(b.log_likelihood, a.log_likelihood - static_cast<double>(failures) * std::log(unit), 1e-11);
}

RC_GTEST_PROP(LifeFitProperty, TheOrderOfSpecimensSaysNothing, ()) {
  const LifeData data = any_campaign();
  LifeData shuffled = data;
  std::shuffle(shuffled.begin(), shuffled.end(),
               std::mt19937(*rc::gen::inRange<std::uint32_t>(0, 1000)));
  const LifeForm form{.scale = *rc::gen::element(Scale::power_law, Scale::curved, Scale::free),
                      .shape = *rc::gen::element(Shape::one, Shape::growing)};
  const LifeFit a = fitted(data, form);
  const LifeFit b = fitted(shuffled, form);
  near(b.log_likelihood, a.log_likelihood, 1e-12);
  for (std::size_t i = 0; i < a.scale.size(); ++i) {
    near(b.scale[i], a.scale[i], 1e-9);
  }
}

RC_GTEST_PROP(LifeFitProperty, ABlockInTwoPartsIsTheSameBlock, ()) {
  const LifeData data = any_campaign();
  LifeData split = data;
  for (LifeDatum& datum : split) {
    const LifeDatum::Block whole = datum.blocks.front();
    const double part = *rc::gen::inRange(1, 99) / 100.0;
    datum.blocks.front().cycles = part * whole.cycles;
    datum.blocks.insert(datum.blocks.begin() + 1,
                        {whole.effective_tension_N, (1 - part) * whole.cycles});
  }
  const LifeFit a = fitted(data);
  near(log_likelihood(split, a), a.log_likelihood, 1e-12);
  const LifeFit b = fitted(split);
  near(b.law().exponent, a.law().exponent, 1e-8);
  near(b.log_likelihood, a.log_likelihood, 1e-12);
}

// Each form holds the former, so that its likelihood is as high at least.
RC_GTEST_PROP(LifeFitProperty, WiderFormsAreNeverLessLikely, ()) {
  LifeData data = any_campaign();
  std::erase_if(data, [](const LifeDatum& datum) { return datum.level == LifeDatum::kNoLevel; });
  const double law = fitted(data).log_likelihood;
  const double curved = fitted(data, {.scale = Scale::curved}).log_likelihood;
  const double growing = fitted(data, {.shape = Shape::growing}).log_likelihood;
  const double both =
      fitted(data, {.scale = Scale::curved, .shape = Shape::growing}).log_likelihood;
  const double levels = fitted(data, {.scale = Scale::free}).log_likelihood;
  constexpr double kRounding = 1e-9;
  RC_ASSERT(curved >= law - kRounding);
  RC_ASSERT(growing >= law - kRounding);
  RC_ASSERT(both >= std::max(curved, growing) - kRounding);
  RC_ASSERT(levels >= curved - kRounding);
}

RC_GTEST_PROP(LifeFitProperty, TheStartSaysNothing, ()) {
  const LifeFit elsewhere = fitted(any_campaign());
  const LifeData data = any_campaign();
  const LifeFit a = fitted(data);
  const LifeFit b = fit_life(data, elsewhere);
  RC_ASSERT(b.problem == FitProblem::none);
  near(b.log_likelihood, a.log_likelihood, 1e-12);
  near(b.law().exponent, a.law().exponent, 1e-8);
  near(b.law().shape, a.law().shape, 1e-8);
}

RC_GTEST_PROP(LifeFitProperty, NoNeighbourIsMoreLikely, ()) {
  const LifeData data = any_campaign();
  const LifeFit best = fitted(data);
  LifeFit neighbour = best;
  neighbour.scale[0] += *rc::gen::inRange(-9, 10) / 1000.0;
  neighbour.scale[1] += *rc::gen::inRange(-9, 10) / 1000.0;
  neighbour.shape[0] += *rc::gen::inRange(-9, 10) / 1000.0;
  near(log_likelihood(data, best), best.log_likelihood, 1e-13);
  RC_ASSERT(log_likelihood(data, neighbour) <= best.log_likelihood + 1e-11);
}

}  // namespace
}  // namespace host_sim::life_law
