#include "host_sim/replay/list_profiles.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <system_error>

#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "host_sim/io/natural_order.hpp"

namespace host_sim {

using hal::files::InputError;
using hal::files::stop_if_interrupted;

namespace {

namespace fs = std::filesystem;

constexpr const char* kModel = "model.toml";

bool is_hidden(const fs::path& path) {
  return path.filename().native().starts_with('.');
}

bool has_name_of_profile(const fs::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.ends_with(".csv") || name.ends_with(".csv.gz") || name.ends_with(".csv.zst");
}

/// What may be a file: one that is there, or a link that leads nowhere. No pipes and devices.
bool may_be_file(const fs::directory_entry& entry) {
  std::error_code ignored;
  const fs::file_type type = entry.status(ignored).type();
  return type == fs::file_type::regular || type == fs::file_type::not_found;
}

class Search {
 public:
  explicit Search(const fs::path& folder) : folder_(folder) {}

  /// What is in the folder `place`, a path relative to the top. @return why it cannot be listed
  std::error_code look_into(const fs::path& place) {
    std::error_code error;
    const fs::path itself = fs::canonical(folder_ / place, error);
    // A link to a folder above would be followed without end.
    if (std::find(above_.begin(), above_.end(), itself) != above_.end()) {
      return {};
    }
    above_.push_back(itself);
    fs::directory_iterator entry(folder_ / place, error);
    while (!error && entry != fs::directory_iterator()) {
      take(*entry, place / entry->path().filename());
      entry.increment(error);
    }
    above_.pop_back();
    return error;
  }

  std::vector<fs::path> sorted() && {
    std::sort(found_.begin(), found_.end(), naturally_before);
    return std::move(found_);
  }

 private:
  void take(const fs::directory_entry& entry, const fs::path& place) {
    stop_if_interrupted();
    std::error_code ignored;
    if (is_hidden(place)) {
      return;
    }
    if (entry.is_directory(ignored)) {
      if (look_into(place)) {
        found_.push_back(place);
      }
    } else if (has_name_of_profile(place) && may_be_file(entry)) {
      found_.push_back(place);
    }
  }

  const fs::path& folder_;
  std::vector<fs::path> above_;
  std::vector<fs::path> found_;
};

/// The profiles in `folder` and below it: files `*.csv`, also compressed, in natural order,
/// relative to `folder`. Hidden files and folders (`.name`) are left out; symbolic links are
/// followed. What cannot be read is in the list, be it a file or a folder, so that nobody misses
/// it.
/// @throws InputError where `folder` itself cannot be listed
std::vector<fs::path> find_profiles(const fs::path& folder) {
  Search search(folder);
  if (const std::error_code error = search.look_into({})) {
    throw InputError(folder.string(), 0, 0, "cannot be listed: " + error.message(),
                     "a folder with profiles");
  }
  return std::move(search).sorted();
}

/// The `model.toml` in the folder of `profile` or nearest above it, relative to `folder` and not
/// above that; empty where there is none.
/// @param profile relative to `folder`
fs::path nearest_model(const fs::path& folder, const fs::path& profile) {
  std::error_code ignored;
  for (fs::path place = profile; place.has_relative_path();) {
    place = place.parent_path();
    // One that cannot be read is no reason to take that of another cable.
    if (fs::symlink_status(folder / place / kModel, ignored).type() != fs::file_type::not_found) {
      return place / kModel;
    }
  }
  return {};
}

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
