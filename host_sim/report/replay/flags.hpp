#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lifemodel/quantity/flags.hpp"

namespace host_sim {

/// Names of all flags, as in results and for `--fail-on`.
const std::vector<std::string>& all_flag_names();

/// Names of the flags that are raised, in a fixed order.
std::vector<std::string> flag_names(lifemodel::Flags flags);

struct FlagText {
  std::string_view title;
  std::string_view meaning;
};

/// What the flag of this name means to the reader of a page.
[[nodiscard]] FlagText flag_text(std::string_view name);

}  // namespace host_sim
