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
  std::vector<SizedEffect> effects;  ///< none, one, or two different ones
};

/// None 20 %, one 45 %, two 15 %, outside 20 %, in one pose 15 % of each; each effect of the
/// catalogue as often as any other.
Choice choose(std::uint64_t seed);

/// The share of `kind` among campaigns.
double share_of(CampaignKind kind);

/// Draws which of four kinds it is.
CampaignKind draw_kind(Dice& dice);

}  // namespace blind
