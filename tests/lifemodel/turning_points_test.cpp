#include "lifemodel/counting/turning_points.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::newtons;
using lifemodel_test::to_newtons;

std::vector<double> filter(const std::vector<double>& signal_N, double hysteresis_N) {
  TurningPoints filter;
  std::vector<double> found_N;
  const auto hysteresis = TensionRange::from_raw(
      hysteresis_N > 0 ? distance(newtons(hysteresis_N), newtons(0)).raw() - 1 : 1);
  for (const double sample_N : signal_N) {
    filter.push(newtons(sample_N), hysteresis,
                [&](Tension t) { found_N.push_back(to_newtons(t)); });
  }
  if (filter.directed()) {
    found_N.push_back(to_newtons(filter.run().candidate()));
  }
  return found_N;
}

using Points = std::vector<double>;

TEST(TurningPoints, EveryReversalWithoutHysteresis) {
  EXPECT_EQ(filter({-2, 1, -3, 5, -1, 3, -4, 4, -2}, 0), (Points{-2, 1, -3, 5, -1, 3, -4, 4, -2}));
  EXPECT_EQ(filter({1, 2, 3, 3, 3, 2, 2, 1, 4}, 0), (Points{1, 3, 1, 4}));
}

TEST(TurningPoints, RangesBelowTheHysteresisAreLeftOut) {
  EXPECT_EQ(filter({0, 10, 9, 11, 2, 2.5, 1, 8}, 2), (Points{0, 11, 1, 8}));
}

TEST(TurningPoints, ARangeOfJustTheHysteresisCounts) {
  EXPECT_EQ(filter({0, 4, 2, 6}, 2), (Points{0, 4, 2, 6}));
  EXPECT_EQ(filter({0, 4, 2.5, 6}, 2), (Points{0, 6}));
}

TEST(TurningPoints, TheFirstExtremumStartsTheCount) {
  EXPECT_EQ(filter({5, 5.1, 3}, 0.5), (Points{5.1, 3}));
  EXPECT_EQ(filter({5, 4.9, 5.2, 4.8, 9}, 1), (Points{4.8, 9}));
  EXPECT_EQ(filter({5, 5.3, 4.8, 5.2, 4.7, 4.0}, 1), (Points{5.3, 4.0}));
}

TEST(TurningPoints, NothingTurnsInASteadySignal) {
  EXPECT_TRUE(filter({}, 0).empty());
  EXPECT_TRUE(filter({7}, 0).empty());
  EXPECT_TRUE(filter({7, 7, 7}, 0).empty());
  EXPECT_TRUE(filter({7, 7.1, 6.9, 7.05}, 0.5).empty());
}

TEST(TurningPoints, TheEndsOfTheRangeAreOrdinaryValues) {
  TurningPoints filter;
  std::vector<Tension> found;
  const auto note = [&](Tension t) { found.push_back(t); };
  for (const Tension t : {Tension::lowest(), Tension::highest(), Tension::lowest()}) {
    filter.push(t, TensionRange::from_raw(1), note);
  }
  EXPECT_EQ(found, (std::vector<Tension>{Tension::lowest(), Tension::highest()}));
  EXPECT_EQ(filter.run().candidate(), Tension::lowest());
}

}  // namespace
}  // namespace lifemodel
