#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "firmware/protocol/schema/plan.hpp"

namespace host_sim::monitor {

/// The name of a raw value; empty where it has none.
constexpr std::string_view value_name(const protocol::schema::Signal& signal, std::uint32_t raw) {
  for (const protocol::schema::ValueName& value : signal.values) {
    if (value.value == raw) {
      return value.name;
    }
  }
  return {};
}

/// The double nearest to raw times the factor of the signal.
inline double physical(const protocol::schema::Signal& signal, std::uint32_t raw) {
  double digits = 0;
  double divisor = 1;
  bool fraction = false;
  for (const char c : signal.factor) {
    if (c == '.') {
      fraction = true;
    } else {
      digits = 10 * digits + (c - '0');
      divisor *= fraction ? 10 : 1;
    }
  }
  return raw * digits / divisor;
}

/// A member as its signal names it: the name of its value, true or false, or the physical value.
template <class Member>
nlohmann::json field_json(const protocol::schema::Signal& signal, Member member) {
  if constexpr (std::is_same_v<Member, bool>) {
    return member;
  } else {
    const auto raw = static_cast<std::uint32_t>(member);
    const std::string_view name = value_name(signal, raw);
    if (!name.empty()) {
      return std::string(name);
    }
    if (signal.factor == "1") {
      return raw;
    }
    return physical(signal, raw);
  }
}

/// A message with the names of the frame plan, as in the DBC: {"Damage": 0.0123, ..}. The values
/// that stand for themselves or more are named once more: {.., "at_least": ["Damage"]}.
template <class Message>
nlohmann::json message_json(const Message& message) {
  nlohmann::json json = nlohmann::json::object();
  const auto put = [&](const auto& field) {
    json[std::string(field.signal.name)] = field_json(field.signal, message.*(field.member));
    if (is_at_least(field.signal, static_cast<std::uint32_t>(message.*(field.member)))) {
      json["at_least"].push_back(field.signal.name);
    }
  };
  std::apply([&](const auto&... fields) { (put(fields), ...); },
             protocol::schema::Layout<Message>::kFields);
  return json;
}

}  // namespace host_sim::monitor
