#pragma once

#include <string_view>

namespace host_sim {

struct FlagText {
  std::string_view title;
  std::string_view meaning;
};

/// What a flag of the estimator (its name in lifemodel::Flag) means to the reader of the page.
[[nodiscard]] FlagText flag_text(std::string_view flag);

}  // namespace host_sim
