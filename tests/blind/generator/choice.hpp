#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/generator/sized_effect.hpp"

namespace blind {

/// What is hidden in recordings, before its size is known.
struct Choice {
  CampaignKind kind = CampaignKind::none;
  Design design = Design::crossed;
  Input input = Input::load_cell;
  bool temperatures = false;
  std::vector<SizedEffect> effects;  ///< different from each other
};

/// None 20 %, one 45 %, two 10 %, three 5 %, outside 20 %, in one pose 15 % of each; each effect of
/// the catalogue as often as any other.
Choice choose(std::uint64_t seed);

/// The same of a drive that works in both directions.
Choice choose_two_sided(std::uint64_t seed);

/// Draws which kind it is: none 20 %, one 45 %, two 15 %, outside 20 %.
CampaignKind draw_kind(Dice& dice);

}  // namespace blind
