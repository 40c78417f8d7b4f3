#pragma once

#include "hal/files/column_map.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace host_sim {

/// Adds `--column`, whose maps column_map() reads.
CLI::Option* add_column(CLI::App& verb, std::vector<hal::files::ColumnMap>& maps);

/// Adds `--map`, the same with the channel first, for a verb that has `--column` already.
CLI::Option* add_map(CLI::App& verb, std::vector<hal::files::ColumnMap>& maps);

/// Adds `--column` and `--ignore-extra` to a verb that reads profiles or recordings line by line,
/// where each column makes one channel and none is differentiated.
void add_columns(CLI::App& verb, hal::files::ColumnOptions& columns);

}  // namespace host_sim
