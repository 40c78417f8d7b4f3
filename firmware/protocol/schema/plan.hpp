#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "firmware/protocol/schema/page_layouts.hpp"
#include "firmware/protocol/schema/status_layouts.hpp"

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
/// itself does not compile: see checks.hpp.
namespace protocol::schema {

/// Version of this plan, told in detail::Identity.
inline constexpr std::uint8_t kSchemaVersion = 2;

template <class... Messages>
struct MessageList {};

using AllMessages =
    MessageList<Heartbeat, LifeStatus, detail::Identity, detail::Cycles, detail::DamageRate,
                detail::TendonDamage, detail::RainflowBin, detail::RemainingLife, detail::Storage,
                detail::Timing, detail::Bus, Emergency, Command>;

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

}  // namespace protocol::schema
