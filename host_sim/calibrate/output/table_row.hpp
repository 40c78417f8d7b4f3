#pragma once

#include <string>
#include <string_view>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

/// The header line of a table of campaigns (RFC 4180).
std::string table_head();

/// The line of one campaign; what was not computed is empty, an end that does not exist `inf`.
/// @param name of its folder
std::string table_row(std::string_view name, const CalibrateResult& result);

/// The line of a campaign that was refused.
std::string refused_row(std::string_view name, std::string_view error);

}  // namespace host_sim::calibrate
