#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// Lines of a TOML file, one key or table each.
std::string table(std::string_view name);
std::string line(std::string_view key, double value);
std::string line(std::string_view key, const std::vector<double>& values);
std::string line(std::string_view key, std::string_view word);
std::string line(std::string_view key, const std::vector<std::string>& words);

/// [effects.<id>] or [outside.<id>].
std::string table_of(const HiddenEffect& effect);

}  // namespace blind
