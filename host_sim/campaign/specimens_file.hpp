#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/given_load.hpp"
#include "host_sim/campaign/place.hpp"
#include "host_sim/io/byte_source.hpp"

namespace host_sim {

/// A row of specimens.csv.
struct SpecimenRow {
  Campaign::Specimen specimen;  ///< without blocks
  double cycles = 0;
  GivenLoad load;
  Place name_place, cycles_place;
};

/// Reads and checks specimens.csv; `name` stands for the file in errors.
/// @throws InputError, for the second row of a specimen too
std::vector<SpecimenRow> parse_specimens(std::unique_ptr<ByteSource> source, std::string_view name);

}  // namespace host_sim
