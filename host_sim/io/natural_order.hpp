#pragma once

#include <compare>
#include <filesystem>
#include <string_view>

namespace host_sim {

/// Compares names as people count: digits by their value, so that `r2` comes before `r10`, all else
/// by its bytes, in any locale. Names that differ only in leading zeros are in the order of their
/// bytes, so that no two names are equal.
std::strong_ordering compare_naturally(std::string_view a, std::string_view b);

/// The same for paths, name by name.
bool naturally_before(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace host_sim
