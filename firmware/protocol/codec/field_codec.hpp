#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include "firmware/protocol/schema/layout.hpp"

namespace protocol {

/// Takes one member of a message to its bits and back. All about it but the value is known when it
/// is compiled, so that no text of the schema reaches the target.
template <class Message, std::size_t kIndex>
class FieldCodec {
 public:
  static constexpr const schema::Signal& kSignal =
      std::get<kIndex>(schema::Layout<Message>::kFields).signal;

  /// The bits in their place. A value that is too wide stops at the largest.
  static constexpr std::uint64_t put(const Message& message) {
    const auto raw = static_cast<std::uint32_t>(message.*kMember);
    constexpr std::uint32_t kLargest = schema::largest(kSignal.bits);
    return std::uint64_t{raw < kLargest ? raw : kLargest} << kSignal.start_bit;
  }

  /// False, and nothing has happened, where the value has no meaning.
  static constexpr bool get(std::uint64_t word, Message& message) {
    const auto raw =
        static_cast<std::uint32_t>(word >> kSignal.start_bit) & schema::largest(kSignal.bits);
    if (!has_meaning(raw)) {
      return false;
    }
    message.*kMember = static_cast<Member>(raw);
    return true;
  }

 private:
  static constexpr auto kMember = std::get<kIndex>(schema::Layout<Message>::kFields).member;
  using Member = std::remove_cvref_t<decltype(std::declval<Message&>().*kMember)>;
  static_assert(std::is_unsigned_v<Member> || std::is_enum_v<Member>);
  static_assert(sizeof(Member) * 8 >= kSignal.bits, "the member does not hold the signal");
  static_assert(!kSignal.is_closed || !kSignal.values.empty(), "its values have no names");

  static constexpr bool has_meaning(std::uint32_t raw) {
    if constexpr (kSignal.is_closed) {
      return [raw]<std::size_t... kValues>(std::index_sequence<kValues...>) {
        return ((raw == std::integral_constant<std::uint32_t, kSignal.values[kValues].value>{}) ||
                ...);
      }
      (std::make_index_sequence<kSignal.values.size()>{});
    } else {
      return true;
    }
  }
};

}  // namespace protocol
