#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "hal/linux/descriptor.hpp"
#include "host_sim/monitor/bus/frame_source.hpp"

namespace host_sim::monitor {

/// Frames of a CAN interface: all of them, CAN FD and remote frames too, and what the controller
/// reports of errors. Never sends. An interface that goes down or vanishes is tried again until it
/// is back. Times are of the kernel, carried over to a clock that nobody sets: 1970 as it was when
/// the source was opened.
class SocketCanSource final : public FrameSource {
 public:
  /// @throws hal::linux_os::DeviceError where there is no such CAN interface, or it cannot be used
  explicit SocketCanSource(std::string interface);

  std::optional<SeenFrame> next(std::chrono::milliseconds most) override;
  [[nodiscard]] State state() const override;
  [[nodiscard]] std::string description() const override;
  [[nodiscard]] std::int64_t now_ns() const override;

 private:
  int open();
  void lose(int error);
  void try_again(std::chrono::milliseconds most);
  std::optional<SeenFrame> receive();
  [[nodiscard]] std::int64_t seen_at(std::int64_t stamp_ns);

  std::string interface_;
  hal::linux_os::Descriptor socket_;
  std::string trouble_;  ///< "is down"; empty while it runs
  std::int64_t epoch_ns_;
  std::int64_t last_ns_ = 0;
  std::uint32_t overflows_ = 0;  ///< of this socket so far
};

}  // namespace host_sim::monitor
