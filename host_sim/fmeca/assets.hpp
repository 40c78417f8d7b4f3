#pragma once

#include <string_view>

/// The table of the paper, embedded when the program is built.
namespace host_sim::fmeca_assets {

// NOLINTNEXTLINE(readability-identifier-naming): named after the file
extern const std::string_view paper_toml;

}  // namespace host_sim::fmeca_assets
