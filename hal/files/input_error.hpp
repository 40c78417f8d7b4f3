#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "hal/files/text.hpp"

namespace hal::files {

/// Input that cannot be trusted. what() is one line without control characters:
/// `file:line:column: what was found; accepted: what is accepted`.
class InputError : public std::runtime_error {
 public:
  /// `line` and `column` count from 1 in characters; 0 stands for none and is left out of the line.
  /// All texts may hold any bytes: they are made printable here.
  InputError(std::string_view file, std::uint64_t line, std::uint64_t column,
             std::string_view found, std::string_view accepted);

  const std::string& file() const noexcept { return file_; }
  std::uint64_t line() const noexcept { return line_; }
  std::uint64_t column() const noexcept { return column_; }
  const std::string& found() const noexcept { return found_; }
  const std::string& accepted() const noexcept { return accepted_; }

 private:
  std::string file_;
  std::uint64_t line_;
  std::uint64_t column_;
  std::string found_;
  std::string accepted_;
};

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

/// What the operating system says of one of its error numbers.
inline std::string reason_of(int error_number) {
  return std::generic_category().message(error_number);
}

}  // namespace hal::files
