#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "hal/files/text.hpp"
#include "host_sim/effects/effect.hpp"

namespace host_sim::effects {

/// A number that a table [extension.<id>] of a model may hold.
struct TableKey {
  hal::files::NumberKey number;
  /// What it is where the table leaves it out: kUnknown where that is nothing; none: it must be
  /// there.
  std::optional<double> otherwise = std::nullopt;
  bool per_pose = false;  ///< one number, or an array with one for each bend angle

  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
};

/// One effect of the catalogue on tension, with all that is known of it but its laws, which
/// force_model.hpp has.
struct TensionEffect {
  std::string_view id;    ///< "friction_wear"
  std::string_view term;  ///< the field's word for it
  std::string_view life_consequence;
  std::span<const TableKey> table;  ///< of a model; empty where no model holds it
  std::span<const Separation> separations;
};

/// All effects of the catalogue on tension, in order of their ids.
std::span<const TensionEffect* const> tension_effects();

/// Null where the catalogue has none of that id.
const TensionEffect* tension_effect(std::string_view id);

}  // namespace host_sim::effects
