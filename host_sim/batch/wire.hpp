#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace host_sim::batch {

/// Texts of any bytes as one text, for ranks of the same machine type.
std::string packed(std::span<const std::string> texts);

/// What packed() has made into one.
std::vector<std::string> unpacked(std::string_view bytes);

}  // namespace host_sim::batch
