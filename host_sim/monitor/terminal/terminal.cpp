#include "host_sim/monitor/terminal/terminal.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "hal/files/input_error.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::chrono::milliseconds kBetweenDraws{200};
constexpr std::string_view kEnter = "\x1b[?1049h\x1b[?25l";  // other screen, no cursor
constexpr std::string_view kLeave = "\x1b[?25h\x1b[?1049l";
constexpr std::string_view kHome = "\x1b[H";
constexpr std::string_view kEndOfLine = "\x1b[K";
constexpr std::string_view kEndOfScreen = "\x1b[J";

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

std::string typed() {
  std::string bytes(64, '\0');
  ::pollfd waiting{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  const ssize_t count =
      ::poll(&waiting, 1, 0) == 1 ? ::read(STDIN_FILENO, bytes.data(), bytes.size()) : 0;
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return bytes;
}

constexpr std::int64_t kSecond_us = 1'000'000;
constexpr std::int64_t kStep_us = 10 * kSecond_us;
constexpr std::int64_t kFarStep_us = 600 * kSecond_us;

std::int64_t now_us(const FleetView& view) {
  return view.now_ns / 1000;
}

/// With date and time zone, or in seconds where a log begins at 0.
std::string time_text(std::int64_t time_us) {
  constexpr std::int64_t kYear2001_us = 978'307'200 * kSecond_us;
  const std::int64_t tenth = time_us / 100'000 % 10;
  return time_us > kYear2001_us
             ? fmt::format("{:%F %T}.{} {:%Z}", fmt::localtime(time_us / kSecond_us), tenth,
                           fmt::localtime(time_us / kSecond_us))
             : fmt::format("{}.{} s", time_us / kSecond_us, tenth);
}

/// The nodes that the frames of a moment do not have are there as well, and nothing is known of
/// them.
void add_unheard(FleetView& then, const FleetView& now) {
  for (const auto& [number, node] : now.nodes) {
    then.nodes.try_emplace(number).first->second.node = number;
  }
}

}  // namespace

std::vector<Key> keys_of(std::string_view typed) {
  constexpr std::pair<std::string_view, Key> kKeys[] = {
      {"q", Key::end},          {"Q", Key::end},
      {"\x03", Key::end},       {" ", Key::pause},
      {"p", Key::pause},        {"\x1b[D", Key::back},
      {"\x1bOD", Key::back},    {"\x1b[C", Key::on},
      {"\x1bOC", Key::on},      {"\x1b[5~", Key::far_back},
      {"\x1b[6~", Key::far_on}, {"\x1b[H", Key::oldest},
      {"\x1b[1~", Key::oldest}, {"\x1bOH", Key::oldest},
      {"\x1b[F", Key::newest},  {"\x1b[4~", Key::newest},
      {"\x1bOF", Key::newest}};
  std::vector<Key> keys;
  while (!typed.empty()) {
    const auto key = std::find_if(std::begin(kKeys), std::end(kKeys), [typed](const auto& one) {
      return typed.starts_with(one.first);
    });
    if (key != std::end(kKeys)) {
      keys.push_back(key->second);
    }
    typed.remove_prefix(key == std::end(kKeys) ? 1 : key->first.size());
  }
  return keys;
}

