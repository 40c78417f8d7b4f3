#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "firmware/protocol/schema/plan.hpp"
#include "host_sim/effects/counting_effect.hpp"
#include "host_sim/effects/life_effect.hpp"
#include "host_sim/effects/tension/tension_effect.hpp"
#include "host_sim/fmeca/table.hpp"

namespace host_sim::fmeca {
namespace {

namespace schema = protocol::schema;

constexpr std::string_view kEffect = "effect";

/// Divides at the first dot.
std::pair<std::string_view, std::string_view> divided(std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? std::pair{name, std::string_view()}
                                       : std::pair{name.substr(0, dot), name.substr(dot + 1)};
}

template <class Things, class Name>
std::string names_of(const Things& things, Name name_of) {
  std::vector<std::string_view> names;
  names.reserve(things.size());
  for (const auto& thing : things) {
    names.push_back(name_of(thing));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

Watch effect_of(std::string_view id) {
  Watch watch;
  const auto look_at = [&](std::string_view known, std::string_view term) {
    if (known == id) {
      watch.words = fmt::format("{} (diagnose)", term);
    }
    watch.accepted += fmt::format("{}{}", watch.accepted.empty() ? "" : ", ", known);
  };
  for (const effects::TensionEffect* const effect : effects::tension_effects()) {
    look_at(effect->id, effect->term);
  }
  for (const auto& effect : effects::life_effects()) {
    look_at(effect->id(), effect->term());
  }
  for (const effects::CountingEffect& effect : effects::kCountingEffects) {
    look_at(effect.id, effect.term);
  }
  watch.accepted = "effect. and one of " + watch.accepted;
  return watch;
}

Watch message_of(std::string_view message_name, std::string_view rest) {
  const auto message =
      std::ranges::find(schema::kMessages, message_name, &schema::MessageView::name);
  if (message == schema::kMessages.end()) {
    return {"", names_of(schema::kMessages, [](const auto& one) { return one.name; }) +
                    ", or effect.ID"};
  }
  const std::string on_bus = message->page ? fmt::format("page {} {}", *message->page, message_name)
                                           : std::string(message_name);
  if (rest.empty()) {
    return {fmt::format("{}: {}", on_bus,
                        message->comment.empty() ? message->frame->comment : message->comment),
            ""};
  }
  const auto [signal_name, value_name] = divided(rest);
  const auto signal = std::ranges::find(message->signals, signal_name, &schema::Signal::name);
  if (signal == message->signals.end()) {
    return {"", fmt::format("{}. and one of {}", message_name,
                            names_of(message->signals, [](const auto& one) { return one.name; }))};
  }
  if (rest.size() == signal_name.size()) {
    return {fmt::format("{}: {}", on_bus, signal->comment), ""};
  }
  const auto value = std::ranges::find(signal->values, value_name, &schema::ValueName::name);
  if (value == signal->values.end()) {
    return {"",
            signal->values.empty()
                ? fmt::format("{}.{}, which has no named values", message_name, signal_name)
                : fmt::format("{}.{}. and one of {}", message_name, signal_name,
                              names_of(signal->values, [](const auto& one) { return one.name; }))};
  }
  return {fmt::format("{}: {} {} (0x{:x})", on_bus, signal->name, value_name, value->value), ""};
}

}  // namespace

Watch what_is(std::string_view name) {
  const auto [first, rest] = divided(name);
  if (first.size() + 1 == name.size()) {
    return {"", "a name that does not end with a dot"};
  }
  return first == kEffect ? effect_of(rest) : message_of(first, rest);
}

}  // namespace host_sim::fmeca
