#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/text.hpp"
#include "hal/files/toml_table.hpp"
#include "host_sim/effects/tension/tension_effect.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// What the table [extension.<id>] of an effect holds: the parameters that the catalogue fits, in
/// its order, then what else its equation needs.
struct ExtensionKeys {
  std::string_view id;
  std::vector<effects::TableKey> keys;
};

/// Of all effects on tension and life that a model holds, and of the empirical correction, in order
/// of their ids. Effects on counting extend no model.
std::span<const ExtensionKeys> extension_keys();

/// The keys of one effect; null where there is none of that id.
const ExtensionKeys* extension_keys(std::string_view id);

/// The bend angles for which [extension.bend_angle] gives errors.
inline constexpr hal::files::NumberKey kBendAngles{"bend_angles_deg", "deg", {0, 1800}};

/// How many bend angles that may be.
inline constexpr std::size_t kMostBendAngles = 8;

/// What [extension.empirical], a correction and no cause, may be written over: one of these, with
/// its knots, beside the forces at them.
inline constexpr std::string_view kEmpirical = "empirical";
inline constexpr std::array<hal::files::NumberKey, 4> kEmpiricalCovariates{{
    {"output_tension_N", "N", {0, 1e6}},  ///< its size
    {"position_m", "m", {-1e3, 1e3}},
    {"speed_m_s", "m_s", {0, 100}},
    {"travel_m", "m", {0, 1e3}},  ///< since the motion turned
}};
inline constexpr std::array<hal::files::NumberKey, 2> kEmpiricalForces{{
    {"pulling_N", "N", {-1e6, 1e6}},
    {"letting_go_N", "N", {-1e6, 1e6}},
}};
inline constexpr std::size_t kMostKnots = 16;

/// Whether a table may hold the numbers: each within its bounds, and no more bend angles than that.
/// @pre the extension is of the catalogue on tension
bool is_within_bounds(const Extension& extension);

/// The tables [extension.<id>] in `extension`, in order of their ids; values in the order of
/// extension_keys(), and of bend_angle `bend_angles_deg` last.
/// @throws InputError for an effect or key that is unknown, a number that is missing, of the wrong
/// type or outside its bounds, and bend angles or knots that do not rise
std::vector<Extension> read_extensions(const hal::files::TomlTable& extension);

/// As read_model(), with the tables [extension.<id>].
/// @throws InputError for a force beyond the ultimate tension too
Model read_extended_model(const std::filesystem::path& path);

/// The same for a text in memory; `name` stands for the file in errors.
Model parse_extended_model(std::string_view text, std::string_view name);

/// The tables [extension.<id>] as they stand at the end of a model.toml. What read_extensions()
/// makes of them are the same numbers, to the last bit.
/// @pre all numbers are finite
std::string toml_text(std::span<const Extension> extensions);

}  // namespace host_sim
