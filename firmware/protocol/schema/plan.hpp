#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "firmware/protocol/schema/frames.hpp"
#include "firmware/protocol/schema/page_layouts.hpp"

/// The frame plan: the one place that says what lies where. The codec, the DBC files, the
/// JavaScript decoder and the table in firmware/protocol/README.md follow from it.
///
/// To add a signal to a message: give the struct in messages.hpp a member, and its Layout a field()
/// in bits that are free. Receivers refuse bits that they do not know, so count up kSchemaVersion;
/// so, too, where a value takes on another meaning.
/// To add a page: a struct with the next kPage in messages.hpp, its Layout in page_layouts.hpp, and
/// its name in AllMessages below.
/// To add a frame: a Frame in frames.hpp with a free base id and, if protected, an id_list of its
/// own; a struct, its Layout, its name in AllMessages and the frame in kFrames.
/// Then let protocol_generate write the table of firmware/protocol/README.md anew. What contradicts
/// itself does not compile: see plan_is_sound().
namespace protocol::schema {

/// Version of this plan, sent in detail::Identity.
inline constexpr std::uint8_t kSchemaVersion = 4;

template <class... Messages>
struct MessageList {};

using AllMessages =
    MessageList<Heartbeat, LifeStatus, detail::Identity, detail::Cycles, detail::DamageRate,
                detail::TendonDamage, detail::RainflowBin, detail::RemainingLife, detail::Storage,
                detail::Timing, detail::Bus, detail::ConditionalLife, detail::BreakRisk,
                detail::WireHistory, detail::Advice, Emergency, Command>;

/// A message without its type, for what writes about it.
struct MessageView {
  const Frame* frame = nullptr;
  std::optional<std::uint8_t> page = {};
  std::string_view name = {};
  std::string_view comment = {};
  std::span<const Signal> signals = {};
};

/// The signals of a message, those of its frame left out.
template <class Message>
inline constexpr auto kSignals = std::apply(
    [](const auto&... fields) { return std::array{fields.signal...}; }, Layout<Message>::kFields);

template <class Message>
constexpr std::optional<std::uint8_t> page_of() {
  if constexpr (kIsPage<Message>) {
    return Message::kPage;
  } else {
    return std::nullopt;
  }
}

template <class Message>
constexpr MessageView view_of() {
  return {.frame = &Layout<Message>::kFrame,
          .page = page_of<Message>(),
          .name = Layout<Message>::kName,
          .comment = Layout<Message>::kComment,
          .signals = kSignals<Message>};
}

template <class... Messages>
constexpr std::array<MessageView, sizeof...(Messages)> views_of(MessageList<Messages...>) {
  return {view_of<Messages>()...};
}

/// Every message, the pages of a frame one after the other.
inline constexpr auto kMessages = views_of(AllMessages{});

/// Every frame, once, in the order of AllMessages.
inline constexpr std::array<const Frame*, 5> kFrames{
    &kHeartbeatFrame, &kLifeStatusFrame, &kLifeDetailFrame, &kEmergencyFrame, &kCommandFrame};

// What a frame plan has to keep, as predicates that the plan is asserted to fulfil at the end.

/// A letter, then letters and digits; at most 32, which is what DBC readers take.
constexpr bool is_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return !name.empty() && name.size() <= 32 && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return is_letter(c) || is_digit(c); });
}

/// Of small letters, digits and underlines.
constexpr bool is_value_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// ASCII on one line, without what ends a text in a DBC file.
constexpr bool is_text(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return c >= ' ' && c <= '~' && c != '"' && c != ';' && c != '\\';
  });
}

constexpr bool is_decimal(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return (c >= '0' && c <= '9') || c == '.'; }) &&
         std::count(text.begin(), text.end(), '.') <= 1 && text.front() != '.' &&
         text.back() != '.';
}

/// The values fit into the signal, and no value and no name is there twice.
constexpr bool values_are_sound(const Signal& signal) {
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const ValueName& one = signal.values[i];
    if (one.value > largest(signal.bits) || !is_value_name(one.name)) {
      return false;
    }
    for (const ValueName& other : signal.values.subspan(i + 1)) {
      if (one.value == other.value || one.name == other.name) {
        return false;
      }
    }
  }
  return true;
}

constexpr bool is_sound(const Signal& signal) {
  return is_name(signal.name) && signal.bits >= 1 && signal.bits <= 32 &&
         signal.start_bit + signal.bits <= 64 && is_decimal(signal.factor) &&
         is_text(signal.unit) && is_text(signal.comment) && !signal.comment.empty() &&
         values_are_sound(signal);
}

/// The signals lie in the frame, beside each other and after the multiplexor.
constexpr bool lies_well(const MessageView& message) {
  std::uint64_t taken = header_mask(*message.frame);
  for (const Signal& signal : message.signals) {
    const bool before_page =
        message.frame->page && signal.start_bit < message.frame->page->start_bit;
    if (!is_sound(signal) || before_page || (taken & mask_of(signal)) != 0) {
      return false;
    }
    taken |= mask_of(signal);
  }
  return (taken & ~payload_mask(message.frame->length)) == 0;
}

/// A page number has a frame with pages, and only there, and the multiplexor holds it.
constexpr bool has_its_page(const MessageView& message) {
  const auto& multiplexor = message.frame->page;
  return message.page.has_value() == multiplexor.has_value() &&
         (!message.page || *message.page <= largest(multiplexor->bits));
}

/// No signal name is there twice in one frame, and no page.
constexpr bool are_distinct(const MessageView& one, const MessageView& other) {
  if (one.frame->base_id != other.frame->base_id) {
    return true;
  }
  return one.page != other.page &&
         std::none_of(one.signals.begin(), one.signals.end(), [&](const Signal& signal) {
           return std::any_of(other.signals.begin(), other.signals.end(),
                              [&](const Signal& twin) { return signal.name == twin.name; });
         });
}

constexpr bool is_sound(const Frame& frame) {
  return is_name(frame.name) && (frame.base_id & 0x7f) == 0 && frame.base_id <= 0x780 &&
         frame.length >= 1 && frame.length <= 8 && is_text(frame.sent) && is_text(frame.comment) &&
         (!frame.page || is_sound(*frame.page)) &&
         (!frame.integrity || frame.integrity->id_list < 4);
}

/// No identifier, no name and no list of data ids is there twice.
constexpr bool are_distinct(const Frame& one, const Frame& other) {
  const bool share_list =
      one.integrity && other.integrity && one.integrity->id_list == other.integrity->id_list;
  return one.base_id != other.base_id && one.name != other.name && !share_list;
}

constexpr bool plan_is_sound() {
  for (std::size_t i = 0; i < kFrames.size(); ++i) {
    if (!is_sound(*kFrames[i])) {
      return false;
    }
    for (std::size_t k = i + 1; k < kFrames.size(); ++k) {
      if (!are_distinct(*kFrames[i], *kFrames[k])) {
        return false;
      }
    }
  }
  for (std::size_t i = 0; i < kMessages.size(); ++i) {
    if (!is_text(kMessages[i].comment) || !lies_well(kMessages[i]) || !has_its_page(kMessages[i])) {
      return false;
    }
    for (std::size_t k = i + 1; k < kMessages.size(); ++k) {
      if (!are_distinct(kMessages[i], kMessages[k])) {
        return false;
      }
    }
  }
  return true;
}

static_assert(plan_is_sound());
static_assert(std::count_if(kMessages.begin(), kMessages.end(), [](const MessageView& message) {
                return message.page && *message.page < detail::kPages;
              }) == detail::kPages);

}  // namespace protocol::schema
