#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hal::files {

/// The one of `known` that is nearest to `word` by letters inserted, left out, exchanged or swapped
/// with their neighbour (optimal string alignment), or that it is the beginning of; none where as
/// much as a third of the letters differs. The first of several that are as near.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& known);

}  // namespace hal::files
