#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/monitor/fleet/watch.hpp"
#include "host_sim/monitor/record/moment.hpp"
#include "host_sim/monitor/terminal/table.hpp"

struct termios;

namespace host_sim::monitor {

/// Whether standard output is a terminal that can be drawn on.
bool can_draw();
/// As wide as the terminal, and in colours unless NO_COLOR says otherwise (no-color.org); neither
/// where standard output is none.
TableStyle terminal_style();

/// What is typed on the terminal.
enum class Key : std::uint8_t { end, pause, back, on, far_back, far_on, oldest, newest };

/// The keys in what a terminal sends for them (ECMA-48, and the function keys of xterm); what is
/// none is left out.
[[nodiscard]] std::vector<Key> keys_of(std::string_view typed);

/// The fleet on the whole terminal, drawn anew a few times a second, until q or Ctrl-C is typed. It
/// can be paused and go back through an archive. The terminal is as it was when this is gone.
class Terminal final : public Observer {
 public:
  /// @param archive what there is of the past
  /// @param troubles gives what else the user has to know, a line each
  /// @pre can_draw()
  Terminal(const FrameArchive& archive, std::function<std::vector<std::string>()> troubles);
  ~Terminal() override;

  void update(const FleetView& view) override;
  [[nodiscard]] bool wants_end() override { return ended_; }
  [[nodiscard]] bool outlives_log() const override { return true; }

 private:
  using Clock = std::chrono::steady_clock;

  void obey(Key key, const FleetView& view);
  void go_to(std::int64_t time_us, const FleetView& view);
  void read_on(const FleetView& view);
  void draw(const FleetView& view);
  [[nodiscard]] std::string place(const FleetView& view) const;

  const FrameArchive& archive_;
  std::function<std::vector<std::string>()> troubles_;
  std::unique_ptr<::termios> before_;  ///< of standard input, where that is a terminal
  Clock::time_point next_draw_{};
  bool ended_ = false;
  std::optional<Moment> paused_;           ///< what is shown instead of the newest
  std::optional<std::int64_t> wanted_us_;  ///< a moment that is to be read
  std::future<Moment> reading_;            ///< apart, so that no frame waits for it
  std::int64_t reading_us_ = 0;
  std::string trouble_;  ///< why it could not be read
};

}  // namespace host_sim::monitor
