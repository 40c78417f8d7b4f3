#include "host_sim/verbs/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

namespace host_sim {

std::optional<OutputFile> open_if_asked(const std::string& path) {
  return path.empty() ? std::nullopt : std::optional<OutputFile>(std::in_place, path);
}

std::string conflict_of(std::span<const std::string> paths) {
  std::vector<std::string> places;
  for (const std::string& path : paths) {
    if (!path.empty()) {
      places.push_back(path == "-" ? path : std::filesystem::weakly_canonical(path).string());
    }
  }
  std::sort(places.begin(), places.end());
  const auto twice = std::adjacent_find(places.begin(), places.end());
  return twice == places.end() ? "" : "two outputs go to '" + *twice + "'";
}

void commit_all(std::initializer_list<std::optional<OutputFile>*> files) {
  for (auto* file : files) {
    if (*file) {
      (*file)->commit();
    }
  }
}

std::ostream& summary_stream(std::span<const std::string> paths) {
  return std::find(paths.begin(), paths.end(), "-") != paths.end() ? std::cerr : std::cout;
}

}  // namespace host_sim
