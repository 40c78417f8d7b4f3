#include "firmware/app/derating.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "firmware/app/reporter.hpp"
#include "rig.hpp"
#include "tests/lifemodel/support.hpp"
#include "wire.hpp"

namespace app {
namespace {

using protocol::AdviceState;
using protocol::detail::Advice;

/// gamma 2 and 1024 cycles at the ultimate tension, and no memory: whatever was used, a damage of
/// -ln 0.9 = 0.1053605 is a risk of 10 %.
lifemodel::Parameters plain_parameters(std::uint32_t until_s, double least_N = 0) {
  lifemodel::pack::Constants constants = lifemodel_test::paper_constants();
  constants.hysteresis_N = 0.2;
  constants.ipl_scale = 1024 * 177.4 * 177.4;
  constants.ipl_exponent = 2;
  constants.weibull_shape = 1;
  lifemodel::Parameters parameters = lifemodel_test::parameters_of(constants);
  parameters.watch.advice_until_s = until_s;
  parameters.watch.advice_risk =
      lifemodel::pack::from_double<lifemodel::Ratio>(until_s == 0 ? 0 : 0.1);
  parameters.watch.minimum = lifemodel::pack::tension(least_N, 177.4);
  return parameters;
}

constexpr std::uint32_t kQuarter = 1u << 27;  ///< of the ultimate tension, Q29

/// A tendon or several under a load that is read every second.
template <std::size_t kTendons = 1>
class Loaded {
 public:
  explicit Loaded(std::uint32_t until_s, double least_N = 0) {
    book_.start({});
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      set(tendon, until_s, least_N);
    }
  }
  void set(std::size_t tendon, std::uint32_t until_s, double least_N = 0) {
    const lifemodel::Parameters parameters = plain_parameters(until_s, least_N);
    book_.resume(tendon, std::nullopt, false, 1, parameters.life, Outlook::of(parameters));
  }
  /// So many seconds of a cycle each, from -peak to peak. At a quarter of the ultimate tension its
  /// damage is 2^-14.
  void run(int seconds, std::uint32_t peak = kQuarter) {
    for (int i = 0; i < seconds; ++i) {
      ++now_s_;
      lifemodel::Flags flags;
      if (peak != 0) {
        const double tension = std::ldexp(peak, -29);
        total_.add(lifemodel_test::damage_of(tension * tension / 1024), flags);
        ++cycles_;
      }
      for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
        lifemodel::Reading reading{};
        reading.total = total_;
        reading.closed_cycles = lifemodel::Cycles::from_raw(cycles_);
        book_.take(hal::seconds(now_s_), tendon, reading, {.window_peak = peak});
      }
    }
  }
  void new_wire(std::size_t tendon) { book_.open(tendon, book_.next_epoch(tendon)); }

  Advice page() {
    std::optional<Advice> result;
    EXPECT_TRUE(reporter_.with_page(Advice::kPage, [&](const auto& message) {
      if constexpr (std::is_same_v<std::decay_t<decltype(message)>, Advice>) {
        result = message;
      }
      return true;
    }));
    return result.value_or(Advice{});
  }

 private:
  LifeBook<kTendons> book_;
  std::array<RainflowBins, kTendons> bins_{};
  NodeState state_;
  Reporter<kTendons> reporter_{book_, bins_, state_};
  std::uint32_t now_s_ = 0;
  lifemodel::Damage total_;
  std::uint64_t cycles_ = 0;
};

Advice advice(AdviceState state, int tension, int pace, int tendon = 0) {
  return {.tendon = static_cast<std::uint8_t>(tendon),
          .state = state,
          .highest_tension = static_cast<std::uint16_t>(tension),
          .pace = static_cast<std::uint16_t>(pace)};
}

TEST(Derating, IsOffWhereNothingIsWanted) {
  Loaded load(0);
  load.run(120);
  EXPECT_EQ(load.page(), advice(AdviceState::off, 0xfff, 0xfff));
}

TEST(Derating, IsUnknownBeforeAMinuteHasPassed) {
  Loaded load(7020);
  load.run(59);
  EXPECT_EQ(load.page(), advice(AdviceState::unknown, 0xfff, 0xfff));
}

// After a minute of 60 * 2^-14 there are 116 left: 0.424805 is needed, 0.1053605 allowed. The pace
// is 0.248021, or 992.08 steps of 1/4000; its root times 0.25 is 0.124504, or 498.02 steps.
TEST(Derating, TellsTheTensionAndThePaceThatLastLongEnough) {
  Loaded load(7020);
  load.run(60);
  EXPECT_EQ(load.page(), advice(AdviceState::limited, 498, 992));
}

// 14 minutes need 0.0512695, less than half of what is allowed: 0.25 sqrt(2.05503) = 0.358385.
TEST(Derating, TellsWhatMoreThereIs) {
  Loaded load(900);
  load.run(60);
  EXPECT_EQ(load.page(), advice(AdviceState::no_limit, 1433, 4000));
}

// The tension of above is 22.09 N.
TEST(Derating, KnowsThatAWireHasToPull) {
  Loaded below(7020, 22.0);
  below.run(60);
  EXPECT_EQ(below.page().state, AdviceState::limited);
  Loaded above(7020, 22.2);
  above.run(60);
  EXPECT_EQ(above.page(), advice(AdviceState::unreachable, 498, 992));
}

