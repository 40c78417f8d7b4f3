#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include "firmware/protocol/schema/frame.hpp"

namespace protocol::schema {

/// A member of a message and the signal that carries it.
template <class Message, class Member>
struct Field {
  Member Message::*member;
  Signal signal;
};

/// Values of an enumeration are closed: receivers refuse those without a name.
template <class Message, class Member>
consteval Field<Message, Member> field(Member Message::*member, Signal signal) {
  signal.is_closed = std::is_enum_v<Member>;
  return {member, signal};
}

/// How a message lies in its frame. Specialised for each message with
///   kFrame    the Frame
///   kName     of the message: the frame's, or the page's
///   kComment  of the page; empty where there are no pages
///   kFields   a tuple of Field, one for each member
template <class Message>
struct Layout;

template <class Message>
inline constexpr std::size_t kFieldCount = std::tuple_size_v<decltype(Layout<Message>::kFields)>;

/// The signal of a member.
template <class Message, class Member>
constexpr Signal signal_of(Member Message::*member) {
  Signal found;
  std::apply(
      [&](const auto&... fields) {
        const auto look_at = [&]<class Other>(const Field<Message, Other>& field) {
          if constexpr (std::is_same_v<Member, Other>) {
            found = field.member == member ? field.signal : found;
          }
        };
        (look_at(fields), ...);
      },
      Layout<Message>::kFields);
  return found;
}

/// Whether the message is a page of its frame.
template <class Message>
inline constexpr bool kIsPage = requires {
  Message::kPage;
};

}  // namespace protocol::schema
