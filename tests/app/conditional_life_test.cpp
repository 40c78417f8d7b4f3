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
  explicit Pages(const std::array<Load, kTendons>& loads, std::uint32_t seconds = 60,
                 const Outlook& outlook = {}) {
    book_.start({});
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      storage::LifeRecord record;
      record.epoch_damage = lifemodel_test::damage_of(loads[tendon].used);
      book_.resume(tendon, record, false, 1, paper_parameters().life, outlook);
    }
    for (std::uint32_t s = 1; s <= seconds; ++s) {
      for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
        lifemodel::Reading reading{};
        reading.total = lives(s, loads[tendon].exponent);
        reading.closed_cycles = lifemodel::Cycles::from_raw(s);
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

// 24 h of 8.583e-4 are 0.0206: 1 - exp(-0.1053605 ((1 + 0.0300870)^5.94 - 1)) = 2.008 %.
TEST(BreakRisk, IsWithinTheHorizonOfTheModelInWholeHours) {
  const auto within = [](std::uint32_t horizon_s) {
    return Pages<1>({Load{0.684648495 - 60 * 0x1p-22, 22}}, 60,
                    {.horizon_s = horizon_s, .fit = {}, .wanted = {}})
        .page<BreakRisk>();
  };
  EXPECT_EQ(within(24 * 3600).horizon_h, 24);
  EXPECT_EQ(within(24 * 3600).within_horizon, 81);
  EXPECT_EQ(within(23 * 3600 + 1).horizon_h, 24);
  EXPECT_EQ(within(4).horizon_h, 1);
  EXPECT_EQ(within(87600u * 3600).horizon_h, 255);
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
  Pages<1> pages({Load{0.9, 104}});  // the least damage in a second
  EXPECT_EQ(pages.page<ConditionalLife>(), (ConditionalLife{0xfffe, 0xfffe, 0xfffe}));
  EXPECT_EQ(pages.page<BreakRisk>().within_horizon, 0);
}

TEST(ConditionalLife, OfAWornWireUnderLoadIsNoneAndSure) {
  Pages<1> pages({Load{3.0, 8}});
  EXPECT_EQ(pages.page<ConditionalLife>(), (ConditionalLife{0, 0, 0}));
  EXPECT_EQ(pages.page<BreakRisk>().within_horizon, 4000);
}

lifemodel::LifeUncertainty fit_of(double log2_life, double exponent, double log2_shape) {
  return {.log2_life = static_cast<std::uint32_t>(log2_life * 0x1p21),
          .exponent = static_cast<std::uint32_t>(exponent * 0x1p27),
          .log2_shape = static_cast<std::uint32_t>(log2_shape * 0x1p21),
          .log2_damage_at_pivot = -22 << 21};
}

// After 600 s the damage is 0.684648, B10 of the paper's shape, and 98.73 h are left to 10 % at
// 3600 * 2^-22 an hour. With 2^-0.25 of the life 0.814189 is used, (0.814189^5.94 +
// 0.1053605)^(1/5.94) - 0.814189 = 0.0429642 left, of a life that is as much shorter: 42.09 h. With
// 2^0.25 of it 0.575718 is used and 0.1450585 left: 200.98 h.
TEST(BreakRisk, HasTheIntervalOfTheFitOnceTheLoadIsKnown) {
  const Outlook outlook{.horizon_s = 1, .fit = fit_of(0.25, 0, 0), .wanted = {}};
  const Load load{0.684648495 - 600 * 0x1p-22, 22};
  const auto page = Pages<1>({load}, 600, outlook).page<BreakRisk>();
  EXPECT_EQ(page.to_10_low_30min, 84);
  EXPECT_EQ(page.to_10_high_30min, 402);
  EXPECT_EQ(Pages<1>({load}, 599, outlook).page<BreakRisk>().to_10_low_30min, 0x3fff);
  EXPECT_EQ(Pages<1>({load}, 600).page<BreakRisk>().to_10_high_30min, 0x3fff);
}

}  // namespace
}  // namespace app
