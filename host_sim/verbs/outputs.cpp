#include "host_sim/verbs/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

namespace host_sim {
namespace {

// Of a relative path that does not exist, weakly_canonical alone makes no absolute one.
std::string canonical_place(const std::filesystem::path& path) {
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path)).string();
}

}  // namespace

std::optional<OutputFile> open_if_asked(const std::string& path) {
  return path.empty() ? std::nullopt : std::optional<OutputFile>(std::in_place, path);
}

std::string conflict_of(std::span<const std::string> paths) {
  std::vector<std::string> places;
  for (const std::string& path : paths) {
    if (!path.empty()) {
      places.push_back(path == "-" ? path : canonical_place(path));
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
