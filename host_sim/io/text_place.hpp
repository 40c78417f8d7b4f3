#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host_sim/io/input_error.hpp"
#include "host_sim/io/printable.hpp"

namespace host_sim {

/// A line of a file, for errors that say where they are.
struct TextPlace {
  std::string_view file;
  std::uint64_t number;   ///< from 1
  std::string_view text;  ///< without the line end

  /// Throws InputError for the byte at `offset` of the line.
  [[noreturn]] void fail(std::size_t offset, std::string_view found,
                         std::string_view accepted) const {
    throw InputError(file, number, character_count(text.substr(0, offset)) + 1, found, accepted);
  }
};

}  // namespace host_sim
