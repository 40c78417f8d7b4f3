#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hal/can_frame.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"

namespace hal::files {

/// One line of a log.
struct LoggedFrame {
  enum class Kind : std::uint8_t {
    kData,    ///< a data frame of classic CAN
    kRemote,  ///< a remote frame: asks for `length` bytes and has none
    kFd,      ///< a frame of CAN FD
    kError,  ///< not a frame but what the controller reports (linux/can/error.h); `id` is its class
  };
  enum class Direction : std::uint8_t { kUnknown, kReceived, kSent };

  std::uint64_t time_us = 0;  ///< since the epoch of the clock that wrote the log
  std::string interface;
  Kind kind = Kind::kData;
  Direction direction = Direction::kUnknown;
  std::uint32_t id = 0;
  bool extended = false;
  std::uint8_t fd_flags = 0;  ///< bit 0 bit rate switch, bit 1 error state of the sender
  std::uint8_t length = 0;    ///< 0 .. 8, with CAN FD up to 64
  std::array<std::byte, 64> data{};

  std::span<const std::byte> payload() const { return std::span(data).first(length); }

  /// The frame, if it is a data frame of classic CAN.
  std::optional<hal::CanFrame> classic() const;

  friend bool operator==(const LoggedFrame&, const LoggedFrame&) = default;
};

/// What one line of `candump -L` says, without its line end:
///   (seconds.microseconds) interface ID#DATA
/// with ID of 3 hexadecimal digits, or 8 for 29 bits; DATA of 0 to 8 bytes, or `R` and a length for
/// a remote frame, or after `##` a flag digit and up to 64 bytes for CAN FD; and ` R` or ` T` for
/// received or sent, or nothing. Throws InputError.
LoggedFrame parse_candump_line(const TextPlace& line);

/// Reads a log of `candump -L` of any length in constant memory. Lines that start with `#` are
/// comments. Times are given as they are: logs of several interfaces are not strictly in order.
class CandumpReader {
 public:
  /// `-` reads standard input. Throws InputError.
  explicit CandumpReader(const std::filesystem::path& path);

  /// Reads from `source`; `name` stands for the file in errors.
  CandumpReader(std::unique_ptr<ByteSource> source, std::string_view name);

  /// The next line, or nothing at the end. Throws InputError, and is then of no further use.
  std::optional<LoggedFrame> next();

  std::uint64_t bytes_read() const noexcept { return lines_.bytes_read(); }
  std::uint64_t bytes_total() const noexcept { return lines_.bytes_total(); }

 private:
  std::string name_;
  LineBuffer lines_;
};

/// The line that `candump -L` writes for this frame, with its line end and without a direction.
/// @pre the interface is a name of 1 .. 15 printable characters without spaces.
std::string candump_line(const LoggedFrame& frame);

/// The same for a data frame.
std::string candump_line(std::uint64_t time_us, std::string_view interface,
                         const hal::CanFrame& frame);

}  // namespace hal::files
