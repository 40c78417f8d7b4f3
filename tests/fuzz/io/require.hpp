#pragma once

#include <cstdlib>
#include <string_view>

namespace host_sim::fuzz {

/// Ends the process, which the fuzzer reports with its input, unless `holds`.
inline void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

/// An error is one line without control characters that says what is accepted.
inline void require_one_line(std::string_view message) {
  for (const char c : message) {
    require(static_cast<unsigned char>(c) >= 0x20 && c != '\x7f');
  }
  require(message.find("; accepted: ") != std::string_view::npos);
}

}  // namespace host_sim::fuzz
