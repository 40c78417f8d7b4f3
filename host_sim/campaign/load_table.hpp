#pragma once

#include <array>

#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/campaign/given_load.hpp"

namespace host_sim {

/// The columns of a load, for a table whose first columns are these.
std::array<CsvColumn, kLoadColumnCount> load_columns();

/// Throws InputError where the file has some columns of a kind of load but not all.
void check_load_columns(const CsvTable& table);

/// The load of this row: empty cells give nothing.
/// @throws InputError for what is not a number in its range
GivenLoad load_in_row(const CsvTable& table);

}  // namespace host_sim
