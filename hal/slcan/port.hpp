#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "hal/byte_stream.hpp"
#include "hal/can_port.hpp"
#include "hal/error.hpp"
#include "hal/slcan/line.hpp"

namespace hal::slcan {

/// Bytes on their way out, oldest first.
template <std::size_t kBytes>
class ByteQueue {
  static_assert(std::has_single_bit(kBytes));

 public:
  [[nodiscard]] constexpr std::size_t free() const { return kBytes - size_; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }

  /// @pre there is room
  constexpr void push(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) {
      bytes_[(first_ + size_++) % kBytes] = byte;
    }
  }
  /// The oldest bytes, as many as lie side by side.
  [[nodiscard]] constexpr std::span<const std::byte> front() const {
    return std::span(bytes_).subspan(first_, std::min(size_, kBytes - first_));
  }
  /// @pre count <= front().size()
  constexpr void pop(std::size_t count) {
    first_ = (first_ + count) % kBytes;
    size_ -= count;
  }

 private:
  std::array<std::byte, kBytes> bytes_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// What the host has made of the channel.
enum class Channel : std::uint8_t {
  closed,       ///< nothing leaves or enters
  listen_only,  ///< the host hears this node and says nothing
  open,
};

/// Flags of the answer to `F`.
struct StatusFlags {
  static constexpr std::uint8_t kTransmitFull = 1u << 1;
  static constexpr std::uint8_t kDataOverrun = 1u << 3;
};

/// The commands that are no frames. `V`: hardware and software version. `N`: serial number; all
/// nodes of this kind differ by their CAN node id instead.
///
///   Sn  bit rate 0 .. 8; the line has none, so it is only taken   closed
///   O   open                                                      closed
///   L   open, listen only                                         closed
///   C   close                                                     open
///   F   status flags since the last F                             open
///   V, N                                                          always
///   Z0  no timestamps; Z1 is refused                              closed
///
/// (CAN232 manual of LAWICEL, and slcand of can-utils: "C", "S8", "O".)
class Commands {
 public:
  constexpr explicit Commands(Channel channel) : channel_(channel) {}

  [[nodiscard]] constexpr Channel channel() const { return channel_; }
  constexpr void note(std::uint8_t flags) { flags_ = static_cast<std::uint8_t>(flags_ | flags); }

  /// What became of a command. Refused ones have changed nothing.
  enum class Outcome : std::uint8_t { obeyed, not_now, unknown };

  /// Obeys a line without its end and puts the answer together: a bell where it is refused.
  constexpr Outcome obey(std::string_view line, Text& answer) {
    const Outcome outcome = act(line, answer);
    answer.put(outcome == Outcome::obeyed ? kEnd : kBell);
    return outcome;
  }

 private:
  constexpr Outcome act(std::string_view line, Text& answer) {
    const bool closed = channel_ == Channel::closed;
    if (line == "O" || line == "L") {
      return change(closed, line == "O" ? Channel::open : Channel::listen_only);
    }
    if (line == "C") {
      return change(!closed, Channel::closed);
    }
    if (line == "Z0" || (line.size() == 2 && line[0] == 'S' && line[1] >= '0' && line[1] <= '8')) {
      return closed ? Outcome::obeyed : Outcome::not_now;
    }
    if (line == "F") {
      return report_flags(!closed, answer);
    }
    if (line == "V" || line == "N") {
      answer.put(line[0]);
      answer.put_hex(line[0] == 'V' ? kVersion : 0, 4);
      return Outcome::obeyed;
    }
    return Outcome::unknown;
  }

  constexpr Outcome change(bool allowed, Channel channel) {
    if (!allowed) {
      return Outcome::not_now;
    }
    channel_ = channel;
    return Outcome::obeyed;
  }

  constexpr Outcome report_flags(bool allowed, Text& answer) {
    if (!allowed) {
      return Outcome::not_now;
    }
    answer.put('F');
    answer.put_hex(flags_, 2);
    flags_ = 0;
    return Outcome::obeyed;
  }

  static constexpr std::uint32_t kVersion = 0x0001;

