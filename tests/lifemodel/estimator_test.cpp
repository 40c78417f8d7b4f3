#include "lifemodel/estimator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::HostLayout;
using lifemodel_test::newtons;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using lifemodel_test::Signal;
using pack::to_double;

void expect_same(const Reading& a, const Reading& b) {
  EXPECT_EQ(a.closed, b.closed);
  EXPECT_EQ(a.open, b.open);
  EXPECT_EQ(a.total, b.total);
  EXPECT_EQ(a.closed_cycles, b.closed_cycles);
  EXPECT_EQ(a.open_half_cycles, b.open_half_cycles);
  EXPECT_EQ(a.flags, b.flags);
}

std::vector<Signal> signals() {
  return {lifemodel_test::white_noise(1, 400, 0, 100), lifemodel_test::walk(2, 400),
          lifemodel_test::quantised(3, 400, 5),        lifemodel_test::quantised(4, 400, 2),
          lifemodel_test::spiral(200, 0.25, true),     lifemodel_test::spiral(200, 0.25, false),
          lifemodel_test::white_noise(5, 400, -20, 20)};
}

Reading at_once(const Parameters& p, std::span<const Tension> signal) {
  Estimator<1, HostLayout> estimator({p});
  estimator.replay(0, signal);
  return estimator.reading(0);
}

TEST(Estimator, OnlineEqualsOfflineAtEveryPrefix) {
  for (const double hysteresis_N : {0.0, 0.2, 15.0}) {
    auto constants = paper_constants();
    constants.hysteresis_N = hysteresis_N;
    const Parameters p = parameters_of(constants);
    for (const Signal& signal : signals()) {
      Estimator<1> online({p});
      for (std::size_t n = 0; n < signal.size(); ++n) {
        online.push(0, signal[n]);
        while (online.settle()) {
        }
        expect_same(online.reading(0), at_once(p, std::span(signal).first(n + 1)));
        ASSERT_FALSE(HasFailure()) << "after " << n + 1 << " samples";
      }
    }
  }
}

TEST(Estimator, ChunksAndTheHourOfSettlingDoNotMatter) {
  const Parameters p = parameters_of(paper_constants());
  std::mt19937 random(17);
  for (const Signal& signal : signals()) {
    const Reading whole = at_once(p, signal);
    for (int attempt = 0; attempt < 20; ++attempt) {
      Estimator<1> estimator({p});
      std::size_t position = 0;
      while (position < signal.size()) {
        const std::size_t chunk =
            std::min<std::size_t>(1 + random() % 24, signal.size() - position);
        if (random() % 2 == 0) {
          estimator.replay(0, std::span(signal).subspan(position, chunk));
        } else {
          for (std::size_t i = 0; i < chunk; ++i) {
            estimator.push(0, signal[position + i]);
          }
          while (random() % 8 != 0 && estimator.settle()) {
          }
          if (random() % 4 == 0) {
            (void)estimator.reading(0);
          }
          while (estimator.settle()) {
          }
        }
        position += chunk;
      }
      expect_same(estimator.reading(0), whole);
    }
  }
}

TEST(Estimator, ReadingDoesNotDisturb) {
  const Parameters p = parameters_of(paper_constants());
  const Signal signal = lifemodel_test::walk(8, 3000);
  Estimator<1> read({p});
  Estimator<1> left({p});
  for (const Tension sample : signal) {
    read.push(0, sample);
    left.push(0, sample);
    while (left.settle()) {
    }
    (void)read.reading(0);
    (void)read.reading(0);
  }
  expect_same(read.reading(0), left.reading(0));
}

TEST(Estimator, TheReadingNeverFalls) {
  for (const double exponent : {1.0, 1.38, 6.5, 12.0}) {
    auto constants = paper_constants();
    constants.ipl_exponent = exponent;
    constants.hysteresis_N = exponent == 12.0 ? 0 : 0.2;
    constants.ipl_scale = exponent == 12.0 ? 1e40 : 1.53e5;  // cycles of a few steps
    const Parameters p = parameters_of(constants);
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
      for (const Signal& signal :
           {lifemodel_test::white_noise(seed, 4000, -30, 176), lifemodel_test::walk(seed, 4000),
            lifemodel_test::white_noise(seed, 4000, 50, 50.5),
            lifemodel_test::white_noise(seed, 2000, 100, 200)}) {
        Estimator<1> estimator({p});
        Damage before;
        for (const Tension sample : signal) {
          estimator.push(0, sample);
          const Damage now = estimator.reading(0).total;
          ASSERT_LE(before, now);
          before = now;
        }
      }
    }
  }
}

TEST(Estimator, AWireUnderConstantTensionAccumulatesNothing) {
  Estimator<1> estimator({parameters_of(paper_constants())});
  for (int i = 0; i < 100'000; ++i) {
    estimator.push(0, newtons(49));
    EXPECT_FALSE(estimator.settle());
  }
  const Reading r = estimator.reading(0);
  EXPECT_EQ(r.total, Damage{});
  EXPECT_EQ(r.closed_cycles.raw(), 0u);
  EXPECT_EQ(r.open_half_cycles.raw(), 0u);
  EXPECT_TRUE(r.flags.none());
}

