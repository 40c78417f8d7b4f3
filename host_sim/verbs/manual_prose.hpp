#pragma once

#include "host_sim/command_line/manual_page.hpp"

namespace host_sim {

/// What the manual page of host_sim says beyond its options. @param documents the folder of the
/// installed documentation
command_line::ManualProse manual_prose(const std::string& documents);

}  // namespace host_sim
