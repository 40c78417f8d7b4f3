#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace host_sim {

/// A whole small file; `-` is standard input. `accepted` says in errors what is accepted.
/// @throws InputError where it cannot be read or is larger than 1 MiB
std::string read_text_file(const std::filesystem::path& path, std::string_view accepted);

/// What stands for the file in errors.
std::string file_name(const std::filesystem::path& path);

}  // namespace host_sim
