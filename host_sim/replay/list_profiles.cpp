#include "host_sim/replay/list_profiles.hpp"

#include <set>
#include <system_error>

#include "host_sim/io/input_error.hpp"
#include "host_sim/replay/profile_folder.hpp"

namespace host_sim {
namespace {

namespace fs = std::filesystem;

/// @param shown the folder in names; empty where they are relative to it
ListedProfile listed(const fs::path& folder, const fs::path& profile, const fs::path& shown) {
  ListedProfile result{folder / profile, (shown / profile).string(), {}, {}};
  if (const fs::path model = nearest_model(folder, profile); !model.empty()) {
    result.model = folder / model;
    result.model_name = (shown / model).string();
  }
  return result;
}

void append_folder(std::vector<ListedProfile>& profiles, const fs::path& folder, bool alone) {
  const std::vector<fs::path> found = find_profiles(folder);
  if (found.empty()) {
    throw InputError(folder.string(), 0, 0, "no profile in it",
                     "a folder with files *.csv in it or in folders below, none of them hidden");
  }
  for (const fs::path& profile : found) {
    profiles.push_back(listed(folder, profile, alone ? fs::path() : folder));
  }
}

void refuse_twice(const std::vector<ListedProfile>& profiles) {
  std::set<fs::path> places;
  for (const ListedProfile& profile : profiles) {
    if (!places.insert(fs::absolute(profile.path).lexically_normal()).second) {
      throw InputError(profile.path.string(), 0, 0, "the profile is named twice",
                       "each profile once");
    }
  }
}

}  // namespace

std::vector<ListedProfile> list_profiles(std::span<const std::string> arguments) {
  std::vector<ListedProfile> profiles;
  for (const fs::path argument : arguments) {
    std::error_code ignored;
    if (fs::is_directory(argument, ignored)) {
      append_folder(profiles, argument, arguments.size() == 1);
    } else {
      const fs::path folder = argument.parent_path();
      profiles.push_back(listed(folder, argument.filename(), folder));
    }
  }
  refuse_twice(profiles);
  return profiles;
}

}  // namespace host_sim
