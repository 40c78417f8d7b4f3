#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace board {

/// The whole of a file that is not larger than `most_bytes`. Throws host_sim::InputError;
/// `accepted` says in it what is accepted.
std::string read_small_file(const std::filesystem::path& path, std::size_t most_bytes,
                            std::string_view accepted);

}  // namespace board
