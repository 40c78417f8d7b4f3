#include "host_sim/monitor/fleet/words.hpp"

#include <fmt/format.h>

#include <span>

#include "firmware/protocol/schema/values.hpp"

namespace host_sim::monitor {
namespace {

template <class Enum>
std::string_view name_in(std::span<const protocol::schema::ValueName> names, Enum value) {
  for (const protocol::schema::ValueName& name : names) {
    if (name.value == static_cast<std::uint32_t>(value)) {
      return name.name;
    }
  }
  return "unknown";
}

}  // namespace

std::string_view name_of(protocol::LifeState state) {
  return name_in(protocol::schema::kLifeStates, state);
}
std::string_view name_of(protocol::Quality quality) {
  return name_in(protocol::schema::kQualities, quality);
}
std::string_view name_of(protocol::NmtState state) {
  return name_in(protocol::schema::kNmtStates, state);
}
std::string_view name_of(protocol::EmergencyCode code) {
  return name_in(protocol::schema::kEmergencyCodes, code);
}

std::string_view state_name(const NodeView& node) {
  return node.two_controllers ? "two_controllers" : name_of(node.life_state());
}

std::string percent_of(std::uint32_t ppb, const protocol::schema::Signal& signal) {
  constexpr std::uint32_t kPercent_ppb = 10'000'000;
  std::string text = fmt::format("{}{}.{:07}", is_at_least(signal, ppb) ? ">=" : "",
                                 ppb / kPercent_ppb, ppb % kPercent_ppb);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text;
}

}  // namespace host_sim::monitor
