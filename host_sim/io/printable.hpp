#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace host_sim {

/// `text` as one line that is safe on a terminal: control characters, line separators, characters
/// that change the writing direction or are invisible, and bytes that are not UTF-8 become `\xNN`
/// (`\n`, `\r`, `\t` by name). At most `limit` characters of the input are kept; `...` marks a cut.
std::string printable(std::string_view text, std::size_t limit = std::string_view::npos);

/// `'text'`, printable and at most 40 characters long: for quoting a value in a message.
std::string in_quotes(std::string_view text);

/// Number of UTF-8 characters in `text`; a byte that does not continue a character counts as one.
std::size_t character_count(std::string_view text);

}  // namespace host_sim
