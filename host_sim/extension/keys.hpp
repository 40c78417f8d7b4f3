#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hal/files/text.hpp"

namespace host_sim {

/// A number that a table [extension.<id>] may hold.
struct ExtensionKey {
  hal::files::NumberKey number;
  std::optional<double>
      otherwise;          ///< what it is where the table leaves it out; else it must be there
  bool per_pose = false;  ///< one number, or an array with one for each bend angle
};

/// What the table [extension.<id>] of an effect holds: the parameters that the catalogue fits, in
/// its order, then what else its equation needs.
struct ExtensionKeys {
  std::string_view id;
  std::vector<ExtensionKey> keys;
};

/// Of all effects on tension and life, in order of their ids. Effects on counting extend no model.
std::span<const ExtensionKeys> extension_keys();

/// The keys of one effect; null where there is none of that id.
const ExtensionKeys* extension_keys(std::string_view id);

/// The bend angles for which [extension.bend_angle] gives errors.
inline constexpr hal::files::NumberKey kBendAngles{"bend_angles_deg", "deg", {0, 1800}};

/// How many bend angles that may be.
inline constexpr std::size_t kMostBendAngles = 8;

}  // namespace host_sim
