#pragma once

#include <memory>
#include <string_view>

#include "host_sim/io/byte_source.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

/// The fewest samples of a recording.
inline constexpr std::size_t kFewestSamples = 16;

/// Reads and checks the samples of one recording; `name` stands for the file in errors.
/// @throws InputError
Channels parse_recording(std::unique_ptr<ByteSource> source, std::string_view name);

}  // namespace host_sim::recording
