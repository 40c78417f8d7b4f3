#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace host_sim {

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

}  // namespace host_sim
