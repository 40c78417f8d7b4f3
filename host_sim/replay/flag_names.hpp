#pragma once

#include <string>
#include <vector>

#include "lifemodel/quantity/flags.hpp"

namespace host_sim {

/// Names of all flags, as in reports and for `--fail-on`.
const std::vector<std::string>& all_flag_names();

/// Names of the flags that are raised, in a fixed order.
std::vector<std::string> flag_names(lifemodel::Flags flags);

}  // namespace host_sim
