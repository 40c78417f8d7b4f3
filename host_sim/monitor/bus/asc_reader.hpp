#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "hal/files/input_file.hpp"
#include "host_sim/monitor/bus/frame_log.hpp"

namespace host_sim::monitor {

/// Whether text that begins so is a Vector ASC file: with a date, a base or a comment.
bool is_asc(std::string_view front);

/// A Vector ASC file, as CANalyzer and CANoe write it:
///   base hex|dec  timestamps absolute|relative
///   TIME CHANNEL ID[x] Rx|Tx d LENGTH BYTE...      data frame, x: 29 bits
///   TIME CHANNEL ID[x] Rx|Tx r [LENGTH]            remote frame
///   TIME CHANNEL ErrorFrame ...
///   TIME CAN CHANNEL Status:chip status WORDS      error active, bus off
///   TIME CANFD CHANNEL Rx|Tx ID[x] [NAME] BRS ESI DLC LENGTH BYTE... DURATION BITS FLAGS ...
/// A CANFD line whose flags lack bit 12 is a frame of classic CAN. Times are seconds from the start
/// of the log. Comments (//), other headers and events of other kinds are skipped; requests to send
/// (TxRq) were not on the bus.
class AscReader final : public LogReader {
 public:
  /// `name` stands for the file in errors.
  AscReader(std::unique_ptr<hal::files::ByteSource> source, std::string name);

  std::optional<SeenFrame> next() override;

 private:
  struct Format {
    bool hexadecimal = true;
    bool relative = false;
  };

  std::optional<SeenFrame> take_line();

  std::string name_;
  hal::files::LineBuffer lines_;
  Format format_;
  std::int64_t time_ns_ = 0;
};

}  // namespace host_sim::monitor