bool can_draw() {
  const char* const kind = std::getenv("TERM");
  return ::isatty(STDOUT_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

TableStyle terminal_style() {
  const char* const none = std::getenv("NO_COLOR");
  return can_draw() ? TableStyle{.width = terminal_size().columns,
                                 .colours = none == nullptr || *none == '\0'}
                    : TableStyle{};
}

Terminal::Terminal(const FrameArchive& archive, std::function<std::vector<std::string>()> troubles)
    : archive_(archive), troubles_(std::move(troubles)) {
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
  for (const Key key : before_ ? keys_of(typed()) : std::vector<Key>()) {
    obey(key, view);
    next_draw_ = {};
  }
  read_on(view);
  const Clock::time_point now = Clock::now();
  if (now >= next_draw_) {
    next_draw_ = now + kBetweenDraws;
    draw(view);
  }
}

void Terminal::obey(Key key, const FleetView& view) {
  const std::int64_t at_us = wanted_us_ ? *wanted_us_ : now_us(paused_ ? paused_->view : view);
  switch (key) {
    case Key::end:
      ended_ = true;
      return;
    case Key::pause:
      if (paused_ || wanted_us_) {
        return go_to(now_us(view), view);
      }
      paused_ = Moment{.view = view};
      return;
    case Key::back:
      return go_to(at_us - kStep_us, view);
    case Key::on:
      return go_to(at_us + kStep_us, view);
    case Key::far_back:
      return go_to(at_us - kFarStep_us, view);
    case Key::far_on:
      return go_to(at_us + kFarStep_us, view);
    case Key::oldest:
      return go_to(0, view);
    case Key::newest:
      return go_to(now_us(view), view);
  }
}

void Terminal::go_to(std::int64_t time_us, const FleetView& view) {
  trouble_.clear();
  if (time_us >= now_us(view)) {
    paused_.reset();
    wanted_us_.reset();
    return;
  }
  const std::vector<std::int64_t> times_us = archive_.times_us();
  const std::int64_t oldest_us = times_us.empty() ? now_us(view) : times_us.front();
  wanted_us_ = std::max(time_us, oldest_us);
}

/// Takes what was read, and begins to read what is wanted.
void Terminal::read_on(const FleetView& view) {
  if (reading_.valid()) {
    if (reading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return;
    }
    try {
      Moment read = reading_.get();
      if (wanted_us_) {
        add_unheard(read.view, view);
        paused_ = std::move(read);
      }
    } catch (const hal::files::InputError& error) {
      trouble_ = error.what();
    }
    if (wanted_us_ == reading_us_) {
      wanted_us_.reset();
    }
    next_draw_ = {};
  }
  if (wanted_us_) {
    FleetView bus;
    bus.source = view.source;
    bus.bit_rate_bit_s = view.bit_rate_bit_s;
    reading_us_ = *wanted_us_;
    reading_ = std::async(std::launch::async, [this, bus = std::move(bus), at_us = reading_us_] {
      return moment_of(archive_, bus, at_us);
    });
  }
}

/// Where in time the terminal is, if not at the newest.
std::string Terminal::place(const FleetView& view) const {
  if (!paused_) {
    return {};
  }
  const std::int64_t at_us = now_us(paused_->view);
  std::string text = fmt::format("PAUSED at {}, {:.1f} s before the newest", time_text(at_us),
                                 static_cast<double>(now_us(view) - at_us) / 1e6);
  if (paused_->from_us > 0) {
    text += fmt::format("; counts are of the last {} min", kMomentWindow_us / (60 * kSecond_us));
  }
  return text;
}

void Terminal::draw(const FleetView& view) {
  const Size size = terminal_size();
  std::vector<std::string> lines = table_of(paused_ ? paused_->view : view, terminal_style());
  std::vector<std::string> above = troubles_();
  above.insert(above.begin(), {place(view), trouble_});
  for (auto text = above.rbegin(); text != above.rend(); ++text) {
    if (!text->empty()) {
      lines.insert(lines.begin() + 1, text->substr(0, size.columns));
    }
  }
  const std::string keys = !before_  ? ""
                           : paused_ ? "q ends, space goes on, arrows and page keys move"
                                     : "q ends, space pauses, arrows and page keys go back";
  const std::size_t room = size.rows - std::min<std::size_t>(size.rows, 1);
  const std::size_t shown = std::min(lines.size(), room);
  std::string screen(kHome);
  for (std::size_t i = 0; i < shown; ++i) {
    screen.append(lines[i]).append(kEndOfLine).append("\r\n");
  }
  const std::size_t hidden = lines.size() - shown;
  const std::string last = hidden == 0 ? keys : std::to_string(hidden) + " more; " + keys;
  screen.append(last.substr(0, size.columns)).append(kEndOfLine).append(kEndOfScreen);
  put(screen);
}

}  // namespace host_sim::monitor
