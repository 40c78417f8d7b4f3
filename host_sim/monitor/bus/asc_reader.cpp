#include "host_sim/monitor/bus/asc_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"

namespace host_sim::monitor {

using hal::files::in_quotes;

using hal::files::ByteSource;
using hal::files::TextPlace;

namespace {

constexpr std::string_view kSpace = " \t";

char small(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Whether two texts are the same but for capital letters.
bool same_word(std::string_view one, std::string_view other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](char a, char b) { return small(a) == small(b); });
}

/// The number in `word` to `base`, all of it.
std::optional<std::uint64_t> number_of(std::string_view word, int base) {
  std::uint64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value, base);
  if (error != std::errc() || stop != end) {
    return std::nullopt;
  }
  return value;
}

/// The tokens of a line, one after the other.
class AscTokens {
 public:
  /// `line` outlives the tokens.
  explicit AscTokens(const TextPlace& line) : line_(line) {
    std::size_t at = 0;
    while ((at = line.text.find_first_not_of(kSpace, at)) != std::string_view::npos) {
      const std::size_t end = std::min(line.text.find_first_of(kSpace, at), line.text.size());
      tokens_.push_back(line.text.substr(at, end - at));
      at = end;
    }
  }

  /// The token `ahead` of the next one; empty past the end.
  [[nodiscard]] std::string_view peek(std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : std::string_view();
  }
  /// Whether the next token is this word, in capitals or not; it is then taken.
  bool take(std::string_view word) {
    const bool found = same_word(peek(), word);
    at_ += found ? 1 : 0;
    return found;
  }
  /// The next token. @throws InputError that says what is `accepted` where there is none
  std::string_view demand(std::string_view accepted) {
    if (at_ >= tokens_.size()) {
      fail(at_, accepted);
    }
    return tokens_[at_++];
  }
  /// A number from 0 to `largest` to `base`. @throws InputError
  std::uint32_t number(int base, std::uint32_t largest, std::string_view accepted) {
    const auto value = number_of(demand(accepted), base);
    if (!value || *value > largest) {
      refuse(accepted);
    }
    return static_cast<std::uint32_t>(*value);
  }
  /// Whether number() would take the token `ahead` of the next one.
  [[nodiscard]] bool is_number(std::size_t ahead, int base) const {
    return number_of(peek(ahead), base).has_value();
  }
  void skip() { ++at_; }
  /// @throws InputError for the token taken last
  [[noreturn]] void refuse(std::string_view accepted) const { fail(at_ - 1, accepted); }

 private:
  [[noreturn]] void fail(std::size_t at, std::string_view accepted) const {
    if (at >= tokens_.size()) {
      line_.fail(line_.text.size(), "the line ends", accepted);
    }
    const auto offset = static_cast<std::size_t>(tokens_[at].data() - line_.text.data());
    line_.fail(offset, in_quotes(tokens_[at].substr(0, 40)), accepted);
  }

  const TextPlace& line_;
  std::vector<std::string_view> tokens_;
  std::size_t at_ = 0;
};

constexpr std::string_view kAcceptedId = "an identifier up to 7FF, or up to 1FFFFFFF with x";
constexpr std::string_view kAcceptedKind = "d and a length, or r";
constexpr std::string_view kAcceptedLength = "a length of 0 to 8 bytes";
constexpr std::string_view kAcceptedByte = "as many bytes as the length says";
constexpr std::string_view kAcceptedFd =
    "[name] BRS ESI DLC, a length of 0 to 64 bytes, and the bytes";
constexpr std::uint32_t kFdFlag = 1u << 12;  // EDL of the flags of a CANFD line

enum class Direction : std::uint8_t { on_bus, request, none };

Direction take_direction(AscTokens& tokens) {
  if (tokens.take("rx") || tokens.take("tx")) {
    return Direction::on_bus;
  }
  return tokens.take("txrq") ? Direction::request : Direction::none;
}

