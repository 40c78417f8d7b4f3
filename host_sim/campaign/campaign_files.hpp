#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_file.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/campaign/load.hpp"

namespace host_sim {

/// What campaign.toml holds.
struct CampaignFile {
  std::string name;
  bool two_sided = false;
  NominalModel nominal;
  FilePosition model;  ///< of [model]; the file where there is none
  std::vector<Campaign::Use> uses;
};

/// Reads and checks campaign.toml; `file` stands for it in errors.
/// @throws InputError
CampaignFile parse_campaign_file(std::string_view text, std::string_view file);

/// A row of specimens.csv.
struct SpecimenRow {
  Campaign::Specimen specimen;  ///< without blocks
  double cycles = 0;            ///< 0 where it was trimmed
  GivenLoad load;
  FilePosition name_place, cycles_place, status_place;
};

/// Reads and checks specimens.csv; `name` stands for the file in errors.
/// @throws InputError, for the second row of a specimen too
std::vector<SpecimenRow> parse_specimens(std::unique_ptr<hal::files::ByteSource> source,
                                         std::string_view name);

/// A row of blocks.csv.
struct BlockRow {
  std::string specimen;
  std::uint64_t order = 0;  ///< from 1
  double cycles = 0;
  GivenLoad load;
  FilePosition specimen_place, order_place;
};

/// Reads and checks blocks.csv; `name` stands for the file in errors.
/// @throws InputError
std::vector<BlockRow> parse_blocks(std::unique_ptr<hal::files::ByteSource> source,
                                   std::string_view name);

/// Gives specimens whose life was dropped as one of the lowest or highest of their level the cycles
/// that are known of it: those of the lowest or highest life that was kept.
/// @pre each specimen has its blocks
/// @throws InputError where the level has no life that was kept, or where others of it leave open
///   which lives were the lowest or highest: found broken between inspections; suspended, for the
///   highest; suspended before the lowest life that was kept, for the lowest
void place_trimmed(std::span<SpecimenRow> rows);

/// A campaign of the contents of its files, with specimens in order of their names; no `blocks`
/// where there is no such file.
/// @throws InputError where the files do not agree, or where the model lacks what a load needs
Campaign assemble(CampaignFile file, std::vector<SpecimenRow> specimens,
                  const std::vector<BlockRow>& blocks);

}  // namespace host_sim
