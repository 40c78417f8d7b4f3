#include <utility>

#include "host_sim/campaign/assemble.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/is_there.hpp"
#include "host_sim/io/byte_source.hpp"
#include "host_sim/io/text_file.hpp"

namespace host_sim {
namespace {

namespace fs = std::filesystem;

CampaignFile read_campaign_file(const fs::path& path) {
  return parse_campaign_file(
      read_text_file(path, "a campaign folder with campaign.toml (TOML) of at most 1 MiB"),
      path.string());
}

std::vector<SpecimenRow> read_specimens(const fs::path& folder) {
  const fs::path path = folder / "specimens.csv";
  if (!is_there(path) && is_there(folder / "sessions.csv")) {
    return {};
  }
  return parse_specimens(
      open_source(path, "a campaign folder with specimens.csv, sessions.csv or both"),
      path.string());
}

std::vector<BlockRow> read_blocks(const fs::path& path) {
  if (!is_there(path)) {
    return {};
  }
  return parse_blocks(open_source(path, "blocks.csv that can be read, or none"), path.string());
}

}  // namespace

Campaign read_campaign(const fs::path& folder) {
  CampaignFile file = read_campaign_file(folder / "campaign.toml");
  std::vector<SpecimenRow> specimens = read_specimens(folder);
  const std::vector<BlockRow> blocks = read_blocks(folder / "blocks.csv");
  Campaign campaign = assemble(std::move(file), std::move(specimens), blocks);
  campaign.folder = folder;
  return campaign;
}

}  // namespace host_sim
