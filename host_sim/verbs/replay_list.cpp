#include "host_sim/verbs/replay_list.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "hal/files/input_error.hpp"
#include "host_sim/extension/read.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/replay/results.hpp"

namespace host_sim {

using hal::files::InputError;

namespace {

namespace fs = std::filesystem;

/// Whether an earlier run wrote `path`.
bool is_table(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    return false;
  }
  const std::string head = replay_table_head();
  std::string front(head.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(front.data(), static_cast<std::streamsize>(front.size()));
  return front == head;
}

void leave_out_tables(std::vector<ListedProfile>& profiles, const std::string& place) {
  std::erase_if(profiles, [](const ListedProfile& profile) { return is_table(profile.path); });
  if (profiles.empty()) {
    throw InputError(place, 0, 0, "no profile but tables of earlier runs",
                     "files or a folder with profiles");
  }
}

/// Profiles, and models beside them.
void refuse_overwriting(const std::vector<ListedProfile>& profiles,
                        const ReplayArguments& arguments) {
  VerbFiles files = arguments.files();
  for (const ListedProfile& profile : profiles) {
    files.reads.push_back({"PROFILE", profile.path});
    files.reads.push_back({"PROFILE", profile.model});
  }
  check_files("replay", files);
}

/// One model for all of them, that everybody can use.
void take_given_model(std::vector<ListedProfile>& profiles, const std::string& path) {
  parameters_of(read_extended_model(path), path);
  for (ListedProfile& profile : profiles) {
    profile.model = path;
    profile.model_name = path;
  }
}

/// Says so once where `--model` was forgotten.
void require_some_model(const std::vector<ListedProfile>& profiles, const std::string& place) {
  const auto is_alone = [](const ListedProfile& profile) {
    std::error_code ignored;
    return profile.model.empty() && fs::exists(profile.path, ignored);
  };
  const auto has_model = [](const ListedProfile& profile) { return !profile.model.empty(); };
  if (std::any_of(profiles.begin(), profiles.end(), is_alone) &&
      std::none_of(profiles.begin(), profiles.end(), has_model)) {
    throw InputError(place, 0, 0, "no model goes with the profiles",
                     "--model FILE, or a model.toml in the folder of a profile or above it");
  }
}

}  // namespace

std::vector<ListedProfile> profiles_with_models(const ReplayArguments& arguments) {
  const std::string& place = arguments.profiles.front();
  std::vector<ListedProfile> profiles = list_profiles(arguments.profiles);
  leave_out_tables(profiles, place);
  refuse_overwriting(profiles, arguments);
  if (!arguments.model.empty()) {
    take_given_model(profiles, arguments.model);
  } else {
    require_some_model(profiles, place);
  }
  return profiles;
}

}  // namespace host_sim
