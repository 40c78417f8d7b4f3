#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hal/files/candump.hpp"
#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::monitor {

/// The frames of a log, from the first to the last, in constant memory.
class LogReader {
 public:
  LogReader() = default;
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;
  virtual ~LogReader() = default;

  /// The next frame, or none at the end. Times are as the log has them: those of several interfaces
  /// are not strictly in order.
  /// @throws InputError, and is then of no further use
  virtual std::optional<SeenFrame> next() = 0;
};

/// A log of candump -L. Lines of all interfaces are taken.
class CandumpLogReader final : public LogReader {
 public:
  /// `-` is standard input. @throws InputError
  explicit CandumpLogReader(const std::filesystem::path& path)
      : name_(path.string()), reader_(path) {}
  CandumpLogReader(std::unique_ptr<hal::files::ByteSource> source, std::string_view name)
      : name_(name), reader_(std::move(source), name) {}

  std::optional<SeenFrame> next() override;

 private:
  std::string name_;
  hal::files::CandumpReader reader_;
};

/// The line that `candump -L` writes for what was seen, with its line end: data, remote and error
/// frames and those of CAN FD.
std::string log_line(const SeenFrame& seen, std::string_view interface);

/// Opens a log of candump -L, a Vector ASC file, or PCAP or PCAPNG of SocketCAN, whichever its
/// first bytes show it to be. `-` is a log of candump -L on standard input.
/// @throws InputError
std::unique_ptr<LogReader> open_log(const std::filesystem::path& path);

}  // namespace host_sim::monitor