void read_id(AscTokens& tokens, int base, hal::CanFrame& frame) {
  std::string_view word = tokens.demand(kAcceptedId);
  frame.extended = word.ends_with('x') || word.ends_with('X');
  if (frame.extended) {
    word.remove_suffix(1);
  }
  const auto id = number_of(word, base);
  if (!id || *id > (frame.extended ? 0x1fff'ffffu : 0x7ffu)) {
    tokens.refuse(kAcceptedId);
  }
  frame.id = static_cast<std::uint32_t>(*id);
}

template <class Put>
void read_bytes(AscTokens& tokens, int base, std::size_t length, Put put) {
  for (std::size_t i = 0; i < length; ++i) {
    put(i, static_cast<std::byte>(tokens.number(base, 0xff, kAcceptedByte)));
  }
}

void read_classic(AscTokens& tokens, int base, SeenFrame& seen) {
  if (tokens.take("r")) {
    seen.remote_request = true;
    if (tokens.is_number(0, 16)) {
      seen.frame.length = static_cast<std::uint8_t>(tokens.number(16, 8, kAcceptedLength));
    }
    return;
  }
  if (!tokens.take("d")) {
    tokens.demand(kAcceptedKind);
    tokens.refuse(kAcceptedKind);
  }
  seen.frame.length = static_cast<std::uint8_t>(tokens.number(16, 8, kAcceptedLength));
  read_bytes(tokens, base, seen.frame.length,
             [&seen](std::size_t i, std::byte byte) { seen.frame.data[i] = byte; });
}

std::optional<SeenFrame> classic_event(AscTokens& tokens, int base) {
  SeenFrame seen;
  if (tokens.take("errorframe")) {
    seen.error.emplace();
    return seen;
  }
  const bool has_direction = same_word(tokens.peek(1), "rx") || same_word(tokens.peek(1), "tx");
  if (!has_direction) {
    return std::nullopt;  // a statistic, a request to send, or another event of the channel
  }
  read_id(tokens, base, seen.frame);
  take_direction(tokens);
  read_classic(tokens, base, seen);
  return seen;
}

bool take_flag(AscTokens& tokens) {
  return tokens.number(10, 1, kAcceptedFd) == 1;
}

/// The bits of a frame that was logged in the form of CAN FD; nothing where the line has none.
std::optional<std::uint32_t> flags_behind_data(const AscTokens& tokens) {
  constexpr std::size_t kFlags = 2;  // behind the duration and the number of bits
  const auto flags = number_of(tokens.peek(kFlags), 16);
  return flags ? std::optional(static_cast<std::uint32_t>(*flags)) : std::nullopt;
}

std::optional<SeenFrame> flexible_event(AscTokens& tokens, int base) {
  tokens.skip();  // the channel
  if (take_direction(tokens) != Direction::on_bus) {
    return std::nullopt;
  }
  SeenFrame seen;
  if (tokens.take("errorframe")) {
    seen.error.emplace();
    return seen;
  }
  read_id(tokens, base, seen.frame);
  if (tokens.peek() != "0" && tokens.peek() != "1") {
    tokens.demand(kAcceptedFd);  // the name of the message
  }
  seen.fd_flags = static_cast<std::uint8_t>(take_flag(tokens) ? 1 : 0);
  seen.fd_flags = static_cast<std::uint8_t>(seen.fd_flags | (take_flag(tokens) ? 2 : 0));
  tokens.number(16, 15, kAcceptedFd);
  const std::size_t length = tokens.number(10, 64, kAcceptedFd);
  seen.fd_data.resize(length);
  read_bytes(tokens, base, length,
             [&seen](std::size_t i, std::byte byte) { seen.fd_data[i] = byte; });
  const auto flags = flags_behind_data(tokens);
  seen.flexible_data_rate = length > 8 || !flags || (*flags & kFdFlag) != 0;
  if (!seen.flexible_data_rate) {
    std::copy(seen.fd_data.begin(), seen.fd_data.end(), seen.frame.data.begin());
    seen.frame.length = static_cast<std::uint8_t>(length);
    seen.fd_data.clear();
    seen.fd_flags = 0;
  }
  return seen;
}

/// `Status:chip status error active` and the like.
std::optional<SeenFrame> status_event(AscTokens& tokens) {
  tokens.skip();  // the channel
  if (!tokens.take("status:chip") || !tokens.take("status")) {
    return std::nullopt;
  }
  SeenFrame seen;
  BusError error;
  error.bus_off = tokens.take("busoff") ||
                  (same_word(tokens.peek(), "bus") && same_word(tokens.peek(1), "off"));
  if (tokens.take("error")) {
    error.restarted = tokens.take("active");
    error.error_passive = tokens.take("passive");
    error.error_warning = tokens.take("warning");
  } else if (tokens.take("warning")) {
    error.error_warning = true;
  }
  seen.error = error;
  return seen;
}

/// What the tokens of a line after its time say, without a time; nothing where it is an event of
/// another kind. `base` is that of identifiers and data, 10 or 16. @throws InputError
std::optional<SeenFrame> asc_event(AscTokens& tokens, int base) {
  if (tokens.take("canfd")) {
    return flexible_event(tokens, base);
  }
  if (tokens.take("can")) {
    return status_event(tokens);
  }
  if (tokens.is_number(0, 10)) {
    tokens.skip();
    return classic_event(tokens, base);
  }
  return std::nullopt;
}

constexpr std::string_view kAcceptedLine =
    "a time in seconds and an event, a header (date, base, internal events logged, Begin and End "
    "Triggerblock), or a comment after //";
constexpr std::string_view kAcceptedTime = "seconds up to 1e9, with up to 9 decimals";
constexpr std::string_view kAcceptedBase = "base hex or dec, then timestamps absolute or relative";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Seconds as nanoseconds, or nothing.
std::optional<std::int64_t> time_of(std::string_view word) {
  const std::size_t dot = word.find('.');
  const std::string_view whole = word.substr(0, dot);
  const std::string_view fraction =
      dot == std::string_view::npos ? std::string_view() : word.substr(dot + 1);
  const auto seconds = number_of(whole, 10);
  const auto decimals =
      fraction.empty() ? std::optional<std::uint64_t>(0) : number_of(fraction, 10);
  if (!seconds || !decimals || *seconds > 1'000'000'000 || fraction.size() > 9) {
    return std::nullopt;
  }
  std::uint64_t nanoseconds = *decimals;
  for (std::size_t digit = fraction.size(); digit < 9; ++digit) {
    nanoseconds *= 10;
  }
  return static_cast<std::int64_t>(*seconds * 1'000'000'000 + nanoseconds);
}

bool is_header(const AscTokens& tokens) {
  const std::string_view first = tokens.peek();
  const auto is = [&tokens](std::string_view a, std::string_view b) {
    return same_word(tokens.peek(), a) && same_word(tokens.peek(1), b);
  };
  return first.empty() || first.starts_with("//") || same_word(first, "date") ||
         is("internal", "events") || is("no", "internal") || is("begin", "triggerblock") ||
         is("end", "triggerblock");
}

}  // namespace

bool is_asc(std::string_view front) {
  const std::string_view text =
      front.substr(std::min(front.find_first_not_of(" \t\r\n"), front.size()));
  return same_word(text.substr(0, 5), "date ") || same_word(text.substr(0, 5), "base ") ||
         text.starts_with("//");
}

AscReader::AscReader(std::unique_ptr<ByteSource> source, std::string name)
    : name_(std::move(name)), lines_(std::move(source), name_) {}

std::optional<SeenFrame> AscReader::next() {
  while (lines_.fill()) {
    std::optional<SeenFrame> seen = take_line();
    lines_.next_line(lines_.line_end());
    if (seen) {
      return seen;
    }
  }
  return std::nullopt;
}

std::optional<SeenFrame> AscReader::take_line() {
  const TextPlace line{name_, lines_.line_number(), lines_.line()};
  AscTokens tokens(line);
  if (tokens.take("base")) {
    format_.hexadecimal = tokens.take("hex");
    const bool sound = (format_.hexadecimal || tokens.take("dec")) && tokens.take("timestamps");
    format_.relative = tokens.take("relative");
    if (!sound || !(format_.relative || tokens.take("absolute"))) {
      tokens.demand(kAcceptedBase);
      tokens.refuse(kAcceptedBase);
    }
    return std::nullopt;
  }
  if (is_header(tokens)) {
    return std::nullopt;
  }
  const std::string_view word = tokens.demand(kAcceptedLine);
  if (!is_digit(word.front())) {
    tokens.refuse(kAcceptedLine);
  }
  const auto time_ns = time_of(word);
  if (!time_ns || (format_.relative && time_ns_ > std::int64_t{1} << 61)) {
    tokens.refuse(kAcceptedTime);
  }
  time_ns_ = format_.relative ? time_ns_ + *time_ns : *time_ns;
  std::optional<SeenFrame> seen = asc_event(tokens, format_.hexadecimal ? 16 : 10);
  if (seen) {
    seen->time_ns = time_ns_;
  }
  return seen;
}

}  // namespace host_sim::monitor
