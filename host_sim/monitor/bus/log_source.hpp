#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "host_sim/monitor/bus/frame_source.hpp"
#include "host_sim/monitor/bus/log_reader.hpp"

namespace host_sim::monitor {

/// Replays a log at `speed` times the pace at which it was recorded; 0 is as fast as it goes. Time
/// is that of the log, and never falls: a frame that is earlier than the one before it has its
/// time.
class LogSource final : public FrameSource {
 public:
  LogSource(std::unique_ptr<LogReader> reader, std::string name, double speed);

  std::optional<SeenFrame> next(std::chrono::milliseconds most) override;
  [[nodiscard]] State state() const override;
  [[nodiscard]] std::string words() const override;
  [[nodiscard]] std::int64_t now_ns() const override;

 private:
  using Clock = std::chrono::steady_clock;

  void fill();
  [[nodiscard]] Clock::time_point due() const;

  std::unique_ptr<LogReader> reader_;
  std::string name_;
  double speed_;
  std::optional<SeenFrame> waiting_;
  std::int64_t begin_ns_ = 0;  ///< of the first frame
  std::int64_t last_ns_ = 0;   ///< of the last frame that was given
  Clock::time_point began_{};
  bool began_once_ = false;
  bool ended_ = false;
};

}  // namespace host_sim::monitor
