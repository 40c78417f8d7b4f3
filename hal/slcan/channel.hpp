#pragma once

#include <cstdint>
#include <string_view>

#include "hal/slcan/text.hpp"

namespace hal::slcan {

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
/// nodes of this kind are told apart by their CAN node id instead.
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
      return tell_flags(!closed, answer);
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

  constexpr Outcome tell_flags(bool allowed, Text& answer) {
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

}  // namespace hal::slcan
