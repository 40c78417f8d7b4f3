#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "firmware/boards/linux/board_clock.hpp"
#include "firmware/boards/linux/config.hpp"
#include "hal/can_port.hpp"
#include "hal/files/output_file.hpp"
#include "hal/linux/socketcan.hpp"

namespace board {

/// The bus of the configuration: an interface of SocketCAN, or none, with the frames in a log as
/// `candump -L` writes it.
class BoardCan {
 public:
  /// `clock` outlives the port. Throws hal::linux_os::DeviceError or hal::files::OutputError.
  BoardCan(const CanConfig& config, protocol::Node node, const BoardClock& clock);

  hal::Error send(const hal::CanFrame& frame);
  std::optional<hal::CanFrame> receive();
  [[nodiscard]] hal::CanStatus status() const;
  hal::Error recover();

  /// Nothing without a bus.
  [[nodiscard]] const hal::linux_os::SocketCanCounts* counts() const;
  /// Frames that went into the log.
  [[nodiscard]] std::uint64_t logged() const { return logged_; }
  /// Puts the log in place. Throws hal::files::OutputError.
  void finish();

 private:
  const BoardClock& clock_;
  hal::linux_os::CanCalls calls_;
  std::optional<hal::linux_os::SocketCan> bus_;
  std::optional<hal::files::OutputFile> log_;
  std::uint64_t logged_ = 0;
};
static_assert(hal::CanPort<BoardCan>);

}  // namespace board
