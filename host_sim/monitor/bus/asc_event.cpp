#include "host_sim/monitor/bus/asc_event.hpp"

#include <algorithm>

namespace host_sim::monitor {
namespace {

constexpr std::string_view kAcceptedId = "an identifier up to 7FF, or up to 1FFFFFFF with x";
constexpr std::string_view kAcceptedKind = "d and a length, or r";
constexpr std::string_view kAcceptedLength = "a length of 0 to 8 bytes";
constexpr std::string_view kAcceptedByte = "as many bytes as the length says";
constexpr std::string_view kAcceptedFd =
    "[name] BRS ESI DLC, a length of 0 to 64 bytes, and the bytes";
constexpr std::uint32_t kFdFlag = 1u << 12;  // EDL of the flags of a CANFD line

enum class Direction : std::uint8_t { on_bus, request, none };

Direction take_direction(AscWords& words) {
  if (words.take("rx") || words.take("tx")) {
    return Direction::on_bus;
  }
  return words.take("txrq") ? Direction::request : Direction::none;
}

void read_id(AscWords& words, int base, hal::CanFrame& frame) {
  std::string_view word = words.demand(kAcceptedId);
  frame.extended = word.ends_with('x') || word.ends_with('X');
  if (frame.extended) {
    word.remove_suffix(1);
  }
  const auto id = number_of(word, base);
  if (!id || *id > (frame.extended ? 0x1fff'ffffu : 0x7ffu)) {
    words.refuse(kAcceptedId);
  }
  frame.id = static_cast<std::uint32_t>(*id);
}

template <class Put>
void read_bytes(AscWords& words, int base, std::size_t length, Put put) {
  for (std::size_t i = 0; i < length; ++i) {
    put(i, static_cast<std::byte>(words.number(base, 0xff, kAcceptedByte)));
  }
}

void read_classic(AscWords& words, int base, SeenFrame& seen) {
  if (words.take("r")) {
    seen.remote_request = true;
    if (words.is_number(0, 16)) {
      seen.frame.length = static_cast<std::uint8_t>(words.number(16, 8, kAcceptedLength));
    }
    return;
  }
  if (!words.take("d")) {
    words.demand(kAcceptedKind);
    words.refuse(kAcceptedKind);
  }
  seen.frame.length = static_cast<std::uint8_t>(words.number(16, 8, kAcceptedLength));
  read_bytes(words, base, seen.frame.length,
             [&seen](std::size_t i, std::byte byte) { seen.frame.data[i] = byte; });
}

std::optional<SeenFrame> classic_event(AscWords& words, int base) {
  SeenFrame seen;
  if (words.take("errorframe")) {
    seen.error.emplace();
    return seen;
  }
  const bool has_direction = same_word(words.peek(1), "rx") || same_word(words.peek(1), "tx");
  if (!has_direction) {
    return std::nullopt;  // a statistic, a request to send, or another event of the channel
  }
  read_id(words, base, seen.frame);
  take_direction(words);
  read_classic(words, base, seen);
  return seen;
}

bool take_flag(AscWords& words) {
  return words.number(10, 1, kAcceptedFd) == 1;
}

/// The bits of a frame that was logged in the form of CAN FD; nothing where the line has none.
std::optional<std::uint32_t> flags_behind_data(const AscWords& words) {
  constexpr std::size_t kFlags = 2;  // behind the duration and the number of bits
  const auto flags = number_of(words.peek(kFlags), 16);
  return flags ? std::optional(static_cast<std::uint32_t>(*flags)) : std::nullopt;
}

std::optional<SeenFrame> flexible_event(AscWords& words, int base) {
  words.skip();  // the channel
  if (take_direction(words) != Direction::on_bus) {
    return std::nullopt;
  }
  SeenFrame seen;
  if (words.take("errorframe")) {
    seen.error.emplace();
    return seen;
  }
  read_id(words, base, seen.frame);
  if (words.peek() != "0" && words.peek() != "1") {
    words.demand(kAcceptedFd);  // the name of the message
  }
  seen.fd_flags = static_cast<std::uint8_t>(take_flag(words) ? 1 : 0);
  seen.fd_flags = static_cast<std::uint8_t>(seen.fd_flags | (take_flag(words) ? 2 : 0));
  words.number(16, 15, kAcceptedFd);
  const std::size_t length = words.number(10, 64, kAcceptedFd);
  seen.fd_data.resize(length);
  read_bytes(words, base, length,
             [&seen](std::size_t i, std::byte byte) { seen.fd_data[i] = byte; });
  const auto flags = flags_behind_data(words);
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
std::optional<SeenFrame> status_event(AscWords& words) {
  words.skip();  // the channel
  if (!words.take("status:chip") || !words.take("status")) {
    return std::nullopt;
  }
  SeenFrame seen;
  BusError error;
  error.bus_off =
      words.take("busoff") || (same_word(words.peek(), "bus") && same_word(words.peek(1), "off"));
  if (words.take("error")) {
    error.restarted = words.take("active");
    error.error_passive = words.take("passive");
    error.error_warning = words.take("warning");
  } else if (words.take("warning")) {
    error.error_warning = true;
  }
  seen.error = error;
  return seen;
}

}  // namespace

std::optional<SeenFrame> asc_event(AscWords& words, int base) {
  if (words.take("canfd")) {
    return flexible_event(words, base);
  }
  if (words.take("can")) {
    return status_event(words);
  }
  if (words.is_number(0, 10)) {
    words.skip();
    return classic_event(words, base);
  }
  return std::nullopt;
}

}  // namespace host_sim::monitor
