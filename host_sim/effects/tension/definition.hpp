#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "host_sim/effects/tension_effect.hpp"

namespace host_sim::effects {

/// A covariate that a signature reads.
struct Need {
  std::vector<double> recording::Covariates::*values;
  std::string_view words;  ///< what it is and the channel that gives it
};

using Columns = std::vector<std::vector<double>>;

/// All that the file of an effect says, as data. The texts and tables must outlive the program.
struct TensionDefinition {
  std::string_view id;
  std::string_view term;
  std::string_view equation;
  std::string_view life_consequence;
  std::span<const Parameter> parameters;
  std::span<const Separation> separations;
  std::span<const Need> needs = {};
  bool acts_on_current = false;  ///< changes T_in only where it comes from the current
  bool per_pose = false;
  bool at_reversals = false;
  bool shifts_sessions = false;
  std::vector<std::vector<double>> shapes = {{}};
  bool whole_shapes = false;  ///< nothing lies between them
  Columns (*columns)(const recording::Covariates& covariates, const Baseline& baseline,
                     std::span<const double> shape) = nullptr;
};

std::unique_ptr<TensionEffect> effect_of(TensionDefinition definition);

/// One column: `value(i)` of each sample.
template <typename Value>
std::vector<double> column_of(const recording::Covariates& covariates, Value&& value) {
  std::vector<double> column(covariates.samples());
  for (std::size_t i = 0; i < column.size(); ++i) {
    column[i] = value(i);
  }
  return column;
}

/// phi s of a sample, what friction terms multiply.
inline double angle_and_direction(const recording::Covariates& covariates, std::size_t i) {
  return covariates.bend_angle_rad[i] * covariates.direction[i];
}

}  // namespace host_sim::effects
