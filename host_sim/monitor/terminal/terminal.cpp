#include "host_sim/monitor/terminal/terminal.hpp"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "host_sim/monitor/terminal/table.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::chrono::milliseconds kBetweenDraws{200};
constexpr std::string_view kEnter = "\x1b[?1049h\x1b[?25l";  // other screen, no cursor
constexpr std::string_view kLeave = "\x1b[?25h\x1b[?1049l";
constexpr std::string_view kHome = "\x1b[H";
constexpr std::string_view kEndOfLine = "\x1b[K";
constexpr std::string_view kEndOfScreen = "\x1b[J";
constexpr char kControlC = 3;

struct Size {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

Size terminal_size() {
  ::winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
    return {};
  }
  return {size.ws_col, size.ws_row};
}

/// A view that cannot be drawn is no reason to stop.
void put(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(STDOUT_FILENO, text.data(), text.size());
    if (count <= 0 && errno != EINTR) {
      return;
    }
    text.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
}

std::optional<char> key() {
  ::pollfd waiting{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  char typed = 0;
  if (::poll(&waiting, 1, 0) != 1 || ::read(STDIN_FILENO, &typed, 1) != 1) {
    return std::nullopt;
  }
  return typed;
}

}  // namespace

bool can_draw() {
  const char* const kind = std::getenv("TERM");
  return ::isatty(STDOUT_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

bool wants_colours() {
  const char* const none = std::getenv("NO_COLOR");
  return can_draw() && (none == nullptr || *none == '\0');
}

Terminal::Terminal(std::function<std::vector<std::string>()> troubles)
    : troubles_(std::move(troubles)), colours_(wants_colours()) {
  ::termios now{};
  if (::tcgetattr(STDIN_FILENO, &now) == 0) {
    before_ = std::make_unique<::termios>(now);
    // Ctrl-C is read as a key, so that no second one ends the program before this is gone.
    now.c_lflag &= ~static_cast<::tcflag_t>(ICANON | ECHO | ISIG);
    now.c_cc[VMIN] = 0;
    now.c_cc[VTIME] = 0;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &now);
  }
  put(kEnter);
}

Terminal::~Terminal() {
  put(kLeave);
  if (before_) {
    ::tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
  }
}

void Terminal::update(const FleetView& view) {
  const Clock::time_point now = Clock::now();
  if (now < next_draw_) {
    return;
  }
  next_draw_ = now + kBetweenDraws;
  const Size size = terminal_size();
  std::vector<std::string> lines = table_of(view, {.width = size.columns, .colours = colours_});
  for (const std::string& trouble : troubles_()) {
    lines.insert(lines.begin() + 1, trouble.substr(0, size.columns));
  }
  const std::string ending = before_ ? "q ends" : "";
  const std::size_t room = size.rows - std::min<std::size_t>(size.rows, 1);
  const std::size_t shown = std::min(lines.size(), room);
  std::string screen(kHome);
  for (std::size_t i = 0; i < shown; ++i) {
    screen.append(lines[i]).append(kEndOfLine).append("\r\n");
  }
  const std::size_t hidden = lines.size() - shown;
  screen += hidden == 0 ? ending : std::to_string(hidden) + " more; " + ending;
  screen.append(kEndOfLine).append(kEndOfScreen);
  put(screen);
}

bool Terminal::wants_end() {
  while (before_) {
    const auto typed = key();
    if (!typed) {
      return false;
    }
    if (*typed == 'q' || *typed == 'Q' || *typed == kControlC) {
      return true;
    }
  }
  return false;
}

}  // namespace host_sim::monitor
