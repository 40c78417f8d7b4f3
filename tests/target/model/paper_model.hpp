#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "tests/target/model/block.hpp"

namespace target {

/// The paper's model for each of `kTendons` tendons, out of its parameter block.
template <std::size_t kTendons>
std::array<lifemodel::Parameters, kTendons> paper_parameters() {
  static constexpr auto kDecoded = lifemodel::decode(kPaperBlock);
  static_assert(static_cast<bool>(kDecoded), "model/block.hpp has to be made anew");
  std::array<lifemodel::Parameters, kTendons> result{};
  result.fill(*kDecoded);
  return result;
}

/// The paper's model with every effect that is evaluated on line, each of a usual size.
inline lifemodel::ExtendedParameters extended_paper_model() {
  using lifemodel::extension::Effect;
  lifemodel::ExtendedParameters model{paper_parameters<1>()[0], {}};
  lifemodel::extension::Extension& e = model.extension;
  e.bend_angle = {2, {{{105414357, 6710886}, {316243071, -13421773}}}};  // 90, 270 deg: 0.1, -0.2
  e.current_offset = {838861};                                           // 0.05 A
  e.input_lag = {5 << 16};
  e.output_lag = {5 << 16};
  e.friction_load = {53687091, 1823548758, {1342177280, 31}};  // 0.2
  e.friction_position = {{{{26843546, 0}, {13421773, 6710886}, {0, 2684355}}}, 29281766};
  e.friction_preload = {6052660};                       // 2 N
  e.friction_temperature = {5368709, 20 << 16};         // 0.005 1/K
  e.friction_velocity = {19363525, 12102203, 4727423};  // 0.05, 0.5 s/m, 0.02 m/s
  e.friction_wear = {-3642681, 0, 268435456, 0};        // 0.3, 1
  e.gear_asymmetry = {5368709};                         // 0.02
  e.torque_gain = {1073742, 20 << 16};                  // 0.001 1/K
  e.torque_ripple = {838861, 335544, 6 << 16};          // 0.05 A, 0.02 A, 6
  e.mean_stress = {134217728, 161061274};               // share 0.5, w 0.6
  e.bending_fatigue = {1 << 28, 30263298};              // 5 N
  e.endurance_limit = {214748365, -367143347};          // share 0.8, 4 N
  e.presliding = {0, {1549082005, 33}, 1 << 28};        // 1 mm at 1 kHz
  e.viscous_force = {{1549480873, 28}};                 // 32 N s/m
  e.load_cell_zero = {3026330};                         // 1 N
  // The worst: as many knots as there may be, and a quotient.
  e.empirical.covariate = lifemodel::extension::Empirical::output_tension;
  e.empirical.knots = lifemodel::extension::Empirical::kKnots;
  for (std::int32_t i = 0; i < e.empirical.knots; ++i) {
    e.empirical.knot[static_cast<std::size_t>(i)] = {i << 25, 302633 * i, -302633 * i};
  }
  e.effects = (1u << lifemodel::extension::kEffects) - 1;
  return model;
}

}  // namespace target
