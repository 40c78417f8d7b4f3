#pragma once

#include <cstdint>
#include <string>

#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// The same for a campaign of lives: each specimen's logarithm of cycles against that of the same
/// specimen without the effect, less what scale and exponent of the law take up by least squares,
/// in standard deviations of one specimen, pi / (sqrt(6) beta). What suspension hides does not
/// count. Changes of scatter are told as those of these very specimens.
/// @param id of a hidden effect
double life_visibility(const Scenario& scenario, const std::string& id);

/// The first attempt at a campaign of lives whose hidden effects an oracle sees at three standard
/// deviations or more, which is what is called barely visible; after many the last, which the
/// tables count apart.
Scenario draw_visible_lives(std::uint64_t seed);

}  // namespace blind
