#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/campaign/given_load.hpp"
#include "host_sim/campaign/place.hpp"
#include "host_sim/io/byte_source.hpp"

namespace host_sim {

/// A row of blocks.csv.
struct BlockRow {
  std::string specimen;
  std::uint64_t order = 0;  ///< from 1
  double cycles = 0;
  GivenLoad load;
  Place specimen_place, order_place;
};

/// Reads and checks blocks.csv; `name` stands for the file in errors.
/// @throws InputError
std::vector<BlockRow> parse_blocks(std::unique_ptr<ByteSource> source, std::string_view name);

}  // namespace host_sim
