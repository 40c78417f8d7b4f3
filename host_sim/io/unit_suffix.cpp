#include "host_sim/io/unit_suffix.hpp"

#include <algorithm>

namespace host_sim {
namespace {

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::optional<std::string_view> other_unit(std::string_view name, std::string_view known,
                                           std::string_view unit) {
  std::string_view stem = known;
  if (!unit.empty()) {
    stem.remove_suffix(unit.size() + 1);
  }
  if (name == known || !name.starts_with(stem)) {
    return std::nullopt;
  }
  name.remove_prefix(stem.size());
  if (name.empty()) {
    return name;
  }
  if (name.front() != '_' || !std::all_of(name.begin(), name.end(), is_name_character)) {
    return std::nullopt;
  }
  return name.substr(1);
}

}  // namespace host_sim