  Channel channel_;
  std::uint8_t flags_ = 0;
};

/// Lines that led to nothing, since the start. All stop at their highest value.
struct Refused {
  std::uint32_t malformed = 0;  ///< frames that make no sense, and unknown commands
  std::uint32_t too_long = 0;
  std::uint32_t not_open = 0;  ///< frames while the channel was not open
  std::uint32_t remote = 0;    ///< remote frames: accepted, and nobody answers them
};

/// A node on a serial line that speaks SLCAN, so that slcand turns the line into a SocketCAN
/// interface. The node is all there is on the bus: what it sends goes to the host, and what the
/// host transmits is what it receives.
///
/// state: off while the host keeps the channel closed, else active; only the host can change that,
/// so recover() of a closed channel answers off. receive_errors counts the
/// lines that were malformed or too long.
///
/// Each call moves bytes both ways as the line takes them, at most kQueue out and kBite in. A host
/// that does not read stops its own commands first, then send() answers full.
template <ByteStream Stream, std::size_t kQueue = 512>
class Port {
  static_assert(kQueue >= 4 * (kLongestLine + 1));

 public:
  /// Bytes that receive() looks at, at most.
  static constexpr std::size_t kBite = 128;

  explicit Port(Stream& stream, Channel channel = Channel::closed)
      : stream_(stream), commands_(channel) {}

  Error send(const CanFrame& frame) {
    move_out();
    if (commands_.channel() == Channel::closed) {
      return Error::off;
    }
    if (frame.length > frame.data.size() ||
        frame.id > (frame.extended ? kHighestExtendedId : kHighestStandardId)) {
      return Error::out_of_range;
    }
    const Text line = format({frame, false});
    // What is left over is for an answer.
    if (out_.free() < line.bytes().size() + kLongestLine) {
      commands_.note(StatusFlags::kTransmitFull);
      return Error::full;
    }
    out_.push(line.bytes());
    move_out();
    return Error::none;
  }

  std::optional<CanFrame> receive() {
    move_out();
    for (std::size_t i = 0; i < kBite && out_.free() > kLongestLine; ++i) {
      std::byte byte{};
      if (stream_.try_read(std::span(&byte, 1)) == 0) {
        break;
      }
      if (const auto frame = take(byte)) {
        move_out();
        return frame;
      }
    }
    move_out();
    return std::nullopt;
  }

  [[nodiscard]] CanStatus status() {
    CanStatus status;
    status.state = commands_.channel() == Channel::closed ? CanState::off : CanState::active;
    const std::uint64_t refused = std::uint64_t{refused_.malformed} + refused_.too_long;
    status.receive_errors = static_cast<std::uint8_t>(std::min<std::uint64_t>(refused, 255));
    return status;
  }

  Error recover() { return commands_.channel() == Channel::closed ? Error::off : Error::none; }

  [[nodiscard]] const Refused& refused() const { return refused_; }
  [[nodiscard]] Channel channel() const { return commands_.channel(); }

 private:
  std::optional<CanFrame> take(std::byte byte) {
    switch (reader_.take(byte)) {
      case LineReader::Event::none:
        break;
      case LineReader::Event::too_long:
        commands_.note(StatusFlags::kDataOverrun);
        refuse(refused_.too_long);
        break;
      case LineReader::Event::line:
        return take_line();
    }
    return std::nullopt;
  }

  std::optional<CanFrame> take_line() {
    const std::string_view line = reader_.line();
    if (line.empty()) {
      return std::nullopt;
    }
    if (!is_frame_line(line)) {
      Text answer;
      if (commands_.obey(line, answer) == Commands::Outcome::unknown) {
        count(refused_.malformed);
      }
      out_.push(answer.bytes());
      return std::nullopt;
    }
    const auto received = parse_frame(line);
    if (!received) {
      refuse(refused_.malformed);
      return std::nullopt;
    }
    if (commands_.channel() != Channel::open) {
      refuse(refused_.not_open);
      return std::nullopt;
    }
    Text sent;
    sent.put(received->frame.extended ? 'Z' : 'z');
    sent.put(kEnd);
    out_.push(sent.bytes());
    if (received->remote) {
      count(refused_.remote);
      return std::nullopt;
    }
    return received->frame;
  }

  void refuse(std::uint32_t& counter) {
    count(counter);
    Text bell;
    bell.put(kBell);
    out_.push(bell.bytes());
  }

  static void count(std::uint32_t& counter) {
    counter += counter < std::numeric_limits<std::uint32_t>::max() ? 1u : 0u;
  }

  void move_out() {
    while (!out_.empty()) {
      const std::size_t taken = stream_.try_write(out_.front());
      if (taken == 0) {
        return;
      }
      out_.pop(taken);
    }
  }

  Stream& stream_;
  Commands commands_;
  LineReader reader_;
  ByteQueue<kQueue> out_;
  Refused refused_;
};

}  // namespace hal::slcan
