#include "lifemodel/life/advice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::damage_of;

std::int64_t log2_q26(double value) {
  return static_cast<std::int64_t>(std::nearbyint(std::ldexp(std::log2(value), 26)));
}
LoadRatio ratio_of(double value) {
  return {static_cast<std::int32_t>(std::nearbyint(std::ldexp(value, 30)))};
}
Ratio risk_of(double value) {
  return pack::from_double<Ratio>(value);
}

// By hand, tensions relative to the ultimate one: at R = 0 a tension of 1/2 has T_a = T_m = 1/4 and
// T_e = 0.25 / (1 - 1/16) = 4/15; at R = -1 T_m is 0; at R = 1/2 0.8 has T_a = 0.2, T_m = 0.6 and
// T_e = 0.2 / 0.64 = 0.3125; at R = -1/2 0.4 has T_a = 0.3, T_m = 0.1 and T_e = 0.3 / 0.99.
TEST(HighestTension, SolvesGerber) {
  EXPECT_NEAR(pack::to_double(highest_tension(log2_q26(4.0 / 15), ratio_of(0))), 0.5, 2e-7);
  EXPECT_NEAR(pack::to_double(highest_tension(log2_q26(0.3), ratio_of(-1))), 0.3, 2e-7);
  EXPECT_NEAR(pack::to_double(highest_tension(log2_q26(0.3125), ratio_of(0.5))), 0.8, 2e-7);
  EXPECT_NEAR(pack::to_double(highest_tension(log2_q26(0.3 / 0.99), ratio_of(-0.5))), 0.4, 2e-7);
}

TEST(HighestTension, IsTheUltimateOneAtMost) {
  EXPECT_EQ(highest_tension(log2_q26(1.5), ratio_of(-1)), Ratio::highest());
  EXPECT_EQ(highest_tension(log2_q26(1e9), ratio_of(0)), Ratio::highest());
  EXPECT_EQ(highest_tension(std::int64_t{-400} << 26, ratio_of(0)), Ratio::lowest());
  // With hardly any amplitude the mean alone reaches it.
  EXPECT_GT(highest_tension(log2_q26(0.5), {LoadRatio::kOne - 1}), risk_of(0.999));
}

TEST(HighestTension, IsTheEffectiveTensionBackwards) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> high(0.01, 0.99);
  std::uniform_real_distribution<double> ratio(-1, 0.95);
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double t = high(random);
    const double r = ratio(random);
    const double effective = t * (1 - r) / 2 / (1 - std::pow(t * (1 + r) / 2, 2));
    const double back = pack::to_double(highest_tension(log2_q26(effective), ratio_of(r)));
    worst = std::max(worst, std::fabs(back / t - 1));
  }
  EXPECT_LT(worst, 4e-7);
}

TEST(SquareRoot, OfSquaresAndTheirNeighbours) {
  for (const std::uint32_t root : {1u, 2u, 3u, 65'535u, 65'536u, 1u << 31, ~0u}) {
    const std::uint64_t square = std::uint64_t{root} * root;
    EXPECT_EQ(square_root(square), root);
    EXPECT_EQ(square_root(square - 1), root - 1);
    EXPECT_EQ(square_root(square + root), root);
  }
  EXPECT_EQ(square_root(0), 0u);
}

CycleLaw law_of(double gamma, double life_at_ultimate) {
  return {pack::from_double<IplExponent>(gamma),
          static_cast<std::int32_t>(std::ldexp(-std::log2(life_at_ultimate), numeric::kExpBits))};
}

// gamma 2 and 1024 cycles at the ultimate tension: 2^-14 a cycle is T_e = (2^-14 2^10)^(1/2) = 1/4.
TEST(RepresentativeCycle, DoesTheDamageOfTheMean) {
  const auto cycle =
      RepresentativeCycle::of(law_of(2, 1024), {1u << 26, -14}, pack::from_double<Tension>(0.25));
  EXPECT_NEAR(static_cast<double>(cycle.log2_effective), std::ldexp(-2, 26), 2);
}

// As above: 1/2 at R = 0 is an effective 4/15, 0.8 at R = 1/2 is 0.3125, 0.3 at R = -1 is 0.3.
TEST(RepresentativeCycle, HasTheRatioOfItsPeak) {
  const auto ratio = [](double effective, double peak) {
    return std::ldexp(
        RepresentativeCycle::of(log2_q26(effective), pack::from_double<Tension>(peak)).ratio.raw,
        -30);
  };
  EXPECT_NEAR(ratio(4.0 / 15, 0.5), 0, 1e-6);
  EXPECT_NEAR(ratio(0.3125, 0.8), 0.5, 1e-6);
  EXPECT_NEAR(ratio(0.3, 0.3), -1, 1e-6);
  EXPECT_EQ(ratio(0.3, 0.2), -1);
  EXPECT_EQ(ratio(2, 1), -1);
  EXPECT_EQ(ratio(0.1, 0), -1);
}

TEST(RepresentativeCycle, ComesBackAsItsPeak) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.02, 0.999);
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double peak = part(random);
    const double effective = peak * part(random);
    const auto cycle =
        RepresentativeCycle::of(log2_q26(effective), pack::from_double<Tension>(peak));
    const double back = pack::to_double(highest_tension(cycle.log2_effective, cycle.ratio));
    worst = std::max(worst, std::fabs(back / peak - 1));
  }
  EXPECT_LT(worst, 3e-6);
}

