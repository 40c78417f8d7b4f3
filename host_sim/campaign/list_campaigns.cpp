#include "host_sim/campaign/list_campaigns.hpp"

#include <algorithm>
#include <system_error>

#include "host_sim/io/input_error.hpp"

namespace host_sim {

namespace fs = std::filesystem;

bool is_campaign(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "campaign.toml", error);
}

std::vector<fs::path> list_campaigns(const fs::path& folder) {
  std::vector<fs::path> campaigns;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  while (!error && entry != fs::directory_iterator()) {
    if (is_campaign(entry->path())) {
      campaigns.push_back(entry->path());
    }
    entry.increment(error);
  }
  if (error) {
    throw InputError(folder.string(), 0, 0, "cannot be listed: " + error.message(),
                     "a folder of campaigns");
  }
  std::sort(campaigns.begin(), campaigns.end());
  return campaigns;
}

}  // namespace host_sim
