#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "hal/files/input_file.hpp"

namespace host_sim {

/// What `source` holds: where its first bytes are those of gzip or of zstd, the bytes that they
/// were made of, else its own. Memory is constant: that of the window, at most 128 MiB for zstd.
/// The size of what was compressed is not known beforehand. Reading throws InputError for a stream
/// that is damaged or cut off; `name` stands for the file in errors.
std::unique_ptr<hal::files::ByteSource> decompressed(std::unique_ptr<hal::files::ByteSource> source,
                                                     std::string_view name);

/// hal::files::open_source(), decompressed.
std::unique_ptr<hal::files::ByteSource> open_input(const std::filesystem::path& path,
                                                   std::string_view accepted);

}  // namespace host_sim
