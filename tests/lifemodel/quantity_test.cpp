#include <gtest/gtest.h>

#include <concepts>
#include <limits>

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {
namespace {

template <class A, class B>
concept CanCompare = requires(A a, B b) {
  a < b;
};
template <class A, class B>
concept CanSum = requires(A a, B b, Flags flags) {
  A::sum(a, b, flags);
};
template <class A, class B>
concept CanAssign = std::assignable_from<A&, B>;
template <class Q>
concept CanSaturate = requires(Flags flags) {
  Q::saturated(0, flags);
};

TEST(Quantity, MixedUnitsDoNotCompile) {
  static_assert(CanCompare<Tension, Tension> && CanSum<Tension, Tension>);
  static_assert(!CanCompare<Tension, MotorCurrent>);
  static_assert(!CanSum<Tension, MotorCurrent>);
  static_assert(!CanAssign<Tension, Angle>);
  static_assert(!CanAssign<Tension, TensionRange>);
  static_assert(!CanAssign<Tension, std::int32_t>);
  static_assert(!CanAssign<std::int32_t, Tension>);
  static_assert(!CanCompare<Cycles, HalfCycles>);
  static_assert(!CanAssign<Cycles, HalfCycles>);
}

TEST(Quantity, RefusingQuantitiesCannotSaturate) {
  static_assert(CanSaturate<Tension>);
  static_assert(!CanSaturate<IplExponent>);
  EXPECT_FALSE(IplExponent::checked((std::int64_t{1} << 27) - 1));  // just below 1
  EXPECT_TRUE(IplExponent::checked(std::int64_t{12} << 27));
  EXPECT_FALSE(IplExponent::checked((std::int64_t{12} << 27) + 1));
}

TEST(Quantity, SaturationIsStickyAndOnlyOutsideTheRange) {
  Flags flags;
  EXPECT_EQ(Tension::saturated(kInt32Max, flags), Tension::highest());
  EXPECT_EQ(Tension::saturated(-kInt32Max, flags), Tension::lowest());
  EXPECT_TRUE(flags.none());
  EXPECT_EQ(Tension::saturated(std::int64_t{kInt32Max} + 1, flags), Tension::highest());
  EXPECT_TRUE(flags.has(Flag::saturated));
  EXPECT_EQ(Tension::saturated(5, flags).raw(), 5);
  EXPECT_TRUE(flags.has(Flag::saturated));

  Flags sums;
  EXPECT_EQ(Tension::sum(Tension::highest(), Tension::from_raw(1), sums), Tension::highest());
  EXPECT_TRUE(sums.has(Flag::saturated));
  Flags differences;
  EXPECT_EQ(Tension::difference(Tension::lowest(), Tension::from_raw(1), differences),
            Tension::lowest());
  EXPECT_TRUE(differences.has(Flag::saturated));
}

TEST(Quantity, ThousandthsAreTheNearestStep) {
  Flags flags;
  EXPECT_EQ(MotorCurrent::from_milli(1000, flags).raw(), 1 << 24);
  EXPECT_EQ(MotorCurrent::from_milli(-1000, flags).raw(), -(1 << 24));
  EXPECT_EQ(MotorCurrent::from_milli(1, flags).raw(), 16777);            // 16777.216
  EXPECT_EQ(MotorCurrent::from_milli(123457, flags).raw(), 2071264756);  // 2071264755.7
  EXPECT_EQ(MotorCurrent::from_milli(-2500, flags).raw(), -41943040);
  EXPECT_TRUE(flags.none());
  EXPECT_EQ(MotorCurrent::from_milli(std::numeric_limits<std::int32_t>::max(), flags),
            MotorCurrent::highest());
  EXPECT_TRUE(flags.has(Flag::saturated));
  Flags low;
  EXPECT_EQ(MotorCurrent::from_milli(std::numeric_limits<std::int32_t>::min(), low),
            MotorCurrent::lowest());
  EXPECT_TRUE(low.has(Flag::saturated));
}

TEST(Quantity, DistanceIsExactAcrossTheWholeRange) {
  EXPECT_EQ(distance(Tension::lowest(), Tension::highest()).raw(), 4294967294u);
  EXPECT_EQ(distance(Tension::from_raw(7), Tension::from_raw(-5)).raw(), 12u);
  EXPECT_EQ(distance(Tension::from_raw(-5), Tension::from_raw(7)).raw(), 12u);
}

TEST(Count, StopsAtItsHighestValue) {
  Flags flags;
  auto events = Events::from_raw(std::numeric_limits<std::uint32_t>::max() - 1);
  events.add(1, flags);
  EXPECT_TRUE(flags.none());
  events.add(1, flags);
  EXPECT_EQ(events.raw(), std::numeric_limits<std::uint32_t>::max());
  EXPECT_TRUE(flags.has(Flag::saturated));
}

}  // namespace
}  // namespace lifemodel