// By hand: of shape 1 a wire has no memory, and 10 % risk is a damage of -ln 0.9 = 0.1053605. Where
// four times that is needed, the pace is 1/4, and with gamma 2 half of the effective tension, which
// without a mean is half of the tension: 0.2 of 0.4.
TEST(Advise, GivesUpWhatTheDateAsks) {
  const RepresentativeCycle cycle{log2_q26(0.4), ratio_of(-1)};
  const Advice advice = advise(law_of(2, 1e4), pack::from_double<WeibullShape>(1), damage_of(0.5),
                               Hazard::of(risk_of(0.1)), damage_of(0.421442), cycle);
  EXPECT_NEAR(pack::to_double(advice.pace), 0.25, 1e-6);
  EXPECT_NEAR(pack::to_double(advice.tension), 0.2, 1e-6);
}

// Half of what is allowed is needed: with gamma 1 the effective tension may double, 0.2 to 0.4; the
// pace is as it is.
TEST(Advise, AllowsMoreTensionWhereTheDateLeavesIt) {
  const RepresentativeCycle cycle{log2_q26(0.2), ratio_of(-1)};
  const Advice advice = advise(law_of(1, 1e4), pack::from_double<WeibullShape>(1), damage_of(0.5),
                               kHazard50, damage_of(0.5 * std::log(2)), cycle);
  EXPECT_EQ(advice.pace, Ratio::highest());
  EXPECT_NEAR(pack::to_double(advice.tension), 0.4, 1e-6);
}

TEST(Advise, WithoutALoadNothingIsLimited) {
  const RepresentativeCycle cycle{log2_q26(0.2), ratio_of(0)};
  EXPECT_EQ(advise(law_of(1.38, 120), pack::from_double<WeibullShape>(5.94), damage_of(2),
                   kHazard10, Damage{}, cycle),
            Advice{});
}

// The load that is advised has the risk that was accepted.
TEST(Advise, MeetsTheRiskAtTheDate) {
  std::mt19937 random(11);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  double worst_pace = 0;
  double worst_tension = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double gamma = within(1, 6);
    const double shape = within(0.8, 8);
    const double used = within(0.01, 1.3);
    const double risk = within(0.01, 0.9);
    const double needed = within(0.05, 5);
    const double effective = within(0.05, 0.4);
    const double ratio = within(-1, 0.5);
    const Advice advice = advise(law_of(gamma, 1e4), pack::from_double<WeibullShape>(shape),
                                 damage_of(used), Hazard::of(risk_of(risk)), damage_of(needed),
                                 {log2_q26(effective), ratio_of(ratio)});
    const double allowed = std::pow(std::pow(used, shape) - std::log1p(-risk), 1 / shape) - used;
    const double share = allowed / needed;
    worst_pace =
        std::max(worst_pace, std::fabs(pack::to_double(advice.pace) / std::min(share, 1.0) - 1));
    const double t = pack::to_double(advice.tension);
    if (advice.tension == Ratio::highest()) {
      continue;
    }
    const double now = t * (1 - ratio) / 2 / (1 - std::pow(t * (1 + ratio) / 2, 2));
    const double damage = needed * std::pow(now / effective, gamma);
    worst_tension = std::max(worst_tension, std::fabs(damage / allowed - 1));
  }
  // 2e-6 + 1e-7 shape of the further damage, 1.5e-6 of the hazard, and steps of a pace of 0.001.
  EXPECT_LT(worst_pace, 6e-6);
  EXPECT_LT(worst_tension, 1e-5);
}

TEST(Advise, NeverRisesWithWearNorWithALaterDateNorFallsWithTheRisk) {
  const CycleLaw law = law_of(1.38, 120);
  const auto shape = pack::from_double<WeibullShape>(5.94);
  const RepresentativeCycle cycle{log2_q26(0.2), ratio_of(0.1)};
  const auto higher = [](const Advice& a, const Advice& b) {
    const auto more = [](Ratio x, Ratio y) {
      return pack::to_double(x) > pack::to_double(y) * (1 + 3e-6);
    };
    return more(a.tension, b.tension) || more(a.pace, b.pace);
  };
  Advice last;
  for (double used = 0.001; used < 2; used *= 1.0007) {
    const Advice now = advise(law, shape, damage_of(used), kHazard10, damage_of(0.5), cycle);
    ASSERT_FALSE(higher(now, last)) << used;
    last = now;
  }
  EXPECT_LT(last.tension, risk_of(0.05));
  last = {};
  for (double needed = 0.001; needed < 20; needed *= 1.0007) {
    const Advice now = advise(law, shape, damage_of(0.6), kHazard10, damage_of(needed), cycle);
    ASSERT_FALSE(higher(now, last)) << needed;
    last = now;
  }
  last = {Ratio::lowest(), Ratio::lowest()};
  for (double risk = 0.001; risk < 0.99; risk += 0.0007) {
    const Advice now =
        advise(law, shape, damage_of(0.6), Hazard::of(risk_of(risk)), damage_of(0.5), cycle);
    ASSERT_FALSE(higher(last, now)) << risk;
    last = now;
  }
}

TEST(SteadyAdvice, FallsAtOnceAndRisesStepByStep) {
  SteadyAdvice steady;
  EXPECT_EQ(steady.advice(), Advice{});
  steady.take({risk_of(0.5), risk_of(0.25)});
  EXPECT_EQ(steady.advice(), (Advice{risk_of(0.5), risk_of(0.25)}));
  steady.take({risk_of(0.75), risk_of(0.125)});
  EXPECT_EQ(steady.advice(), (Advice{risk_of(0.5 + 1.0 / 1024), risk_of(0.125)}));
  for (int i = 0; i < 255; ++i) {
    steady.take({risk_of(0.75), risk_of(0.25)});
  }
  EXPECT_EQ(steady.advice().tension, risk_of(0.75));
  EXPECT_EQ(steady.advice().pace, risk_of(0.25));
  steady.take({Ratio::highest(), Ratio::lowest()});
  EXPECT_EQ(steady.advice().pace, Ratio::lowest());
}

}  // namespace
}  // namespace lifemodel
