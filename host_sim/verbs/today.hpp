#pragma once

#include <string>

#include "host_sim/fleet/horizon.hpp"

namespace host_sim {

/// What --today says, YYYY-MM-DD; the clock's day where it says nothing. @throws
/// CLI::ValidationError
fleet::Date today_of(const std::string& text);

}  // namespace host_sim