TEST(Derating, IsOverOnceTheWireHasLastedLongEnough) {
  Loaded load(70);
  load.run(69);
  EXPECT_EQ(load.page().state, AdviceState::no_limit);
  load.run(1);
  EXPECT_EQ(load.page(), advice(AdviceState::over, 4000, 4000));
}

// At rest more and more would do no harm. Each ten seconds the tension rises by 1/1024: after 70 s
// 0.124504 + 7 / 1024 = 0.131340. The pace is that of the loaded minute: at 120 s 115 minutes are
// left, which would allow 0.250178, and two steps lead to 0.249974.
TEST(Derating, RisesStepByStep) {
  Loaded load(7020);
  load.run(60);
  load.run(70, 0);
  EXPECT_EQ(load.page(), advice(AdviceState::no_limit, 525, 999));
}

// Of the 115 minutes that are left then 6900 cycles may do 0.1053605: each 2^-16 * 1.00071, at a
// tension of 0.125044, whatever that of the last minute was.
TEST(Derating, ADriveThatFollowsHearsTheSame) {
  Loaded load(7020);
  load.run(60);
  load.run(70, (498u << 29) / 4000);
  EXPECT_EQ(load.page(), advice(AdviceState::no_limit, 500, 999));
}

// 16 times the cycles' damage: 0.25 of the tension of above for the same cycles, 0.062 of the pace.
TEST(Derating, FallsAtOnce) {
  Loaded load(7020);
  load.run(60);
  load.run(60, 4 * kQuarter);
  const Advice page = load.page();
  EXPECT_EQ(page.state, AdviceState::limited);
  // 115 minutes of 60 / 1024 lives: 6.73828 over 0.1053605 is a pace of 0.0156361.
  EXPECT_EQ(page.pace, 62);
  EXPECT_EQ(page.highest_tension, 500);
}

TEST(Derating, EachTendonHasItsOwnInTurn) {
  Loaded<3> load(7020);
  load.set(1, 0);
  load.run(60);
  EXPECT_EQ(load.page(), advice(AdviceState::limited, 498, 992, 0));
  EXPECT_EQ(load.page(), advice(AdviceState::off, 0xfff, 0xfff, 1));
  EXPECT_EQ(load.page(), advice(AdviceState::limited, 498, 992, 2));
  EXPECT_EQ(load.page().tendon, 0);
}

// The hours of a new wire begin at nothing: 117 minutes are left of 7020 s, one more than before.
// What the old one had risen to is forgotten: 50 cycles a minute at rest for ten seconds may have
// 0.135804 at once.
TEST(Derating, ANewWireHasItsOwn) {
  Loaded load(7020);
  load.run(60);
  load.new_wire(0);
  EXPECT_EQ(load.page().state, AdviceState::unknown);
  load.run(10, 0);
  // 0.1053605 / (117 * 60 * 2^-14) = 0.245902.
  EXPECT_EQ(load.page(), advice(AdviceState::limited, 543, 983));
}

class AdvisedApp : public testing::Test {
 protected:
  Rig<> rig{1.53e8};
};

TEST_F(AdvisedApp, SaysNothingUnlessItIsAsked) {
  rig.start();
  rig.run(63'000);
  const auto pages = rig.sent<Advice>();
  ASSERT_FALSE(pages.empty());
  EXPECT_EQ(pages.back(), Advice{});
}

// 10 to 60 N of 177.4 N: T_e = 25 / (1 - (35 / 177.4)^2) = 26.0125 N, and by 1.53e8 T_e^-1.38 a
// life of 1.70506e6. A minute of 3000 cycles does 1.75947e-3, and 599 minutes of 10 h are
// left: 1.05392. Up to B10 0.684648 - 0.001759 is allowed: 0.64795 of it. Its 1.38th root,
// 0.730191, makes T_e 0.107069 of the ultimate tension, and with R = 1/6 the tension 2 * 0.107069 /
// (5/12 + sqrt((5/12)^2 + (2 * 0.107069 * 7/12)^2)) = 0.251438.
TEST_F(AdvisedApp, TellsWhatLastsTenHours) {
  rig.models[0]->nominal.watch.advice_risk = lifemodel::pack::from_double<lifemodel::Ratio>(0.1);
  rig.models[0]->nominal.watch.advice_until_s = 36'000;
  rig.start();
  rig.run(63'000);
  const Advice page = rig.sent<Advice>().back();
  EXPECT_EQ(page.state, AdviceState::limited);
  EXPECT_NEAR(page.highest_tension, 1005.8, 1);
  EXPECT_NEAR(page.pace, 2591.8, 1);
  EXPECT_EQ(rig.app->lives().records()[0].history.operated_s, 62u);
  // 10 to 30 N, whose peak is that of the third minute.
  rig.run(120'000, 10, 30);
  EXPECT_EQ(rig.app->lives().records()[0].history.peak,
            static_cast<std::uint32_t>(lifemodel::pack::tension(60, 177.4).raw()));
  EXPECT_EQ(rig.app->lives().rates(0).peak(),
            static_cast<std::uint32_t>(lifemodel::pack::tension(30, 177.4).raw()));
}

}  // namespace
}  // namespace app
