#include "hal/files/input_error.hpp"

#include <fmt/format.h>

#include "hal/files/text.hpp"

namespace hal::files {
namespace {

std::string message(std::string_view file, std::uint64_t line, std::uint64_t column,
                    std::string_view found, std::string_view accepted) {
  std::string place = printable(file);
  if (line != 0) {
    place += fmt::format(":{}", line);
    if (column != 0) {
      place += fmt::format(":{}", column);
    }
  }
  return fmt::format("{}: {}; accepted: {}", place, printable(found), printable(accepted));
}

}  // namespace

InputError::InputError(std::string_view file, std::uint64_t line, std::uint64_t column,
                       std::string_view found, std::string_view accepted)
    : std::runtime_error(message(file, line, column, found, accepted)),
      file_(printable(file)),
      line_(line),
      column_(column),
      found_(printable(found)),
      accepted_(printable(accepted)) {}

}  // namespace hal::files
