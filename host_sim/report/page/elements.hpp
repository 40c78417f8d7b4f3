#pragma once

#include <string>
#include <string_view>

/// Small pieces of a page as HTML; their texts are escaped here.
namespace host_sim::elements {

/// A key number with its name and a note, for a list of class tiles.
[[nodiscard]] std::string tile(std::string_view name, std::string_view value,
                               std::string_view note);

/// In the place of a plot that has nothing to show: why.
[[nodiscard]] std::string empty(std::string_view reason);

/// The place of a chart that the script of this id draws; `name` and `summary` are what a screen
/// reader says.
[[nodiscard]] std::string chart_place(std::string_view id, std::string_view name,
                                      std::string_view summary);

}  // namespace host_sim::elements
