#pragma once

#include <filesystem>
#include <vector>

namespace host_sim {

/// The profiles in `folder` and below it: files `*.csv`, in natural order, relative to `folder`.
/// Hidden files and folders (`.name`) are left out; symbolic links are followed. What cannot be
/// read is in the list, be it a file or a folder, so that nobody misses it.
/// @throws InputError where `folder` itself cannot be listed
std::vector<std::filesystem::path> find_profiles(const std::filesystem::path& folder);

/// The `model.toml` in the folder of `profile` or nearest above it, relative to `folder` and not
/// above that; empty where there is none.
/// @param profile relative to `folder`
std::filesystem::path nearest_model(const std::filesystem::path& folder,
                                    const std::filesystem::path& profile);

}  // namespace host_sim
