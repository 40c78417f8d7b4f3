#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/report/page/chart.hpp"

/// Parts of a page as HTML with all texts escaped.
namespace host_sim::elements {

/// The warnings as a section of their own; empty without any.
[[nodiscard]] std::string warnings(const std::vector<std::string>& warnings);

/// Sentences as a list.
[[nodiscard]] std::string words(const std::vector<std::string>& sentences);

/// What to see in a chart, and its place; or why there is nothing to see.
[[nodiscard]] std::string chart(const Chart& chart, std::string_view caption,
                                std::string_view why_empty);

/// The table where there are rows for it, else why there are none.
[[nodiscard]] std::string table_or(bool has_rows, const std::string& table,
                                   std::string_view why_empty);

}  // namespace host_sim::elements
