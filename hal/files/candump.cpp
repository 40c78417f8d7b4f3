#include "hal/files/candump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hal::files {
namespace {

using FrameKind = LoggedFrame::Kind;

constexpr std::string_view kAcceptedLine = "(seconds.microseconds) interface ID#DATA";
constexpr std::string_view kAcceptedTime = "(seconds.microseconds) with 6 digits of microseconds";
constexpr std::string_view kAcceptedId = "3 hexadecimal digits up to 7FF, or 8 up to 1FFFFFFF";
constexpr std::string_view kAcceptedData = "0 to 8 bytes of 2 hexadecimal digits";
constexpr std::string_view kAcceptedFd =
    "after ## a flag digit and 0 to 8, 12, 16, 20, 24, 32, 48 or 64 bytes";

constexpr std::size_t kLongestInterface = 15;  // IFNAMSIZ of Linux, without the final zero
constexpr std::uint32_t kErrorFlag = 0x2000'0000;
constexpr std::uint32_t kLargestBaseId = 0x7ff;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') {
    return c - '0';
  }
  if (c >= 'A' && c <= 'F') {
    return c - 'A' + 10;
  }
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

bool is_fd_length(std::size_t length) {
  constexpr std::array<std::size_t, 7> kLong{12, 16, 20, 24, 32, 48, 64};
  return length <= 8 || std::find(kLong.begin(), kLong.end(), length) != kLong.end();
}

class LineParser {
 public:
  explicit LineParser(const TextPlace& line) : line_(line) {}

  LoggedFrame parse() {
    read_time();
    read_interface();
    read_id();
    read_content();
    read_direction();
    return frame_;
  }

 private:
  bool at_end() const { return at_ == line_.text.size(); }
  char here() const { return at_end() ? '\0' : line_.text[at_]; }

  [[noreturn]] void fail(std::size_t offset, std::string_view accepted) const {
    line_.fail(offset,
               offset == line_.text.size() ? "the line ends" : in_quotes(line_.text.substr(offset)),
               accepted);
  }
  [[noreturn]] void fail(std::string_view accepted) const { fail(at_, accepted); }

  bool take(char wanted) {
    const bool found = !at_end() && line_.text[at_] == wanted;
    at_ += found ? 1 : 0;
    return found;
  }
  void demand(char wanted, std::string_view accepted) {
    if (!take(wanted)) {
      fail(accepted);
    }
  }

  std::uint64_t read_digits(std::size_t least, std::size_t most) {
    const std::size_t start = at_;
    std::uint64_t value = 0;
    while (here() >= '0' && here() <= '9') {
      value = 10 * value + static_cast<std::uint64_t>(here() - '0');
      ++at_;
      if (at_ - start > most) {
        fail(start, kAcceptedTime);
      }
    }
    if (at_ - start < least) {
      fail(kAcceptedTime);
    }
    return value;
  }

  void read_time() {
    demand('(', kAcceptedLine);
    const std::uint64_t seconds = read_digits(1, 12);
    demand('.', kAcceptedTime);
    frame_.time_us = seconds * 1'000'000 + read_digits(6, 6);
    demand(')', kAcceptedTime);
    demand(' ', kAcceptedLine);
  }

  void read_interface() {
    const std::size_t start = at_;
    while (here() > ' ' && here() <= '~') {
      ++at_;
    }
    const std::size_t length = at_ - start;
    if (length == 0 || length > kLongestInterface || here() != ' ') {
      fail(start, "an interface name of 1 to 15 printable characters and a space");
    }
    frame_.interface = line_.text.substr(start, length);
    ++at_;
  }

  void read_id() {
    const std::size_t start = at_;
    std::uint32_t id = 0;
    while (at_ - start < 8 && hex_digit(here()) >= 0) {
      id = 16 * id + static_cast<std::uint32_t>(hex_digit(here()));
      ++at_;
    }
    const std::size_t digits = at_ - start;
    if (here() != '#' || (digits != 3 && digits != 8)) {
      fail(start, kAcceptedId);
    }
    frame_.extended = digits == 8;
    if (frame_.extended && (id & kErrorFlag) != 0) {
      frame_.kind = FrameKind::kError;
      frame_.extended = false;
      id &= ~kErrorFlag;
    }
    if (id >= kErrorFlag || (digits == 3 && id > kLargestBaseId)) {
      fail(start, kAcceptedId);
    }
    frame_.id = id;
    ++at_;
  }

  void read_content() {
    if (here() == '#' && frame_.kind == FrameKind::kData) {
      ++at_;
      read_fd_flags();
      read_bytes(kAcceptedFd);
    } else if (here() == 'R' && frame_.kind == FrameKind::kData) {
      ++at_;
      read_remote_length();
    } else {
      read_bytes(kAcceptedData);
    }
  }

