#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace host_sim {

/// A profile among several, and the model beside it.
struct ListedProfile {
  std::filesystem::path path;
  std::string name;             ///< in tables
  std::filesystem::path model;  ///< in its folder or nearest above; empty where there is none
  std::string model_name;       ///< in tables
};

/// The profiles that `arguments` name: files as they are given, folders with all profiles in them
/// and below, each with the `model.toml` nearest above it in that folder. The names are relative to
/// the folder where it is the only argument.
/// @throws InputError for a folder that cannot be listed or holds no profile, and for a profile
/// that is named twice
std::vector<ListedProfile> list_profiles(std::span<const std::string> arguments);

}  // namespace host_sim
