#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "hal/files/toml_table.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// The tables [extension.<id>] in `extension`, in order of their ids; values in the order of
/// extension_keys(), and of bend_angle `bend_angles_deg` last.
/// @throws InputError for an effect or key that is unknown, a number that is missing, of the wrong
/// type or outside the bounds of the catalogue, and bend angles that do not rise
std::vector<Extension> read_extensions(const hal::files::TomlTable& extension);

/// As read_model(), with the tables [extension.<id>].
Model read_extended_model(const std::filesystem::path& path);

/// The same for a text in memory; `name` stands for the file in errors.
Model parse_extended_model(std::string_view text, std::string_view name);

}  // namespace host_sim
