#include "host_sim/io/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "hal/files/text.hpp"

namespace host_sim {

using hal::files::character_count;
using hal::files::printable;

namespace {

constexpr std::size_t kLabelLimit = 30;
constexpr std::size_t kWidestBar = 40;
constexpr std::size_t kNarrowestBar = 5;
constexpr std::size_t kUsualWidth = 80;
constexpr std::chrono::milliseconds kBetweenDraws{100};
constexpr double kMega = 1e6;

std::string duration_text(double duration_s) {
  const double longest_s = 359999.0;
  const auto seconds = static_cast<unsigned>(std::ceil(std::clamp(duration_s, 0.0, longest_s)));
  const unsigned minutes = seconds / 60;
  if (minutes < 60) {
    return fmt::format("{}:{:02}", minutes, seconds % 60);
  }
  return fmt::format("{}:{:02}:{:02}", minutes / 60, minutes % 60, seconds % 60);
}

std::size_t terminal_width(int descriptor) {
  winsize size{};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) {
    return kUsualWidth;
  }
  return size.ws_col;
}

bool can_draw(int descriptor) {
  const char* const kind = std::getenv("TERM");
  return ::isatty(descriptor) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

// A progress bar that cannot be drawn is no reason to stop the work.
void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count <= 0) {
      return;
    }
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

/// `label [###---]tail`, with as much of a bar as the width allows.
std::string with_bar(std::string text, double share, const std::string& tail, std::size_t width) {
  const std::size_t used = character_count(text) + tail.size() + 3;
  const std::size_t bar = std::min(width > used ? width - used : 0, kWidestBar);
  if (bar >= kNarrowestBar) {
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(bar));
    text += fmt::format(" [{:-<{}}]", std::string(filled, '#'), bar);
  }
  text += tail;
  return text.substr(0, width);
}

std::string percent_text(double share) {
  return fmt::format(" {:3} %", std::floor(100.0 * share));
}

}  // namespace

std::string progress_text(std::string_view label, std::uint64_t done, std::uint64_t total,
                          double elapsed_s, std::size_t width) {
  const double rate = elapsed_s > 0.0 ? static_cast<double>(done) / elapsed_s : 0.0;
  std::string text = printable(label, kLabelLimit);
  if (total == 0) {
    text +=
        fmt::format("  {:.1f} MB  {:.1f} MB/s", static_cast<double>(done) / kMega, rate / kMega);
    return text.substr(0, width);
  }
  done = std::min(done, total);
  const double share = static_cast<double>(done) / static_cast<double>(total);
  std::string tail = percent_text(share) + fmt::format("  {:.1f} MB/s", rate / kMega);
  if (rate > 0.0) {
    tail += fmt::format("  {} left", duration_text(static_cast<double>(total - done) / rate));
  }
  return with_bar(std::move(text), share, tail, width);
}

std::string share_text(std::string_view label, double share, double elapsed_s, std::size_t width) {
  share = std::clamp(share, 0.0, 1.0);
  std::string tail = percent_text(share);
  if (share > 0.0) {
    tail += fmt::format("  {} left", duration_text(elapsed_s * (1 - share) / share));
  }
  return with_bar(printable(label, kLabelLimit), share, tail, width);
}

Progress::Progress(std::string_view label, std::uint64_t total, int descriptor)
    : label_(label),
      total_(total),
      descriptor_(descriptor),
      terminal_(can_draw(descriptor)),
      start_(Clock::now()),
      next_draw_(start_ + kBetweenDraws) {}

Progress::~Progress() {
  finish();
}

bool Progress::due() const {
  return terminal_ && Clock::now() >= next_draw_;
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::size_t Progress::width() const {
  return terminal_width(descriptor_) - 1;
}

void Progress::draw(const std::string& text) {
  next_draw_ = Clock::now() + kBetweenDraws;
  write_all(descriptor_, fmt::format("\r{}\x1b[K", text));
  drawn_ = true;
}

void Progress::update(std::uint64_t done) {
  if (due()) {
    draw(progress_text(label_, done, total_, elapsed_s(), width()));
  }
}

void Progress::update_share(double share) {
  if (due()) {
    draw(share_text(label_, share, elapsed_s(), width()));
  }
}

void Progress::finish() {
  if (drawn_) {
    write_all(descriptor_, "\r\x1b[K");
    drawn_ = false;
  }
}

}  // namespace host_sim
