#include "host_sim/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/text.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/campaign/load.hpp"
#include "host_sim/io/compressed.hpp"

namespace host_sim {

using hal::files::in_quotes;
using hal::files::InputError;
using hal::files::read_text_file;

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
      open_input(path, "a campaign folder with specimens.csv, sessions.csv or both"),
      path.string());
}

std::vector<BlockRow> read_blocks(const fs::path& path) {
  if (!is_there(path)) {
    return {};
  }
  return parse_blocks(open_input(path, "blocks.csv that can be read, or none"), path.string());
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

namespace {

using Rows = std::vector<const BlockRow*>;
using RowsBySpecimen = std::unordered_map<std::string_view, Rows>;

constexpr double kCyclesTolerance = 1e-9;

RowsBySpecimen rows_by_specimen(const std::vector<SpecimenRow>& specimens,
                                const std::vector<BlockRow>& blocks) {
  RowsBySpecimen rows;
  for (const SpecimenRow& row : specimens) {
    rows.try_emplace(row.specimen.name);
  }
  for (const BlockRow& block : blocks) {
    const auto found = rows.find(block.specimen);
    if (found == rows.end()) {
      block.specimen_place.fail(
          fmt::format("a block of {}, which is no specimen", in_quotes(block.specimen)),
          "specimens of specimens.csv");
    }
    found->second.push_back(&block);
  }
  for (auto& [name, of_one] : rows) {
    std::stable_sort(of_one.begin(), of_one.end(),
                     [](const BlockRow* a, const BlockRow* b) { return a->order < b->order; });
  }
  return rows;
}

void check_order(const Rows& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BlockRow& row = *rows[i];
    if (row.order == i + 1) {
      continue;
    }
    const std::string specimen = in_quotes(row.specimen);
    row.order_place.fail(
        row.order <= i
            ? fmt::format("order {} of specimen {} a second time, first in line {}", row.order,
                          specimen, rows[i - 1]->order_place.line)
            : fmt::format("order {} of specimen {}, but no order {}", row.order, specimen, i + 1),
        "each order once: 1, 2, 3 and so on");
  }
}

void check_cycles(const SpecimenRow& row) {
  const double sum = row.specimen.cycles();
  if (!(std::abs(sum - row.cycles) <= kCyclesTolerance * row.cycles)) {
    row.cycles_place.fail(fmt::format("specimen {} has {} cycles, but its blocks sum to {}",
                                      in_quotes(row.specimen.name), row.cycles, sum),
                          "the sum of its blocks in blocks.csv");
  }
}

void take_blocks(SpecimenRow& row, const Rows& rows, const LoadModel& model) {
  if (row.load.kind() != LoadKind::none) {
    row.load.place().fail(fmt::format("a load of specimen {}, which has blocks from line {} on",
                                      in_quotes(row.specimen.name), rows.front()->order_place.line),
                          "the load here or in blocks.csv, not both");
  }
  if (row.specimen.trimmed() || row.specimen.found_broken()) {
    row.status_place.fail(
        fmt::format("specimen {}, which has blocks, was trimmed or found broken at an inspection",
                    in_quotes(row.specimen.name)),
        "failed or suspended for specimens in blocks");
  }
  check_order(rows);
  for (const BlockRow* const block : rows) {
    row.specimen.blocks.push_back(
        {model.load(block->load), block->cycles, block->order_place.line});
  }
  check_cycles(row);
}

void take_load(SpecimenRow& row, const LoadModel& model) {
  if (row.load.kind() == LoadKind::none) {
    row.name_place.fail(fmt::format("specimen {} has no load", in_quotes(row.specimen.name)),
                        fmt::format("{}, or rows in blocks.csv", row.load.accepted));
  }
  row.specimen.blocks.push_back({model.load(row.load), row.cycles, row.specimen.line});
}

}  // namespace

Campaign assemble(CampaignFile file, std::vector<SpecimenRow> specimens,
                  const std::vector<BlockRow>& blocks) {
  const LoadModel model(file.nominal, file.model);
  const RowsBySpecimen rows = rows_by_specimen(specimens, blocks);
  Campaign campaign;
  for (SpecimenRow& row : specimens) {
    const Rows& of_this = rows.at(row.specimen.name);
    if (of_this.empty()) {
      take_load(row, model);
    } else {
      take_blocks(row, of_this, model);
    }
  }
  place_trimmed(specimens);
  for (SpecimenRow& row : specimens) {
    campaign.specimens.push_back(std::move(row.specimen));
  }
  std::sort(campaign.specimens.begin(), campaign.specimens.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  campaign.name = std::move(file.name);
  campaign.two_sided = file.two_sided;
  campaign.nominal = file.nominal;
  campaign.uses = std::move(file.uses);
  return campaign;
}

double Campaign::Specimen::cycles() const {
  double sum = 0;
  for (const Block& block : blocks) {
    sum += block.cycles;
  }
  return sum;
}

namespace {

/// Bend angles are not negative: without one comes before all.
double bend_angle_deg(const Campaign::Load& load) {
  return load.bend_angle_deg ? *load.bend_angle_deg : -1.0;
}

auto rank(const Level& level) {
  return std::tuple(level.load.effective_tension_N, level.role, bend_angle_deg(level.load),
                    level.load.input_tension_mean_N, level.load.input_tension_amplitude_N);
}

}  // namespace

std::vector<Level> levels_of(const Campaign& campaign) {
  std::vector<Level> single;
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    if (specimen.constant_load()) {
      single.push_back({specimen.blocks.front().load, specimen.role, {&specimen}});
    }
  }
  std::stable_sort(single.begin(), single.end(),
                   [](const Level& a, const Level& b) { return rank(a) < rank(b); });
  std::vector<Level> levels;
  for (const Level& one : single) {
    if (levels.empty() || rank(levels.back()) != rank(one)) {
      levels.push_back(one);
    } else {
      levels.back().specimens.push_back(one.specimens.front());
    }
  }
  return levels;
}

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

bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::symlink_status(file, error).type() != fs::file_type::not_found;
}

}  // namespace host_sim