  void read_fd_flags() {
    const int flags = hex_digit(here());
    if (flags < 0) {
      fail(kAcceptedFd);
    }
    frame_.kind = FrameKind::kFd;
    frame_.fd_flags = static_cast<std::uint8_t>(flags);
    ++at_;
  }

  void read_remote_length() {
    frame_.kind = FrameKind::kRemote;
    if (here() >= '0' && here() <= '8') {
      frame_.length = static_cast<std::uint8_t>(here() - '0');
      ++at_;
    }
  }

  void read_bytes(std::string_view accepted) {
    const std::size_t start = at_;
    const std::size_t most = frame_.kind == FrameKind::kFd ? 64 : 8;
    std::size_t length = 0;
    while (hex_digit(here()) >= 0) {
      const int high = hex_digit(here());
      ++at_;
      const int low = hex_digit(here());
      if (low < 0 || length == most) {
        fail(low < 0 ? at_ : start, accepted);
      }
      ++at_;
      frame_.data[length++] = static_cast<std::byte>(16 * high + low);
    }
    if (!is_fd_length(length)) {
      fail(start, accepted);
    }
    frame_.length = static_cast<std::uint8_t>(length);
  }

  void read_direction() {
    if (at_end()) {
      return;
    }
    const std::size_t start = at_;
    if (take(' ')) {
      const char mark = here();
      if ((mark == 'R' || mark == 'T') && at_ + 1 == line_.text.size()) {
        frame_.direction =
            mark == 'R' ? LoggedFrame::Direction::kReceived : LoggedFrame::Direction::kSent;
        return;
      }
    }
    fail(start, frame_.kind == FrameKind::kFd ? kAcceptedFd : kAcceptedData);
  }

  const TextPlace& line_;
  std::size_t at_ = 0;
  LoggedFrame frame_;
};

constexpr std::string_view kAcceptedLog = "a log of candump -L, or - for standard input";

}  // namespace

LoggedFrame parse_candump_line(const TextPlace& line) {
  return LineParser(line).parse();
}

std::string candump_line(const LoggedFrame& frame) {
  const bool error = frame.kind == FrameKind::kError;
  std::string line = fmt::format(
      "({:010}.{:06}) {} {:0{}X}#", frame.time_us / 1'000'000, frame.time_us % 1'000'000,
      frame.interface, error ? frame.id | kErrorFlag : frame.id, frame.extended || error ? 8 : 3);
  if (frame.kind == FrameKind::kRemote) {
    line += 'R';
    if (frame.length != 0) {
      line += static_cast<char>('0' + frame.length);
    }
  } else {
    if (frame.kind == FrameKind::kFd) {
      fmt::format_to(std::back_inserter(line), "#{:X}", frame.fd_flags & 0xfu);
    }
    for (const std::byte byte : frame.payload()) {
      fmt::format_to(std::back_inserter(line), "{:02X}", std::to_integer<unsigned>(byte));
    }
  }
  line += '\n';
  return line;
}

std::string candump_line(std::uint64_t time_us, std::string_view interface,
                         const hal::CanFrame& frame) {
  LoggedFrame logged;
  logged.time_us = time_us;
  logged.interface = interface;
  logged.id = frame.id;
  logged.extended = frame.extended;
  logged.length = frame.length;
  std::copy_n(frame.data.begin(), frame.data.size(), logged.data.begin());
  return candump_line(logged);
}

std::optional<hal::CanFrame> LoggedFrame::classic() const {
  if (kind != FrameKind::kData) {
    return std::nullopt;
  }
  hal::CanFrame frame{.id = id, .extended = extended, .length = length};
  std::copy_n(data.begin(), frame.data.size(), frame.data.begin());
  return frame;
}

CandumpReader::CandumpReader(const std::filesystem::path& path)
    : CandumpReader(open_source(path, kAcceptedLog),
                    path == "-" ? "standard input" : path.string()) {}

CandumpReader::CandumpReader(std::unique_ptr<ByteSource> source, std::string_view name)
    : name_(name), lines_(std::move(source), name_) {}

std::optional<LoggedFrame> CandumpReader::next() {
  while (lines_.fill()) {
    const bool comment = *lines_.position() == '#';
    std::optional<LoggedFrame> frame;
    if (!comment) {
      frame = parse_candump_line({name_, lines_.line_number(), lines_.line()});
    }
    lines_.next_line(lines_.line_end());
    if (frame) {
      return frame;
    }
  }
  return std::nullopt;
}

}  // namespace hal::files
