#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host_sim/monitor/fleet/watch.hpp"

struct termios;

namespace host_sim::monitor {

/// Whether standard output is a terminal that can be drawn on.
bool can_draw();
/// Whether colours are wanted: on a terminal, unless NO_COLOR says otherwise (no-color.org).
bool wants_colours();

/// The fleet on the whole terminal, drawn anew a few times a second, until q or Ctrl-C is typed.
/// The terminal is as it was when this is gone.
class Terminal final : public Observer {
 public:
  /// `troubles` gives what else the user has to know, a line each. @pre can_draw()
  explicit Terminal(std::function<std::vector<std::string>()> troubles);
  ~Terminal() override;

  void update(const FleetView& view) override;
  [[nodiscard]] bool wants_end() override;
  [[nodiscard]] bool outlives_log() const override { return true; }

 private:
  using Clock = std::chrono::steady_clock;

  std::function<std::vector<std::string>()> troubles_;
  std::unique_ptr<::termios> before_;  ///< of standard input, where that is a terminal
  Clock::time_point next_draw_{};
  bool colours_;
};

}  // namespace host_sim::monitor
