#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "tests/io/support.hpp"

namespace host_sim::test {

/// The contents of a campaign folder.
struct CampaignTexts {
  std::string campaign;
  std::string specimens;
  std::string blocks;  ///< empty where there is no such file
};

/// The wire and the sheath of the paper.
inline constexpr std::string_view kPaperCampaign = R"([campaign]
name = "paper"
[model.cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[model.sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
)";

inline Campaign campaign_of(const CampaignTexts& texts) {
  CampaignFile file = parse_campaign_file(texts.campaign, "c.toml");
  std::vector<SpecimenRow> specimens =
      parse_specimens(hal::files::memory_source(texts.specimens), "s.csv");
  std::vector<BlockRow> blocks;
  if (!texts.blocks.empty()) {
    blocks = parse_blocks(hal::files::memory_source(texts.blocks), "b.csv");
  }
  return assemble(std::move(file), std::move(specimens), blocks);
}

inline std::string campaign_complaint(const CampaignTexts& texts) {
  return complaint_of([&] { campaign_of(texts); });
}

/// `text` with the first `from` replaced.
inline std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  const std::size_t at = result.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return result.replace(at, from.size(), to);
}

}  // namespace host_sim::test
