#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host_sim/io/input_error.hpp"

namespace host_sim {

/// A place in a file, counted from 1 in characters.
struct Place {
  std::string file;
  std::uint64_t line = 0;
  std::uint64_t column = 0;

  /// @throws InputError
  [[noreturn]] void fail(std::string_view found, std::string_view accepted) const {
    throw InputError(file, line, column, found, accepted);
  }
};

}  // namespace host_sim
