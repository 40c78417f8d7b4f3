#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

/// What tests look for in the text of a page.
namespace host_sim::page_text {

/// The data that the page draws from.
[[nodiscard]] nlohmann::json data_in(const std::string& page);

[[nodiscard]] std::size_t count_of(const std::string& page, const std::string& text);

/// The page without comments of HTML, CSS and JavaScript.
[[nodiscard]] std::string without_comments(std::string page);

/// A way to reach another file or the network that is in the page; empty without one.
[[nodiscard]] std::string reference_out_of(const std::string& page);

/// What is wrong with the places and data of a page of this many plots; empty where each plot has
/// both, once.
[[nodiscard]] std::string misplaced_plot(const std::string& page, std::size_t plots);

}  // namespace host_sim::page_text
