#pragma once

#include <string_view>
#include <vector>

#include "tests/blind/generator/dice.hpp"
#include "tests/blind/generator/lives_design.hpp"
#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// Ids of the effects of the catalogue, and of departures that it does not have.
std::vector<std::string_view> life_effects();
std::vector<std::string_view> outside_life_effects();

/// An effect of a size within its physical range.
/// @param lowest, highest the least and the most loaded level
HiddenEffect draw_life_effect(std::string_view id, const TrueLaw& law,
                              const LifeLevelDesign& lowest, const LifeLevelDesign& highest,
                              Dice& dice);

}  // namespace blind
