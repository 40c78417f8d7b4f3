#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace host_sim {

/// Text that is safe in HTML content and in quoted attributes. Bytes that are not UTF-8 and control
/// characters other than tab and line feed become U+FFFD.
[[nodiscard]] std::string html_escape(std::string_view text);

/// One line of ASCII JSON that is safe inside a script element: no character can end the element or
/// start a comment. Non-finite numbers become null; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string script_json(const nlohmann::json& value);

}  // namespace host_sim