TEST(Estimator, PaperAt270DegreesUsesALifeInItsScale) {
  // 49 N over 270 deg: T_in 26.806 .. 89.569 N, T_eff 35.164 N, alpha = 1.53e5 / 35.164^1.38 =
  // 1124.8.
  Estimator<1> estimator({parameters_of(paper_constants())});
  const auto bend = parameters_of(paper_constants()).bend;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    for (const auto direction : {Direction::pulling, Direction::releasing}) {
      estimator.push(0, newtons(49), direction, bend);
      while (estimator.settle()) {
      }
    }
  }
  const double d = to_double(estimator.reading(0).total);
  EXPECT_NEAR(999.5 / d, 1124.78, 0.05);
}

TEST(Estimator, CurrentAndTensionAreTheSameInput) {
  const Parameters p = parameters_of(paper_constants());
  Estimator<1> by_current({p});
  Estimator<1> by_tension({p});
  const double gain_N_A = 0.0325 * 9 * 0.88 / 0.0125;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 5);
  for (int i = 0; i < 2000; ++i) {
    const double current_A = uniform(random);
    by_current.push(0, pack::from_double<MotorCurrent>(current_A));
    by_tension.push(0, newtons(current_A * gain_N_A));
    while (by_current.settle() || by_tension.settle()) {
    }
  }
  EXPECT_NEAR(to_double(by_current.reading(0).total) / to_double(by_tension.reading(0).total), 1,
              2e-7);
}

TEST(Estimator, TendonsDoNotDisturbEachOther) {
  std::array<Parameters, 4> parameters{};
  std::array<Signal, 4> signal;
  for (std::size_t t = 0; t < 4; ++t) {
    auto constants = paper_constants();
    constants.ipl_exponent = 1.38 + static_cast<double>(t);
    parameters[t] = parameters_of(constants);
    signal[t] = lifemodel_test::white_noise(static_cast<std::uint32_t>(t), 5000, 0, 100);
  }
  Estimator<4> together(parameters);
  for (std::size_t i = 0; i < 5000; ++i) {
    for (std::size_t t = 0; t < 4; ++t) {
      together.push(t, signal[t][i]);
    }
    while (together.settle()) {
    }
  }
  for (std::size_t t = 0; t < 4; ++t) {
    expect_same(together.reading(t), at_once(parameters[t], signal[t]));
  }
}

TEST(Estimator, PushSaysWhetherThereIsSomethingToSettle) {
  auto constants = paper_constants();
  constants.hysteresis_N = 0.2;
  for (const Signal& signal : signals()) {
    Estimator<1> estimator({parameters_of(constants)});
    for (const Tension sample : signal) {
      const bool due = estimator.push(0, sample);
      EXPECT_EQ(estimator.settle(), due);
      while (estimator.settle()) {
      }
      EXPECT_FALSE(estimator.push(0, sample)) << "the same tension again turns nowhere";
    }
  }
}

/// Ranges about 50 N that nest `depth` deep, then one around all of them, again and again; a
/// turning point in each sample.
Signal nested(std::size_t depth, std::size_t times) {
  std::vector<double> values_N;
  for (std::size_t i = 0; i < times * (depth + 2); ++i) {
    const std::size_t place = i % (depth + 2);
    const double swing_N = place < depth ? 45 - 0.3 * static_cast<double>(place) : 60;
    values_N.push_back(50 + (place % 2 == 0 ? swing_N : -swing_N));
  }
  return newtons(values_N);
}

TEST(Estimator, OneSettleForEachPushThatSaysSoIsInTime) {
  const Parameters p = parameters_of(paper_constants());
  for (const std::size_t depth : {2u, 30u, 60u, 90u, 116u, 124u}) {
    const Signal signal = nested(depth, 20);
    Estimator<4> estimator({p, p, p, p});
    for (const Tension sample : signal) {
      for (std::size_t tendon = 0; tendon < 4; ++tendon) {
        if (estimator.push(tendon, sample)) {
          estimator.settle();
        }
      }
    }
    for (std::size_t tendon = 0; tendon < 4; ++tendon) {
      const Reading reading = estimator.reading(tendon);
      EXPECT_FALSE(reading.flags.has(Flag::overrun)) << depth;
      expect_same(reading, at_once(p, signal));
    }
  }
}

struct Recorder {
  std::vector<double>* ranges_N;
  void full(Tension from, Tension to, CycleDamage) const {
    ranges_N->push_back(
        std::fabs(lifemodel_test::to_newtons(from) - lifemodel_test::to_newtons(to)));
  }
  void half(Tension, Tension, CycleDamage) const {}
};

TEST(Estimator, ObserversHearOfEveryCycle) {
  Estimator<1> estimator({parameters_of(paper_constants())});
  std::vector<double> ranges_N;
  for (const double t : {0.0, 10.0, 1.0, 9.0, 2.0, 8.0, 3.0, 12.0, 0.0, 1.0}) {
    estimator.push(0, newtons(t));
    while (estimator.settle([&](std::size_t) { return Recorder{&ranges_N}; })) {
    }
  }
  estimator.flush(0, Recorder{&ranges_N});
  EXPECT_EQ(ranges_N, (std::vector<double>{5, 7, 9}));
  EXPECT_EQ(estimator.reading(0).closed_cycles.raw(), 3u);
}

}  // namespace
}  // namespace lifemodel
