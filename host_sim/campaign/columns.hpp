#pragma once

#include <cstddef>
#include <string>

#include "host_sim/campaign/csv_table.hpp"

namespace host_sim {

/// A name of the kind that its column says: visible characters, at least one. @throws InputError
std::string name_in_row(const CsvTable& table, std::size_t column);

/// A number of cycles: above 0. @throws InputError
double cycles_in_row(const CsvTable& table, std::size_t column);

}  // namespace host_sim
