#include <gtest/gtest.h>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::HostLayout;
using lifemodel_test::newtons;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using lifemodel_test::Signal;
using pack::to_double;

TEST(Endurance, ABillionCyclesAddUpExactly) {
  auto constants = paper_constants();
  constants.ipl_exponent = 12;
  constants.ipl_scale = 1e26;
  const Parameters p = parameters_of(constants);
  // 1e9 cycles at 0.02 of the ultimate tension, and one at 0.5 of it.
  const double small_N = 0.02 * 177.4;
  Signal chunk;
  for (int i = 0; i < 50'000; ++i) {
    chunk.push_back(newtons(-small_N));
    chunk.push_back(newtons(small_N));
  }
  Estimator<1, HostLayout> estimator({p});
  for (int i = 0; i < 20'000; ++i) {
    estimator.replay(0, chunk);
  }
  estimator.push(0, newtons(-small_N));
  const Reading r = estimator.reading(0);
  EXPECT_EQ(r.closed_cycles.raw(), 999'999'999u);
  EXPECT_EQ(r.open_half_cycles.raw(), 2u);
  const auto exact =
      static_cast<double>(1e9L * lifemodel_test::cycle_damage(constants, -small_N, small_N));
  EXPECT_NEAR(to_double(r.total) / exact, 1, 1e-4);
  EXPECT_EQ(r.flags.bits(), static_cast<std::uint32_t>(Flag::negative_tension));

  estimator.push(0, newtons(88.7));
  estimator.push(0, newtons(-88.7));
  const double large = to_double(estimator.reading(0).total) - exact;
  const auto exact_large =
      static_cast<double>(lifemodel_test::cycle_damage(constants, -88.7, 88.7) / 2 +
                          lifemodel_test::cycle_damage(constants, -small_N, 88.7) / 2);
  EXPECT_NEAR(large / exact_large, 1, 1e-4);
}

}  // namespace
}  // namespace lifemodel
