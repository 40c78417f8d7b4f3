#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "firmware/app/reporter.hpp"
#include "tests/lifemodel/support.hpp"
#include "wire.hpp"

namespace app {
namespace {

using protocol::detail::BreakRisk;
using protocol::detail::ConditionalLife;
using protocol::detail::RemainingLife;

/// A wire of the paper's shape that is whole at a damage, and what it takes every second: 2^-n
/// lives.
struct Load {
  double used = 0;
  int exponent = 0;
};

template <std::size_t kTendons>
class Pages {
 public:
  explicit Pages(const std::array<Load, kTendons>& loads, std::uint32_t seconds = 60) {
    book_.start({});
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      storage::LifeRecord record;
      record.epoch_damage = lifemodel_test::damage_of(loads[tendon].used);
      book_.resume(tendon, record, false, 1, paper_parameters().life);
    }
    for (std::uint32_t s = 1; s <= seconds; ++s) {
      for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
        lifemodel::Reading reading{};
        reading.total = lives(s, loads[tendon].exponent);
        book_.take(hal::seconds(s), tendon, reading);
      }
    }
  }

  template <class Page>
  Page page() {
    std::optional<Page> result;
    const bool left = reporter_.with_page(Page::kPage, [&](const auto& message) {
      if constexpr (std::is_same_v<std::decay_t<decltype(message)>, Page>) {
        result = message;
      }
      return true;
    });
    EXPECT_TRUE(left && result);
    return *result;
  }

 private:
  LifeBook<kTendons> book_;
  std::array<RainflowBins, kTendons> bins_{};
  NodeState state_;
  Reporter<kTendons> reporter_{book_, bins_, state_};
};

// B10 of the paper's shape is 0.684648, the 60 s take it there. 3600 * 2^-22 lives an hour:
// 0.0847407, 0.278179 and 0.474797 of conditional_test.cpp last 98.73, 324.10 and 553.18 h. Within
// 8 h the risk is 1 - exp(-0.1053605 ((1 + 8 * 8.583e-4 / 0.684648)^5.94 - 1)) = 0.6414 %,
// which is 25.7 steps of 0.025 %.
TEST(ConditionalLife, OfAWireAtItsB10) {
  Pages<1> pages({Load{0.684648495 - 60 * 0x1p-22, 22}});
  EXPECT_EQ(pages.page<ConditionalLife>(), (ConditionalLife{987, 3241, 5531}));
  EXPECT_EQ(pages.page<RemainingLife>().b10_dh, 0);
  const auto risk = pages.page<BreakRisk>();
  EXPECT_EQ(risk.within_horizon, 26);
  EXPECT_EQ(risk.horizon_h, 8);
}

TEST(ConditionalLife, IsUnknownBeforeAMinuteHasPassed) {
  Pages<1> pages({Load{0.5, 22}}, 59);
  EXPECT_EQ(pages.page<ConditionalLife>(), ConditionalLife{});
  EXPECT_EQ(pages.page<BreakRisk>().within_horizon, BreakRisk::kUnknownRisk);
  EXPECT_EQ(pages.page<BreakRisk>().horizon_h, 8);
}

// The tendon with the highest damage has 98.7 h left to 10 %. That at 0.3, of 16 times the load,
// has 0.385504 / 0.0137329 = 28.07 h, and 0.421 % risk within 8 h.
TEST(ConditionalLife, IsThatOfTheTendonWithTheLeastLeft) {
  for (const bool swapped : {false, true}) {
    const Load old{0.684648495, 22};
    const Load loaded{0.3 - 60 * 0x1p-18, 18};
    Pages<2> pages(swapped ? std::array{loaded, old} : std::array{old, loaded});
    EXPECT_EQ(pages.page<ConditionalLife>().to_10_dh, 280);
    EXPECT_EQ(pages.page<BreakRisk>().within_horizon, 17);
  }
}

TEST(ConditionalLife, OfAWireAtRestIsLongAndWithoutRisk) {
  Pages<1> pages({Load{0.9, 120}});
  EXPECT_EQ(pages.page<ConditionalLife>(), (ConditionalLife{0xfffe, 0xfffe, 0xfffe}));
  EXPECT_EQ(pages.page<BreakRisk>().within_horizon, 0);
}

TEST(ConditionalLife, OfAWornWireUnderLoadIsNoneAndSure) {
  Pages<1> pages({Load{3.0, 8}});
  EXPECT_EQ(pages.page<ConditionalLife>(), (ConditionalLife{0, 0, 0}));
  EXPECT_EQ(pages.page<BreakRisk>().within_horizon, 4000);
}

}  // namespace
}  // namespace app
